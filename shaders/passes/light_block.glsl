// light_block.glsl -- the uniform block of the light. core/render/uniform_blocks.hpp is the same in C++.

layout(std140, binding = 2) uniform Light
{
    mat4 view_from_eye;    // from eye space to light space
    mat4 projection;
    vec4 position;         // position of the light in eye space
    vec4 range;            // origin and scale of the linear depth (shared/fragment.glsl); texels along a side of the maps
    vec4 reconstruction;   // beta; theta, or epsilon for nested orders; alpha
    ivec4 radius;          // radius of the filter in texels
    vec4 weights[5];       // weights of the 2 radius + 1 texels of the filter
} light;
