#include "core/render/failure_marks.hpp"

#include <vector>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

FailureMarks::FailureMarks(glm::ivec2 size, GLuint depth)
    : counts_(make_texture(GL_RG16F, size)), color_(make_texture(GL_RGBA8, size)) {
    target_ = make_framebuffer({counts_}, depth);
    color_target_ = make_framebuffer({color_}, 0);
}

std::optional<FailureCounts> FailureMarks::draw(const DrawnPicture& picture) {
    const glm::ivec2 size = picture.view.size;
    const float zero[4] = {0, 0, 0, 0};
    glClearNamedFramebufferfv(target_, GL_COLOR, 0, zero);
    picture.bind();
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    if (!picture.transparency.draw_diagnosis(picture.input, Diagnosis::failures)) return std::nullopt;
    glBindFramebuffer(GL_FRAMEBUFFER, color_target_);
    glUseProgram(picture.input.programs.get("passes/fullscreen.vert", "passes/failure_colors.frag"));
    glBindTextureUnit(0, counts_);
    draw_fullscreen();
    leave_nothing_bound();
    std::vector<glm::vec2> counts(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glGetTextureImage(counts_, 0, GL_RG, GL_FLOAT, static_cast<GLsizei>(counts.size() * sizeof(glm::vec2)),
                      counts.data());
    check_gl("marking failed reconstructions");
    FailureCounts total;
    for (const glm::vec2& count : counts) {
        if (count.x > 0.5f)
            ++total.failed;
        else if (count.y > 0.5f)
            ++total.clamped;
    }
    return total;
}

}  // namespace momentscope
