// explorer.hpp -- the window's content: scene, plot and panels over one state.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "core/gl/gl_info.hpp"
#include "core/render/renderer.hpp"
#include "core/stress/tune.hpp"
#include "ui/chart_panel.hpp"
#include "ui/command_palette.hpp"
#include "ui/comparison.hpp"
#include "ui/draft_picture.hpp"
#include "ui/file_dialog.hpp"
#include "ui/history.hpp"
#include "ui/measurement.hpp"
#include "ui/picture_times.hpp"
#include "ui/pinned_plots.hpp"
#include "ui/plot_panel.hpp"
#include "ui/ray_editor.hpp"
#include "ui/scene_loader.hpp"
#include "ui/scene_panel.hpp"
#include "ui/stress_panel.hpp"

namespace momentscope::ui {

/// For a picture while something is dragged: 20 updates a second, the plot and the rest of the window
/// included.
constexpr double DRAG_MILLISECONDS = 40;

struct ExplorerOptions {
    float scale = 1;         // of fonts and spacing
    bool show_times = true;  // milliseconds in the status line; off where pictures must repeat bit by bit
    double most_milliseconds =
        std::numeric_limits<double>::infinity();     // for a picture, while the mouse drags;
                                                     // one that takes longer is drafted
    double most_silent_milliseconds = 100;           // a picture takes as its kind did before, but times vary
    std::function<void()> before_long_picture = {};  // called before one that takes longer, or nobody knows
                                                     // how long; draw_waiting is for the window to show then
};

/// What a frame had to compute; all false when nothing had changed.
struct FrameReport {
    bool draft = false;  // at a reduced resolution
    bool opaque = false, first_pass = false, second_pass = false, composite = false;
    bool failures = false, reference = false, comparison = false, capture = false, plot = false,
         query = false;

    /// "second pass, composite, plot", or "" when nothing was computed.
    std::string text() const;
};

/// Draws one ImGui frame after another. Needs a current GL context through the renderer, and an ImGui frame
/// begun.
class Explorer {
public:
    Explorer(Renderer& renderer, ExplorerState state, ExplorerOptions options = {});

    /// Fills the whole ImGui viewport. Recomputes what the state's changes made stale. Failures become the
    /// message line; the last good picture stays. Throws Error only when there never was a good one.
    void frame();

    /// What is shown over the last frame while a long picture is drawn, or instead of it before the first.
    void draw_waiting(ImDrawList& list) const;

    /// Does what is shown lag behind the state, so that another frame is needed without any input?
    bool wants_frame() const {
        return !(state_ == shown_state_) || is_loading_scene() || has_background_work() || worst_wanted_ ||
               shows_draft() || chart_panel_.busy();
    }

    /// Is the picture one of reduced resolution, which the full one replaces as soon as the mouse rests?
    bool shows_draft() const { return draft_view_.technique != nullptr; }

    /// Does work go on beside the window? Frames are then needed to show how far it is.
    bool has_background_work() const {
        return stress_panel_.busy() || tuning_.busy() || sharp_bounds_.busy() || comparison_.busy();
    }

    /// Is a scene being read? Frames are then only needed to show how long.
    bool is_loading_scene() const { return loader_.busy(); }

    // What commands, event files and tests act on.
    ExplorerState& state() { return state_; }
    const ExplorerState& state() const { return state_; }
    bool can_undo() const { return history_.can_undo(); }
    bool can_redo() const { return history_.can_redo(); }
    void undo();
    void redo();
    void open_session_dialog();
    void save_session_dialog();
    void open_mesh_dialog();
    void open_ray_dialog();
    void export_dialog();
    void toggle_help() { help_ = !help_; }
    void toggle_palette() { palette_.toggle(); }
    void type_pixel() { focus_go_to_ = true; }
    void type_parameter(ParameterId id);
    void move_pick(glm::ivec2 by);
    void toggle_pin();
    void measure_chart();
    void cancel_chart() { chart_panel_.cancel(); }
    void next_worst_pixel() { worst_wanted_ = true; }
    void mark_next(int step);
    void close_topmost();
    Camera camera() const { return state_.camera.value_or(scene_.camera); }

    // What is shown.
    const Measurement& measurement() const { return measurement_; }
    const Comparison& comparison() const { return comparison_; }
    const ChartPanel& chart_panel() const { return chart_panel_; }
    const FrameReport& report() const { return report_; }
    const std::string& message() const { return message_; }
    /// How many fragments of the picture fail, while they are marked.
    const std::optional<FailureCounts>& failures() const { return picture_.failures; }

    /// What the scene is shown without, which is also its first message; empty when nothing is missing.
    std::string warning() const;
    const WidgetRects& widget_rects() const { return widget_rects_; }
    bool shows_reference() const { return flipped_; }
    bool shows_help() const { return help_; }
    bool shows_palette() const { return palette_.is_open(); }
    bool shows_file_dialog() const { return files_.is_open(); }

