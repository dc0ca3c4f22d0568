#include "core/render/failure_marks.hpp"

#include <vector>

#include "core/gl/vertex_array.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

FailureMarks::FailureMarks(glm::ivec2 size, GLuint depth)
    : counts_(make_texture(GL_RG16F, size)), color_(make_texture(GL_RGBA8, size)) {
    target_ = make_framebuffer({counts_}, depth);
    color_target_ = make_framebuffer({color_}, 0);
}

std::optional<FailureCounts> FailureMarks::draw(const DrawnPicture& picture) {
    clear_color(target_, 0, glm::vec4(0));
    picture.bind();
    if (!picture.transparency.draw_diagnosis(picture.input, Diagnosis::failures, target_))
        return std::nullopt;
    set_draw_state({});
    bind_framebuffer(color_target_);
    use_program(picture.input.programs.get("passes/fullscreen.vert", "passes/failure_colors.frag"));
    bind_texture(0, counts_);
    draw_fullscreen();
    leave_nothing_bound();
    const std::vector<float> counts = read_texture(counts_, {{0, 0}, picture.view.size}, 2);
    check_gl("marking failed reconstructions");
    FailureCounts total;
    const glm::ivec2 size = picture.view.size;
    for (int y = size.y - 1; y >= 0; --y)  // the first row in GL is the lowest
        for (int x = 0; x < size.x; ++x) {
            const auto at = 2 * static_cast<std::size_t>(y * size.x + x);
            if (counts[at] > 0.5f)
                total.failed_pixels.emplace_back(x, size.y - 1 - y);
            else if (counts[at + 1] > 0.5f)
                ++total.clamped;
        }
    total.failed = static_cast<long>(total.failed_pixels.size());
    return total;
}

}  // namespace momentscope
