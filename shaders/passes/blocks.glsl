// blocks.glsl -- the uniform blocks that all passes read. core/render/uniform_blocks.hpp is the same in C++.

layout(std140, binding = 0) uniform Frame
{
    mat4 view;
    mat4 projection;
    vec4 depth_warp;      // origin and scale of DepthWarpFactors (shared/fragment.glsl); near plane; far plane
    vec4 parameters;      // beta; alpha; renormalise (0 or 1)
    vec4 basis[2];        // StoredBasis of the technique
    ivec4 picture;        // width; height; is the depth warp linear (0 or 1)?
} frame;

layout(std140, binding = 1) uniform Object
{
    mat4 model;
    vec4 color_opacity;
    uvec4 draw;           // index of the draw call in submission order; index of the object
    vec4 absorbance;      // x: absorbance of the opacity, for scenes without alpha maps
} object;
