#include "core/render/geometry_pass.hpp"

namespace momentscope {

void draw_transparent(const SceneBuffers& scene, GLuint target, Blending blending) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    if (blending != Blending::none) glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, blending == Blending::over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
    if (blending == Blending::greatest) glBlendEquation(GL_MAX);
    scene.draw(Surfaces::transparent);
    if (blending == Blending::greatest) glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
}

void draw_nearest(const SceneBuffers& scene, GLuint target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    scene.draw(Surfaces::transparent);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
}

void clear_colors(GLuint target, int color_count) {
    const float zero[4] = {0, 0, 0, 0};
    for (int i = 0; i < color_count; ++i) glClearNamedFramebufferfv(target, GL_COLOR, i, zero);
}

void leave_nothing_bound() {
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void define_access(ShaderVariant& variant, OrderedAccess access) {
    variant.defines[access == OrderedAccess::none        ? "BLENDING"
                    : access == OrderedAccess::interlock ? "INTERLOCK"
                                                         : "FRAMEBUFFER_FETCH"] = "1";
}

}  // namespace momentscope
