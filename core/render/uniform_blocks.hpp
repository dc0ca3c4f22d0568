// uniform_blocks.hpp -- in C++ what shaders read: the blocks of shaders/passes/blocks.glsl (std140), and the
// vertices of scene.vert.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace momentscope {

struct FrameBlock {
    glm::mat4 view;
    glm::mat4 projection;
    glm::vec4 depth_warp;
    glm::vec4 parameters;
    std::array<glm::vec4, 2> basis;
    glm::ivec4 picture;
};

/// shaders/passes/light_block.glsl (std140).
struct LightBlock {
    glm::mat4 view_from_eye;
    glm::mat4 projection;
    glm::vec4 position;
    glm::vec4 range;
    glm::vec4 reconstruction;
    glm::ivec4 radius;
    std::array<glm::vec4, 5> weights;
};

struct alignas(256) ObjectBlock {  // 256: the largest offset alignment that OpenGL lets a driver require
    glm::mat4 model;
    glm::vec4 color_opacity;
    glm::uvec4 draw;
    glm::vec4 absorbance;
};

struct Vertex {
    glm::vec3 position, normal;
    glm::vec2 texture_coordinate;
};

}  // namespace momentscope
