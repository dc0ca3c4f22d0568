#include "core/render/uncertainty_map.hpp"

#include <algorithm>

#include "core/gl/texture.hpp"
#include "core/render/geometry_pass.hpp"

namespace momentscope {

UncertaintyMap::UncertaintyMap(glm::ivec2 size, GLuint depth) : sums_(make_texture(GL_R32F, size)) {
    target_ = make_framebuffer({sums_}, depth);
}

std::vector<float> UncertaintyMap::draw(const DrawnPicture& picture) {
    const glm::ivec2 size = picture.view.size;
    const float zero[4] = {0, 0, 0, 0};
    glClearNamedFramebufferfv(target_, GL_COLOR, 0, zero);
    picture.bind();
    glBindFramebuffer(GL_FRAMEBUFFER, target_);
    if (!picture.transparency.draw_diagnosis(picture.input, Diagnosis::uncertainty)) return {};
    leave_nothing_bound();
    std::vector<float> sums(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    glGetTextureImage(sums_, 0, GL_RED, GL_FLOAT, static_cast<GLsizei>(sums.size() * sizeof(float)),
                      sums.data());
    check_gl("measuring what the bounds leave open");
    for (int y = 0; y < size.y / 2; ++y)  // the first row in GL is the lowest
        std::swap_ranges(sums.begin() + y * size.x, sums.begin() + (y + 1) * size.x,
                         sums.end() - (y + 1) * size.x);
    return sums;
}

}  // namespace momentscope
