// shading.glsl -- two-sided Blinn-Phong shading with one light, which is enough to show form and colour. The light stands beside
// the camera or, with SHADOWS, in the scene.

INVARIANT_IN vec3 eye_position;
INVARIANT_IN vec3 eye_normal;
#ifdef SHADOWS
#include "passes/light.glsl"

/// The absorbance of what receives the light, if it casts shadows, too; 0 if it is opaque. Passes of transparent fragments and
/// opaque_receiver.glsl define it.
float receiver_absorbance();
#endif

vec3 shaded(vec3 albedo)
{
    vec3 to_eye = normalize(-eye_position);
    vec3 n = normalize(eye_normal);
    n = dot(n, to_eye) < 0.0 ? -n : n;
#ifdef SHADOWS
    vec3 to_light = normalize(light.position.xyz - eye_position);
    float visibility = light_visibility(eye_position, receiver_absorbance());
#else
    vec3 to_light = normalize(vec3(-0.4, 0.7, 0.6));
    float visibility = 1.0;
#endif
    float diffuse = visibility * max(dot(n, to_light), 0.0);
    float specular = visibility * pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 40.0);
    return albedo * (0.35 + 0.65 * diffuse) + vec3(0.12 * specular);
}
