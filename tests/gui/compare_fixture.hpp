// compare_fixture.hpp -- a window whose picture is compared with a reference.
#pragma once
#include <array>
#include <vector>

#include "core/compare/difference.hpp"
#include "core/scene/scenes.hpp"
#include "tests/gui/gui_fixture.hpp"

namespace momentscope::test {

using Screen = std::vector<unsigned char>;

constexpr int BELOW_LABELS = 100;  // pixels from the top of the picture

class CompareTest : public GuiTest {
protected:
    /// The picture of the window's view with another technique, drawn separately.
    Image drawn_by(const char* technique) {
        const Scene scene = load_scene(state().scene, 1);
        Renderer renderer;
        renderer.set_scene(scene);
        renderer.render({workspace().camera(), measurement().picture_size, &require_technique(technique),
                         state().parameters});
        return renderer.read_picture();
    }
    std::vector<float> map_of(const char* reference, Metric metric) {
        return difference_map(drawn_by(reference), window_->renderer().read_picture(), metric);
    }

    /// The number of pixels that differ between these fractions of the picture's width, below the labels.
    long differing(const Screen& a, const Screen& b, float from, float to) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        const float width = rect.high.x - rect.low.x;
        long count = 0;
        for (int y = static_cast<int>(rect.low.y) + BELOW_LABELS; y < static_cast<int>(rect.high.y); ++y)
            for (int x = static_cast<int>(rect.low.x + from * width);
                 x < static_cast<int>(rect.low.x + to * width); ++x)
                count += color(a, x, y) == color(b, x, y) ? 0 : 1;
        return count;
    }
    std::array<int, 3> color(const Screen& screen, int x, int y) {
        const auto at = 4 * static_cast<std::size_t>(y * size_.x + x);
        return {screen[at], screen[at + 1], screen[at + 2]};
    }
    std::array<int, 3> color_of_pixel(const Screen& screen, glm::ivec2 pixel) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        return color(screen, static_cast<int>(rect.low.x) + pixel.x, static_cast<int>(rect.low.y) + pixel.y);
    }

    /// A region in the row of labels, and whether it differs.
    bool labels_differ(const Screen& a, const Screen& b, float from, float to) {
        const ui::Rect rect = workspace().widget_rects.at("scene");
        const float width = rect.high.x - rect.low.x;
        for (int y = static_cast<int>(rect.low.y) + 5; y < static_cast<int>(rect.low.y) + 30; ++y)
            for (int x = static_cast<int>(rect.low.x + from * width);
                 x < static_cast<int>(rect.low.x + to * width); ++x)
                if (color(a, x, y) != color(b, x, y)) return true;
        return false;
    }
    Screen flipped() {
        play("hold G");
        Screen result = screen();
        play("let G");
        return result;
    }
};

}  // namespace momentscope::test
