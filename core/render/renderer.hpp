// renderer.hpp -- draws pictures of a scene by any technique, and captures all transparent fragments of a
// pixel.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/gl/pass_timing.hpp"
#include "core/image/image.hpp"
#include "core/inspect/pixel_capture.hpp"
#include "core/render/failure_marks.hpp"
#include "core/render/fragment_capture.hpp"
#include "core/render/light_probe.hpp"
#include "core/render/shadow_maps.hpp"
#include "core/render/uncertainty_map.hpp"
#include "core/render/view.hpp"

namespace momentscope {

/// How often each stage has run since the renderer was made.
struct PassCounts {
    int opaque = 0, moments = 0, color = 0, composite = 0;
};

/// Milliseconds that each stage took when it last ran; 0 if it never ran.
struct PassTimes {
    double opaque = 0, moments = 0, color = 0, composite = 0;
};

/// Draws pictures into its own textures. Needs a current context during its whole life. Pixels
/// count from the upper left corner.
class Renderer {
public:
    /// Renderers of one GL context may share their programs, because linking takes seconds. The renderer uses
    /// no more than the capabilities that the programs were made for. Throws Error if the GL cannot draw
    /// pictures.
    explicit Renderer(std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>());
    ~Renderer();

    void set_scene(const Scene& scene);

    /// Runs only those stages that are stale after the change since the last picture. Throws Error if the GL
    /// fails; the next call then runs all stages. Also throws Error if the view cannot be drawn, for instance
    /// because its parameters make no sense together, its size is not allowed, or the light stands among the
    /// casters.
    void render(const View& view);

    /// Runs all stages of the technique again, to measure their times. The last picture must have been drawn
    /// without an Error.
    void redraw();

    /// The picture in sRGB as a texture of the size of the view. Its first row is at the bottom.
    GLuint display_texture() const { return display_color_; }

    /// The picture in linear RGBA floats.
    Image read_picture() const;

    /// All transparent fragments that cover a pixel of the last picture and do not lie behind opaque
    /// surfaces.
    PixelCapture capture_pixel(glm::ivec2 pixel);

    /// What the light's maps hold for a point, and the fragments and depths that it comes from. The point is
    /// the one that a pixel of the last picture shows at this view depth. The picture must have shadows.
    ShadowFilterSamples capture_light(glm::ivec2 pixel, float view_depth);

    /// The point in world coordinates at this view depth behind the centre of a pixel of the last picture.
    glm::vec3 world_place(glm::ivec2 pixel, float view_depth) const;

    /// The depth of the opaque surface in a pixel, and how this surface is lit; nullopt if the pixel shows no
    /// opaque surface. The picture must have shadows.
    std::optional<LitSurface> lit_surface(glm::ivec2 pixel);

    /// The share of the light that reaches each transparent fragment of a pixel, as the GL computes it.
    /// Parallel to the fragments of capture_pixel.
    std::vector<float> fragment_lights(glm::ivec2 pixel);

    /// The shadow maps of the last picture; null if it has none.
    const ShadowMaps* shadow_maps() const { return lit() ? shadow_maps_.get() : nullptr; }

    /// The same as capture_pixel for a rectangle, row by row. corner: its upper left.
    std::vector<PixelCapture> capture_region(glm::ivec2 corner, glm::ivec2 extent);

    /// A rectangle of the picture in linear RGBA. corner: its upper left. Throws Error if the rectangle does
    /// not lie within the picture.
    Image read_region(glm::ivec2 corner, glm::ivec2 extent) const;

    /// Counts the pixels of the last picture with failed or clamped reconstructions, and marks them in
    /// failure_texture(). nullopt, and nothing is drawn, if the technique reconstructs nothing.
    std::optional<FailureCounts> draw_failures();

    /// sRGB with alpha, to be drawn over display_texture(). 0 before draw_failures().
    GLuint failure_texture() const { return failures_ ? failures_->texture() : 0; }

    /// How much of each pixel's luminance the bounds of the last picture leave open, row by row from the top.
    /// Empty if the technique reconstructs nothing.
    std::vector<float> uncertainty();

    const std::shared_ptr<ProgramCache>& programs() const { return programs_; }
    const Capabilities& gl() const { return programs_->gl(); }
    const PassCounts& pass_counts() const { return counts_; }
    const PassTimes& pass_times() const { return times_; }
    PassTiming pass_timing() const { return timing_; }

private:
    void resize(glm::ivec2 size);
    void update_frame_block(const View& view);
    void draw_opaque();
    void run_from(Stage stage);
    PassInput pass_input() const;
    bool lit() const;
    void update_shadows(const View& view);
    DrawnPicture drawn() const;

    template <typename Draw>
    void timed(double& milliseconds, const Draw& draw);

    glm::vec3 background_{0};
    Sphere bounds_, casters_;
    Light light_;
    std::unique_ptr<SceneBuffers> buffers_;
    View view_;
    ResolvedParameters parameters_;
    DepthWarp warp_;
    PassCounts counts_;
    PassTimes times_;
    PassTiming timing_ = PassTiming::finish;

    GlBuffer frame_block_;
    GlTexture opaque_color_, depth_, picture_, display_color_;
    GlFramebuffer opaque_target_, picture_target_, display_target_;
    std::shared_ptr<ProgramCache> programs_;
    std::unique_ptr<Transparency> transparency_;
    const Technique* transparency_of_ = nullptr;
    std::unique_ptr<FragmentCapture> capture_;

    GlQuery timer_;
    std::unique_ptr<ShadowMaps> shadow_maps_;      // made at first use
    std::unique_ptr<LightProbe> probe_;            // of the last picture; made at first use
    std::unique_ptr<FailureMarks> failures_;       // made at first use
    std::unique_ptr<UncertaintyMap> uncertainty_;  // made at first use
};

}  // namespace momentscope
