#include "core/render/sorted_passes.hpp"

#include <fmt/format.h>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

constexpr std::size_t LIST_CAPACITY = 2'500'000;  // 120 MB, or what this GL allows in one buffer

std::size_t megabytes(std::size_t fragments) {
    return fragments * sizeof(FragmentNode) / 1'000'000;
}

}  // namespace

SortedPasses::SortedPasses(glm::ivec2 size, GLuint depth) : list_(size, LIST_CAPACITY, depth) {}

void SortedPasses::draw_composite(const PassInput& input) {
    GLint target = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    const GLuint capture_program =
        input.programs.get("passes/scene.vert", "passes/capture.frag", input.lit({}));
    int rows = input.size.y;
    for (int y = 0; y < input.size.y;) {
        rows = std::min(rows, input.size.y - y);
        const std::size_t count = list_.capture(input, capture_program, {0, y}, {input.size.x, rows});
        if (count > list_.capacity()) {
            if (rows == 1)
                throw Error(fmt::format(
                    "One row of the picture has {} transparent fragments ({} MB), more than the {} "
                    "({} MB) that sorted can hold; use a smaller --size.",
                    count, megabytes(count), list_.capacity(), megabytes(list_.capacity())));
            rows = (rows + 1) / 2;
            continue;
        }
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target));
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, y, input.size.x, rows);
        glUseProgram(input.programs.get("passes/fullscreen.vert", "passes/sorted.frag"));
        glBindTextureUnit(0, input.opaque_color);
        list_.bind();
        draw_fullscreen();
        glDisable(GL_SCISSOR_TEST);
        y += rows;
    }
}

}  // namespace momentscope
