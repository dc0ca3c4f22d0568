// caster_depth.frag -- depth of the nearest opaque caster, linear between the ends of the depth range. The eye of this pass is the
// light.
#include "passes/blocks.glsl"
in vec3 eye_position;
#include "passes/transparent_fragment.glsl"

layout(location = 0) out float depth;

void main()
{
    depth = fragment_depth();
}
