#include "core/gl/draw_state.hpp"

namespace momentscope {

namespace {

void enable(GLenum what, bool on) {
    if (on)
        glEnable(what);
    else
        glDisable(what);
}

GLenum comparison(DepthTest test) {
    switch (test) {
        case DepthTest::nearer_or_equal:
            return GL_LEQUAL;
        case DepthTest::equal:
            return GL_EQUAL;
        case DepthTest::always:
            return GL_ALWAYS;
        case DepthTest::off:
        case DepthTest::nearer:
            break;
    }
    return GL_LESS;
}

void set_blending(const DrawState& state) {
    enable(GL_BLEND, state.blending != Blending::none);
    switch (state.blending) {
        case Blending::over:
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blending::under:
            glBlendFuncSeparate(GL_DST_ALPHA, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blending::none:
        case Blending::add:
        case Blending::greatest:
            glBlendFunc(GL_ONE, GL_ONE);
    }
    glBlendEquation(state.blending == Blending::greatest ? GL_MAX : GL_FUNC_ADD);
    if (state.greatest_target) glBlendEquationi(*state.greatest_target, GL_MAX);
}

}  // namespace

void set_draw_state(const DrawState& state) {
    enable(GL_DEPTH_TEST, state.depth != DepthTest::off);
    glDepthFunc(comparison(state.depth));
    glDepthMask(state.writes_depth ? GL_TRUE : GL_FALSE);
    set_blending(state);
    enable(GL_SCISSOR_TEST, state.scissor.has_value());
    if (state.scissor)
        glScissor(state.scissor->corner.x, state.scissor->corner.y, state.scissor->extent.x,
                  state.scissor->extent.y);
    enable(GL_STENCIL_TEST, state.passing_count.has_value());
    if (state.passing_count) {
        glStencilFunc(GL_EQUAL, static_cast<GLint>(*state.passing_count), 0xff);
        glStencilOp(GL_INCR, GL_INCR, GL_INCR);
    }
    glDisable(GL_CULL_FACE);
}

void set_viewport(glm::ivec2 size) {
    glViewport(0, 0, size.x, size.y);
}

}  // namespace momentscope
