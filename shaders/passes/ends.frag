// ends.frag -- the ends of each ray, by MAX blending. It comes before the first pass if that pass needs the ends, or cannot blend
// them in another way than the moments.
#include "passes/blocks.glsl"
INVARIANT_IN vec3 eye_position;
#include "passes/transparent_fragment.glsl"
#include "passes/pixel_ends.glsl"

EARLY_TESTS

layout(location = 0) out vec4 pixel_ends;

void main()
{
    pixel_ends = ends_texel(fragment_ends(fragment_depth(), fragment_absorbance()));
}
