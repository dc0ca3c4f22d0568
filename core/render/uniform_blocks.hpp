// uniform_blocks.hpp -- shaders/passes/blocks.glsl in C++ (std140).
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

}  // namespace momentscope
