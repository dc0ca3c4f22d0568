// peel_depth.frag -- the depths of a layer of depth peeling that keeps all fragments at one depth. Of all fragments behind the previous
// layer, the depth test keeps the nearest.
layout(binding = 0) uniform sampler2D previous_depth;   // window depth of the previous layer; 0 for the first layer

void main()
{
    if (gl_FragCoord.z <= texelFetch(previous_depth, ivec2(gl_FragCoord.xy), 0).x) discard;
}
