// light_probe.frag -- what the shading of the nearest opaque surface reads of the light: the share of the filter region behind
// opaque casters, T of the transparent ones, depth seen from the light (2 outside of the map), and view depth.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/opaque_receiver.glsl"

layout(location = 0) out vec4 probe;

void main()
{
    ShadowMapPosition place = light_place(eye_position);
    probe = place.within ? vec4(opaque_shadow(place), transparent_light(place, receiver_absorbance()), place.depth, -eye_position.z)
                         : vec4(0.0, 1.0, 2.0, -eye_position.z);
}
