// renderer.hpp -- draws pictures of a scene by any technique, and captures all transparent fragments of a
// pixel.
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

/// How often each stage has run since the renderer was made.
struct PassCounts {
    int opaque = 0, moments = 0, color = 0, composite = 0;
};

/// Milliseconds that each stage took when it last ran; 0 if it never ran.
struct PassTimes {
    double opaque = 0, moments = 0, color = 0, composite = 0;
};

/// How many pixels cannot be trusted (failures.frag). failed, robust solver: pixels whose matrix of moments
/// had a pivot below the floor, or with a NaN. failed, textbook solver: pixels with a NaN, or with a sum
/// outside [0, 1] by more than 1e-4. clamped, robust solver: other pixels with such a sum.
struct FailureCounts {
    long failed = 0, clamped = 0;
};

/// A pixel as the GL computed it. `transmittance` is parallel to ray.fragments.
struct PixelCapture {
    ViewRay ray;
    std::vector<float> transmittance;    // T from the second pass; empty if the technique computes none
    std::optional<MomentVector> stored;  // moments of the first pass, as shaders read them; nullopt: none
    glm::vec3 behind{0.2f};              // linear RGB of the opaque surface behind; grey without a scene
};

/// Draws pictures into its own textures. Needs a current OpenGL 4.5 context during its whole life. Pixels
/// count from the upper left corner.
class Renderer {
public:
    /// Renderers of one GL context may share their programs, because linking takes seconds. Throws Error if
    /// the GL is older than 4.5.
    explicit Renderer(std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>());

    /// The same, but the renderer behaves as if the GL had this kind of ordered access. Tests use it to see
    /// the message for a GL that has none.
    explicit Renderer(OrderedAccess access,
                      std::shared_ptr<ProgramCache> programs = std::make_shared<ProgramCache>());
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
    struct LitSurface {
        float view_depth = 0;
        float shadowed = 0;       // share of the filter region with an opaque caster in front
        float transmittance = 1;  // of the transparent casters in front
    };
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

    /// sRGB with alpha, to be drawn over display_texture(). Valid after draw_failures().
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
    std::unique_ptr<ShadowMaps> shadow_maps_;  // made at first use
    GlTexture probe_;                          // target of light_probe.frag; made at first use
    GlFramebuffer probe_target_;
    bool probed_ = false;  // does probe_ belong to the last picture?

    GlTexture failure_counts_, failure_color_;  // made at first use
    GlFramebuffer failure_target_, failure_color_target_;
};

}  // namespace momentscope
