#include "core/render/sorted_passes.hpp"

#include <fmt/format.h>

#include "core/gl/draw_state.hpp"
#include "core/gl/framebuffer.hpp"
#include "core/gl/vertex_array.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr std::size_t LIST_CAPACITY = 2'500'000;  // 120 MB, or what this GL allows in one buffer

std::size_t megabytes(std::size_t fragments) {
    return fragments * sizeof(FragmentNode) / 1'000'000;
}

}  // namespace

SortedPasses::SortedPasses(glm::ivec2 size, GLuint depth, const Capabilities& gl)
    : list_(size, LIST_CAPACITY, depth, gl) {}

void SortedPasses::draw_composite(const PassInput& input, GLuint target) {
    int rows = input.size.y;
    for (int y = 0; y < input.size.y;) {
        rows = std::min(rows, input.size.y - y);
        const TexelRect band = {{0, y}, {input.size.x, rows}};
        const std::size_t count = list_.append(input, input.lit({}), band);
        if (count > list_.capacity()) {
            if (rows == 1)
                throw Error(fmt::format(
                    "One row of the picture has {} transparent fragments ({} MB), more than the {} "
                    "({} MB) that sorted can hold; use a smaller --size.",
                    count, megabytes(count), list_.capacity(), megabytes(list_.capacity())));
            rows = (rows + 1) / 2;
            continue;
        }
        set_draw_state({.scissor = band});
        bind_framebuffer(target);
        use_program(input.programs.get("passes/fullscreen.vert", "passes/sorted.frag"));
        bind_texture(0, input.opaque_color);
        list_.bind();
        draw_fullscreen();
        y += rows;
    }
}

}  // namespace momentscope
