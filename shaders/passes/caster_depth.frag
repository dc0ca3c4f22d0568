// caster_depth.frag -- the depth of the nearest opaque caster, linear over the depth range. In this pass the light is the eye.
#include "passes/blocks.glsl"
INVARIANT_IN vec3 eye_position;
#include "passes/transparent_fragment.glsl"

layout(location = 0) out float depth;

void main()
{
    depth = fragment_depth();
}
