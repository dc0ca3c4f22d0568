// transparency.hpp -- the interface between the renderer and the passes of a technique.
#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/gl/capabilities.hpp"
#include "core/gl/handle.hpp"
#include "core/gl/program.hpp"
#include "core/gl/texture.hpp"
#include "core/render/scene_buffers.hpp"
#include "core/render/shader_lighting.hpp"
#include "core/techniques/configuration.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/technique.hpp"

namespace momentscope {

/// What all passes of one picture share. When they run, the Frame block is bound, the viewport has the size
/// of the picture, and the maps of the light are bound if there are shadows.
struct PassInput {
    ProgramCache& programs;
    const SceneBuffers& scene;
    glm::ivec2 size;
    GLuint opaque_color;
    GLuint depth;  // of opaque surfaces; tested, never written
    const ResolvedParameters& parameters;
    const ShaderLighting* lighting = nullptr;  // how fragments are lit; null: no light of the scene

    /// The variant of a geometry pass that is drawn often: without features that the scene does not need.
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

/// What tells how far a reconstruction can be trusted. failures: the numbers of failed and of clamped
/// fragments (failures.frag; two channels). uncertainty: the luminance that the bounds leave open
/// (uncertainty.frag; one channel).
enum class Diagnosis { failures, uncertainty };

/// The passes of one technique at one picture size. Each function draws one stage. The renderer calls a stage
/// again only if its input has changed.
class Transparency {
public:
    virtual ~Transparency() = default;

    /// First pass: draws what the technique must know before it can weigh colours.
    virtual void draw_moments(const PassInput& input) = 0;

    /// Second pass: draws weighted colours.
    virtual void draw_color(const PassInput& input) = 0;

    /// Composites the transparent over the opaque picture, into a framebuffer with one RGBA target.
    virtual void draw_composite(const PassInput& input, GLuint target) = 0;

    /// Binds what capture.frag reads with WITH_TRANSMITTANCE, and returns its variant. nullopt if the
    /// technique has no transmittances.
    virtual std::optional<ShaderVariant> bind_for_capture(const ResolvedParameters&) const { return {}; }

    /// What the first pass stored for the pixels of a rectangle, as read through the texture units. Empty if
    /// the technique has no moments.
    virtual std::vector<MomentVector> read_moments(const TexelRect&) const { return {}; }

    /// The target of the first pass, if it does not have the resolution of the picture.
    struct LowTarget {
        glm::ivec2 size;
        GLuint depth;  // of opaque surfaces, at this size
    };
    virtual std::optional<LowTarget> low_target() const { return {}; }

    /// Sums over the fragments of each pixel into a framebuffer, by additive blending. False, and nothing is
    /// drawn, if the technique reconstructs nothing.
    virtual bool draw_diagnosis(const PassInput&, Diagnosis, GLuint /*target*/) { return false; }
};

/// The passes of a technique. depth: the texture that its framebuffers test. Throws Error if the GL lacks
/// something that the technique needs.
std::unique_ptr<Transparency> make_transparency(const Technique& technique, glm::ivec2 size, GLuint depth,
                                                const Capabilities& gl);

/// A sentence that says why techniques which need ordered access are not available.
constexpr const char* NO_ORDERED_ACCESS =
    "This GL has neither GL_ARB_fragment_shader_interlock nor GL_EXT_shader_framebuffer_fetch, so fragments cannot be added "
    "in order.";

/// Why this GL cannot draw the technique, as a sentence; empty if it can.
std::string why_unavailable(const Technique& technique, const Capabilities& gl);

/// The same for what the parameters need of the first pass of moments.
std::string why_unavailable(const ResolvedParameters& parameters, const Capabilities& gl);

/// The same for a technique with its parameters.
std::string why_unavailable(const Configuration& configuration, const Capabilities& gl);

}  // namespace momentscope
