// scene.vert -- the vertex shader of every geometry pass. Its outputs are invariant, so a fragment has the same bits in every pass.
#include "passes/blocks.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 map_place;

invariant gl_Position;
invariant out vec3 eye_position;
invariant out vec3 eye_normal;
invariant out vec3 object_position;
invariant out vec2 texture_coordinate;

void main()
{
    vec4 eye = frame.view * (object.model * vec4(position, 1.0));
    object_position = position;
    eye_position = eye.xyz;
    texture_coordinate = map_place;
    eye_normal = mat3(frame.view) * (mat3(object.model) * normal);
    gl_Position = frame.projection * eye;
}
