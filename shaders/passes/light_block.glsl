// light_block.glsl -- what the CPU tells passes about the light; core/render/uniform_blocks.hpp is the same in C++.

layout(std140, binding = 2) uniform Light
{
    mat4 view_from_eye;    // the eye's space to the light's
    mat4 projection;
    vec4 position;         // of the light in the eye's space
    vec4 range;            // origin and scale of the linear depth (shared/fragment.glsl); texels of a side of the maps
    vec4 reconstruction;   // beta; theta, or epsilon of nested orders; alpha
    ivec4 radius;          // of the filter in texels
    vec4 weights[5];       // of its 2 radius + 1 texels
} light;