    /// The file to which the window as it is drawn now shall be written; asked for once per frame.
    std::optional<std::filesystem::path> take_window_export();

    /// Reports the failure of something that the window asked for.
    void say(const std::string& message) { message_ = message; }

private:
    enum class FilePurpose { open_session, save_session, open_mesh, open_ray, save_export, save_chart };

    void poll_loader();
    void load_scene_if_changed();
    void go_back_to_shown();
    void show_scene(Scene scene);
    void apply_opacity();
    void update(glm::ivec2 size);
    void update_ray();
    void update_picture(glm::ivec2 size);
    bool wants_draft(const View& view, Stage stage);
    void draw_draft(const View& view, Stage stage);
    void update_capture(const View& view, Stage stage);
    void see_from_light(glm::ivec2 pixel);
    void leave_light_without_shadows();
    bool fragments_stale(const View& view, Stage stage) const;
    void update_pins(const View& view, Stage stage);
    void update_scene_picture(const View& view, Stage stage);
    void render_reference(const View& view);
    void update_lens(glm::ivec2 size, bool stale);
    LensPixel map_pixel(glm::ivec2 at) const;
    bool on_reference_side(int x, int width) const;
    bool has_comparison() const;
    void update_comparison(const View& view, Stage stage);
    void pick_next_worst();
    void choose_picture();
    void measure_if_changed(bool captured);
    void report_passes(const PassCounts& before);
    bool wants_reference() const;
    View reference_view(const View& view) const;
    PictureKind picture_kind(const View& view, Stage stage) const;
    void announce(const PictureKind& kind, glm::ivec2 size) const;
    void draw_opening(ImDrawList& list) const;

    bool close_popup_on_escape() const;
    void message_until_input();
    void draw_menu(const Ui& ui);
    void draw_lessons(const Ui& ui);
    void draw_card(const Ui& ui);
    void draw_work_area(const Ui& ui);
    void draw_right_side(const Ui& ui, ImVec2 size);
    void draw_tabs(const Ui& ui);
    void draw_chart_panel(const Ui& ui);
    void draw_status(const Ui& ui);
    void draw_loading(const Ui& ui);
    void draw_tuning(const Ui& ui);
    void update_sharp_bounds();
    void start_tuning();
    void poll_tuning();
    void draw_files(const Ui& ui);
    void use_file(const FileDialog::Choice& choice);
    void export_to(const FileDialog::Choice& choice);

    Renderer& renderer_;
    ExplorerOptions options_;
    GlInfo gl_ = gl_info();
    ExplorerState state_;
    ExplorerState shown_state_;  // for which everything below was computed
    History history_;
    Measurement measurement_;
    FrameReport report_;
    std::string message_;
    WidgetRects widget_rects_;

    Scene scene_;               // what the renderer holds
    float light_distance_ = 1;  // its light's own
    View shown_view_;           // technique is null when nothing is shown
    DraftPicture draft_;
    View draft_view_;              // technique is null when the full picture is shown
    bool draft_captured_ = false;  // the fragments that are shown
    float still_seconds_ = 0;      // that the draft's view has not changed
    SceneLoader loader_;
    std::unique_ptr<Renderer> reference_;  // of the same scene, made when it is first asked for
    View reference_view_;                  // that it drew last
    PictureTimes picture_times_;
    bool flipped_ = false;  // to the reference
    bool flip_button_held_ = false;
    bool lens_flipped_ = false;
    bool transmittance_stale_ = true;
    bool breakdown_stale_ = true;
    Comparison comparison_;
    bool pair_stale_ = true;     // picture or reference changed since they were compared
    bool worst_wanted_ = false;  // as soon as it is known

    ScenePanel scene_panel_;
    ScenePicture picture_;
    PlotPanel plot_panel_;
    FileDialog files_;
    FilePurpose file_purpose_ = FilePurpose::open_session;
    CommandPalette palette_;
    RayEditor ray_editor_;
    StressPanel stress_panel_;
    ChartPanel chart_panel_;
    BackgroundWork<std::optional<TuneResult>> tuning_;
    const Technique* tuned_technique_ = nullptr;
    struct SharpBoundsInput {  // beside the ray
        const Technique* technique;
        float theta;
        Range depths;
        friend bool operator==(const SharpBoundsInput&, const SharpBoundsInput&) = default;
    };
    BackgroundWork<std::optional<SharpBounds>> sharp_bounds_;
    std::optional<SharpBoundsInput> sharp_input_;  // of the last that were asked for; nullopt: of no ray
    bool help_ = false;
    bool escape_is_taken_ = false;  // by a popup, a dialog or a text field that it closes
    std::optional<ParameterId> to_type_;
    bool focus_go_to_ = false;
    std::optional<std::filesystem::path> window_export_;
    int frames_to_export_ = 0;
    std::optional<ThemeKind> styled_;
};

}  // namespace momentscope::ui
