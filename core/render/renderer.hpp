// renderer.hpp -- pictures of a scene by any technique, and the exact fragments of a pixel.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/image/image.hpp"
#include "core/ray/view_ray.hpp"
#include "core/render/fragment_list.hpp"
#include "core/render/pass_timing.hpp"
#include "core/render/shadow_maps.hpp"
#include "core/render/view.hpp"

namespace momentscope {

/// How often each stage ran since the renderer was made.
struct PassCounts {
    int opaque = 0, moments = 0, color = 0, composite = 0;
};

/// Milliseconds that each stage took when it last ran; 0 when it never did.
struct PassTimes {
    double opaque = 0, moments = 0, color = 0, composite = 0;
};

/// Where a picture cannot be trusted: how many of its pixels have a fragment whose matrix was singular, and
/// how many others one whose sum left [0, 1] and was clamped.
struct FailureCounts {
    long failed = 0, clamped = 0;
};

/// A pixel as the GL computed it. Vectors run parallel to ray.fragments.
struct PixelCapture {
    ViewRay ray;
    std::vector<float>
        transmittance;  // of the second pass at each fragment; empty when the technique has none
    std::optional<MomentVector> stored;  // by the first pass, as the texture units give it
    glm::vec3 behind{0.2f};              // linear RGB of the opaque surface behind; grey without a scene
};

/// Draws into its own textures; needs a current OpenGL 4.5 context as long as it lives. Pixels count from the
/// upper left corner.
class Renderer {
public:
    /// Renderers of one GL context may share their programs, which takes seconds to link. Throws Error when
    /// the GL is older than 4.5.
    explicit Renderer(std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>());

    /// The same as if the GL had that ordered access: to see what is said where there is none.
    explicit Renderer(OrderedAccess access,
                      std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>());
    ~Renderer();

    void set_scene(const Scene& scene);

    /// Runs the stages that the change since the last picture made stale, and no others. Throws Error when GL
    /// fails; the next call starts afresh.
    void render(const View& view);

    /// Runs all stages of the technique again as if nothing were known of the last picture, which must have
    /// been drawn without an Error: to take their times.
    void redraw();

    /// The picture in sRGB, as a texture of the view's size with the first row at the bottom.
    GLuint display_texture() const { return display_color_; }

    /// The picture in linear RGBA floats.
    Image read_picture() const;

    /// All transparent fragments that cover a pixel of the last picture and are not behind opaque surfaces.
    PixelCapture capture_pixel(glm::ivec2 pixel);

    /// Everything that lights a point which a pixel of the last picture shows, at a view depth. The picture
    /// must have shadows.
    ShadowFilterSamples capture_light(glm::ivec2 pixel, float view_depth);

    /// Where in the world the middle of a pixel of the last picture is at a view depth.
    glm::vec3 world_place(glm::ivec2 pixel, float view_depth) const;

    /// Where the opaque surface of a pixel is and how it is lit; nullopt where there is none.
    struct LitSurface {
        float view_depth = 0;
        float shadowed = 0;       // share of the filter region behind opaque casters
        float transmittance = 1;  // of transparent casters
    };
    std::optional<LitSurface> lit_surface(glm::ivec2 pixel);

    /// The share of light that reaches each transparent fragment of a pixel, as the GL computes it, parallel
    /// to capture_pixel's fragments.
    std::vector<float> fragment_lights(glm::ivec2 pixel);

    /// Of the last picture; null where it has no shadows.
    const ShadowMaps* shadow_maps() const { return lit() ? shadow_maps_.get() : nullptr; }

    /// The same for a rectangle, row by row; corner is its upper left.
    std::vector<PixelCapture> capture_region(glm::ivec2 corner, glm::ivec2 extent);

    /// A rectangle of the picture in linear RGBA; corner is its upper left. Throws Error unless it lies
    /// within.
    Image read_region(glm::ivec2 corner, glm::ivec2 extent) const;

    /// Counts failed and clamped reconstructions of the last picture, and draws where they are into
    /// failure_texture(). nullopt, and no picture, for techniques that reconstruct nothing.
    std::optional<FailureCounts> draw_failures();

    /// sRGB with alpha, to be laid over display_texture(); valid after draw_failures().
    GLuint failure_texture() const { return failure_color_; }

    const std::shared_ptr<ProgramCache>& programs() const { return programs_; }
    OrderedAccess ordered_access() const { return access_; }
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
    void draw_probe();
    GLuint capture_program(bool& has_transmittance);
    std::vector<PixelCapture> sort_captures(std::vector<FragmentNode> nodes, glm::ivec2 lower_left,
                                            glm::ivec2 extent, bool has_transmittance) const;

    void add_shares(std::vector<PixelCapture>& captures, const Transparency::LowTarget& low,
                    glm::ivec2 lower_left, glm::ivec2 extent);

    template <typename Draw>
    void timed(double& milliseconds, const Draw& draw);

    glm::vec3 background_{0};
    Sphere bounds_, casters_;
    Light light_;
    std::unique_ptr<SceneBuffers> buffers_;
    View view_;
    ResolvedParameters parameters_;
    OrderedAccess access_;
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
    std::unique_ptr<FragmentList> pixel_list_;

    GlQuery timer_;
    std::unique_ptr<ShadowMaps> shadow_maps_;  // made when they are first needed
    GlTexture probe_;                          // of light_probe.frag; made when it is first asked for
    GlFramebuffer probe_target_;
    bool probed_ = false;  // does it belong to the last picture?

    GlTexture failure_counts_, failure_color_;  // made when they are first asked for
    GlFramebuffer failure_target_, failure_color_target_;
};

}  // namespace momentscope
