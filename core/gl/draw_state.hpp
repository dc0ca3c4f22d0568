// draw_state.hpp -- how fragments are tested and written, as one value.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/gl/texture.hpp"

namespace momentscope {

/// Which fragments pass: all, or those whose depth compares so with the stored depth.
enum class DepthTest { off, nearer, nearer_or_equal, equal, always };

/// How the output of a fragment is written: it replaces the stored value, is added to it, is composited over
/// it, is stored if it is greater, or is composited under it. With `under` the stored alpha is the
/// transmittance in front.
enum class Blending { none, add, over, greatest, under };

struct DrawState {
    DepthTest depth = DepthTest::off;
    bool writes_depth = true;  // of fragments that pass; only with a test
    Blending blending = Blending::none;
    std::optional<GLuint> greatest_target = {};  // the target that blends with `greatest` instead; OpenGL 4.0
    std::optional<TexelRect> scissor = {};       // nothing is drawn outside

    /// The stencil counts the fragments of each pixel, and only those pass before which it has counted this
    /// many.
    std::optional<std::uint32_t> passing_count = {};
};

/// Sets the whole state for everything that is drawn afterwards. Clearing sets another.
void set_draw_state(const DrawState& state);

/// Draws to the pixels from (0, 0) on.
void set_viewport(glm::ivec2 size);

}  // namespace momentscope
