// shading.glsl -- two-sided Blinn-Phong under one light beside the camera: enough to judge form and colour.

in vec3 eye_position;
in vec3 eye_normal;

vec3 shaded(vec3 albedo)
{
    vec3 to_eye = normalize(-eye_position);
    vec3 n = normalize(eye_normal);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    vec3 to_light = normalize(vec3(-0.4, 0.7, 0.6));
    float diffuse = max(dot(n, to_light), 0.0);
    float specular = pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 40.0);
    return albedo * (0.35 + 0.65 * diffuse) + vec3(0.12 * specular);
}
