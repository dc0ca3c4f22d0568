// farthest_depth.frag -- the window depth at a lower resolution. A pixel gets the greatest depth of all pixels that it covers, so
// that no transparent fragment is lost at an edge (Sharpe 2018, Section 4.1).
layout(binding = 0) uniform sampler2D depth_texture;
uniform ivec2 low_size;

void main()
{
    ivec2 size = textureSize(depth_texture, 0);
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 first = pixel * size / low_size;
    ivec2 end = min(((pixel + 1) * size + low_size - 1) / low_size, size);
    float farthest = 0.0;
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) farthest = max(farthest, texelFetch(depth_texture, ivec2(x, y), 0).x);
    gl_FragDepth = farthest;
}
