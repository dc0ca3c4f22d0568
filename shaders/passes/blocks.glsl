// blocks.glsl -- what the CPU tells all passes; core/render/uniform_blocks.hpp is the same in C++.

layout(std140, binding = 0) uniform Frame
{
    mat4 view;
    mat4 projection;
    vec4 depth_warp;      // log_z_min, scale of shared/fragment.glsl; near and far plane
    vec4 parameters;      // beta, theta, alpha, renormalise (0 or 1)
} frame;

layout(std140, binding = 1) uniform Object
{
    mat4 model;
    vec4 color_opacity;
    uvec4 draw;           // x: index of the draw call
} object;
