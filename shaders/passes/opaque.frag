// opaque.frag -- shades opaque surfaces. This pass comes before all transparent ones.
#include "passes/blocks.glsl"
#include "passes/shading.glsl"
#include "passes/opaque_receiver.glsl"

layout(location = 0) out vec4 color;

void main()
{
    color = vec4(shaded(object.color_opacity.rgb), 1.0);
}
