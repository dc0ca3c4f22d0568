#include "core/render/uncertainty_map.hpp"

#include <algorithm>

#include "core/render/geometry_pass.hpp"

namespace momentscope {

UncertaintyMap::UncertaintyMap(glm::ivec2 size, GLuint depth) : sums_(make_texture(GL_R32F, size)) {
    target_ = make_framebuffer({sums_}, depth);
}

std::vector<float> UncertaintyMap::draw(const DrawnPicture& picture) {
    const glm::ivec2 size = picture.view.size;
    clear_color(target_, 0, glm::vec4(0));
    picture.bind();
    if (!picture.transparency.draw_diagnosis(picture.input, Diagnosis::uncertainty, target_)) return {};
    leave_nothing_bound();
    std::vector<float> sums = read_texture(sums_, {{0, 0}, size}, 1);
    check_gl("measuring what the bounds leave open");
    for (int y = 0; y < size.y / 2; ++y)  // the first row in GL is the lowest
        std::swap_ranges(sums.begin() + y * size.x, sums.begin() + (y + 1) * size.x,
                         sums.end() - (y + 1) * size.x);
    return sums;
}

}  // namespace momentscope
