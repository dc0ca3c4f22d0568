// transparency.hpp -- what the renderer asks of every technique, and what it gives.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/gl/gl_info.hpp"
#include "core/gl/handle.hpp"
#include "core/gl/program.hpp"
#include "core/render/scene_buffers.hpp"
#include "core/render/shader_lighting.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// What all passes of one picture share. The Frame block is bound, the viewport covers the size, and so are
/// the light's maps where there are shadows.
struct PassInput {
    ProgramCache& programs;
    const SceneBuffers& scene;
    glm::ivec2 size;
    GLuint opaque_color;
    GLuint depth;  // of the opaque surfaces; tested, never written
    const ResolvedParameters& parameters;
    const ShaderLighting* lighting = nullptr;  // how fragments are lit; null: by no light of the scene

    /// The variant of a geometry pass that is drawn often: without what the scene does not need.
    ShaderVariant lean(ShaderVariant variant) const {
        if (!scene.has_alpha_maps()) variant.defines["NO_ALPHA_MAPS"] = "1";
        return variant;
    }

    /// The variant of a pass that shades fragments.
    ShaderVariant lit(ShaderVariant variant) const {
        if (lighting != nullptr) add_lighting(variant, *lighting);
        return variant;
    }
};

/// The passes of one technique at one picture size. Each function draws one stage and leaves no GL state
/// behind but bindings; the renderer calls a stage again only when its input changed.
class Transparency {
public:
    virtual ~Transparency() = default;

    /// First pass: what the technique must know before it can weigh colours.
    virtual void draw_moments(const PassInput& input) = 0;

    /// Second pass: weighted colours.
    virtual void draw_color(const PassInput& input) = 0;

    /// Transparent over opaque, into the bound framebuffer of one RGBA target.
    virtual void draw_composite(const PassInput& input) = 0;

    /// Binds what capture.frag WITH_TRANSMITTANCE reads, and returns its variant. nullopt when the technique
    /// has no such thing.
    virtual std::optional<ShaderVariant> bind_for_capture(const ResolvedParameters&) const { return {}; }

    /// What the first pass stored for the pixels of a rectangle, counted from the lower left, as the texture
    /// units give it. Empty when the technique has no moments.
    virtual std::vector<MomentVector> read_moments(glm::ivec2 /*corner*/, glm::ivec2 /*extent*/) const {
        return {};
    }

    /// Where the first pass is drawn, if not at the resolution of the picture.
    struct LowTarget {
        glm::ivec2 size;
        GLuint depth;  // of the opaque surfaces there
    };
    virtual std::optional<LowTarget> low_target() const { return {}; }

    /// Counts failed and clamped reconstructions into the bound two-channel target, additively. False when
    /// the technique reconstructs nothing.
    virtual bool draw_failures(const PassInput&) { return false; }
};

/// The passes of a technique; `depth` is the texture that its framebuffers test. Throws Error when GL lacks
/// what it needs.
std::unique_ptr<Transparency> make_transparency(const Technique& technique, glm::ivec2 size, GLuint depth,
                                                OrderedAccess access);

/// Why a GL with that access cannot draw a technique, as a sentence; empty when it can.
std::string why_unavailable(const Technique& technique, OrderedAccess access);

/// Draws fullscreen.vert's triangle with the program in use.
void draw_fullscreen();

}  // namespace momentscope
