// ends.frag -- the pass before the first one, for moments in the pixel's own interval: the ends of each ray, by MAX blending.
#include "passes/blocks.glsl"
in vec3 eye_position;
#include "passes/transparent_fragment.glsl"
#include "passes/pixel_ends.glsl"

layout(early_fragment_tests) in;

layout(location = 0) out vec4 pixel_ends;

void main()
{
    pixel_ends = ends_texel(fragment_ends(fragment_depth(), fragment_absorbance()));
}
