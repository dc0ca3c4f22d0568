// uniform_blocks.hpp -- what shaders read in C++: shaders/passes/blocks.glsl (std140), and the vertices of
// scene.vert.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace momentscope {

struct FrameBlock {
    glm::mat4 view;
    glm::mat4 projection;
    glm::vec4 depth_warp;
    glm::vec4 parameters;
    glm::ivec4 picture;
};

struct alignas(256)
    ObjectBlock {  // 256: the greatest offset alignment that OpenGL allows a driver to ask for
    glm::mat4 model;
    glm::vec4 color_opacity;
    glm::uvec4 draw;
};

struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 texture_coordinate;
};

}  // namespace momentscope
