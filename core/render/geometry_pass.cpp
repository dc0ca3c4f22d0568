#include "core/render/geometry_pass.hpp"

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

void define_access(ShaderVariant& variant, OrderedAccess access) {
    variant.defines[access == OrderedAccess::none        ? "BLENDING"
                    : access == OrderedAccess::interlock ? "INTERLOCK"
                                                         : "FRAMEBUFFER_FETCH"] = "1";
}

}  // namespace momentscope
