#include "core/compare/false_color.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace momentscope {

Image false_color(std::span<const float> values, int width, int height, float full_scale) {
    const OIIO::ImageSpec spec(width, height, 1, OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf source(spec);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float share = values[static_cast<std::size_t>(y * width + x)] / full_scale;
            source.setpixel(x, y, &share, 1);
        }
    const OIIO::ImageBuf colored = OIIO::ImageBufAlgo::color_map(source, 0, "magma");
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float srgb[3] = {};  // the map is meant for the screen as it is
            colored.getpixel(x, y, srgb, 3);
            image.at(x, y) =
                glm::vec4(linear_from_srgb(srgb[0]), linear_from_srgb(srgb[1]), linear_from_srgb(srgb[2]), 1);
        }
    return image;
}

}  // namespace momentscope
