#include "core/render/geometry_pass.hpp"

#include <algorithm>
#include <string>

namespace momentscope {

void draw_transparent(const SceneBuffers& scene, GLuint target, DrawState state) {
    state.depth = DepthTest::nearer;
    state.writes_depth = false;
    set_draw_state(state);
    bind_framebuffer(target);
    scene.draw(Surfaces::transparent);
}

void draw_nearest(const SceneBuffers& scene, GLuint target) {
    set_draw_state({.depth = DepthTest::nearer_or_equal});
    bind_framebuffer(target);
    scene.draw(Surfaces::transparent);
}

void leave_nothing_bound() {
    use_program(0);
    bind_framebuffer(0);
}

std::vector<GlFramebuffer> make_group_framebuffers(const std::vector<GlTexture>& colors, GLuint depth,
                                                   int most) {
    const auto group = static_cast<std::size_t>(most);
    std::vector<GlFramebuffer> framebuffers;
    for (std::size_t first = 0; first < colors.size(); first += group) {
        const std::size_t end = std::min(first + group, colors.size());
        framebuffers.push_back(
            make_framebuffer(std::vector<GLuint>(colors.begin() + static_cast<std::ptrdiff_t>(first),
                                                 colors.begin() + static_cast<std::ptrdiff_t>(end)),
                             depth));
    }
    return framebuffers;
}

void define_group(ShaderVariant& variant, std::size_t group, std::size_t count, int most) {
    const auto size = static_cast<std::size_t>(most);
    if (count <= size) return;
    variant.defines["FIRST_TEXEL"] = std::to_string(group * size);
    variant.defines["WRITTEN_TEXELS"] = std::to_string(std::min(size, count - group * size));
}

void define_access(ShaderVariant& variant, OrderedAccess access) {
    variant.defines[access == OrderedAccess::none        ? "BLENDING"
                    : access == OrderedAccess::interlock ? "INTERLOCK"
                                                         : "FRAMEBUFFER_FETCH"] = "1";
}

}  // namespace momentscope
