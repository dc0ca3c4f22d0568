// blocks.glsl -- what the CPU tells all passes; core/render/uniform_blocks.hpp is the same in C++.

layout(std140, binding = 0) uniform Frame
{
    mat4 view;
    mat4 projection;
    vec4 depth_warp;      // origin, scale of shared/fragment.glsl; near and far plane
    vec4 parameters;      // beta; alpha; renormalise (0 or 1)
    vec4 basis[2];        // the technique's StoredBasis
    ivec4 picture;        // width, height; is depth linear (0 or 1)?
} frame;

layout(std140, binding = 1) uniform Object
{
    mat4 model;
    vec4 color_opacity;
    uvec4 draw;           // index of the draw call in the order of submission, index of the object
    vec4 absorbance;      // of the opacity in x, for scenes without alpha maps
} object;
