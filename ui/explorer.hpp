// explorer.hpp -- the content of the window: scene, plot and panels of one state.
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
#include "ui/frame_report.hpp"
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

/// During a drag, a picture that takes more milliseconds than this is replaced by a draft. With the plot and
/// the rest of the window, this allows 20 updates a second.
constexpr double DRAG_MILLISECONDS = 40;

struct ExplorerOptions {
    float scale = 1;         // scale of fonts and spacing
    bool show_times = true;  // milliseconds in the status line; off if pictures must repeat bit by bit
    // While the mouse drags, a picture that takes longer is replaced by a draft.
    double most_milliseconds = std::numeric_limits<double>::infinity();
    // before_long_picture is called before a picture that is expected to take longer than this, or whose time
    // is unknown. The caller can then call draw_waiting.
    double most_silent_milliseconds = 100;
    std::function<void()> before_long_picture = {};
};

/// Draws ImGui frames. The GL context of the renderer must be current, and an ImGui frame must have begun.
class Explorer {
public:
    Explorer(Renderer& renderer, ExplorerState state, ExplorerOptions options = {});

    /// Fills the whole ImGui viewport and recomputes what the state's changes made stale. A failure is shown
    /// as a message, and the last good picture stays. Throws Error only if there was no good picture yet.
    void frame();

    /// Draws the word "drawing…" over the last frame while a long picture is drawn. Before the first picture,
    /// fills the window with the names of the program and of the scene.
    void draw_waiting(ImDrawList& list) const;

    /// Is another frame needed without input? True if the window does not show the state yet, and while long
    /// work runs.
    bool wants_frame() const {
        return !(state_ == shown_state_) || is_loading_scene() || has_background_work() || worst_wanted_ ||
               shows_draft() || chart_panel_.busy();
    }

    /// Is a draft shown? The full picture replaces it when the view has not changed for 0.2 s or the mouse
    /// button is released.
    bool shows_draft() const { return draft_view_.technique != nullptr; }

    /// Is background work running? Frames are then needed to show its progress.
    bool has_background_work() const {
        return stress_panel_.busy() || tuning_.busy() || sharp_bounds_.busy() || comparison_.busy();
    }

    /// Is a scene being read? Frames are then needed to show the elapsed time.
    bool is_loading_scene() const { return loader_.busy(); }

    // The interface for commands, event files and tests.
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

    // What the window shows.
    const Measurement& measurement() const { return measurement_; }
    const Comparison& comparison() const { return comparison_; }
    const ChartPanel& chart_panel() const { return chart_panel_; }
    const FrameReport& report() const { return report_; }
    const std::string& message() const { return message_; }
    /// The number of pixels with failures. nullopt while failures are not marked, or if the technique
    /// reconstructs nothing.
    const std::optional<FailureCounts>& failures() const { return picture_.failures; }

    /// The text that says which parts of the scene are missing; empty if none is. The window shows it as a
    /// message when the scene is loaded.
    std::string warning() const;
    const WidgetRects& widget_rects() const { return widget_rects_; }
    bool shows_reference() const { return flipped_; }
    bool shows_help() const { return help_; }
    bool shows_palette() const { return palette_.is_open(); }
    bool shows_file_dialog() const { return files_.is_open(); }

    /// The file to which this frame of the window shall be written; nullopt if there is none. Call this
    /// function exactly once per frame, because it counts the frames until the export.
    std::optional<std::filesystem::path> take_window_export();

    /// Shows a message, for instance about a failure.
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
    ExplorerState shown_state_;  // everything below was computed for this state
    History history_;
    Measurement measurement_;
    FrameReport report_;
    std::string message_;
    WidgetRects widget_rects_;

    Scene scene_;               // the scene in the renderer
    float light_distance_ = 1;  // the default distance of its light
    View shown_view_;           // technique is null if nothing is shown
    DraftPicture draft_;
    View draft_view_;              // technique is null if the full picture is shown
    bool draft_captured_ = false;  // the shown fragments are from a draft
    float still_seconds_ = 0;      // since the draft's view last changed
    SceneLoader loader_;
    std::unique_ptr<Renderer> reference_;  // of the same scene; created on first use
    View reference_view_;                  // the last view of the reference
    PictureTimes picture_times_;
    bool flipped_ = false;  // shows the reference
    bool flip_button_held_ = false;
    bool lens_flipped_ = false;
    bool transmittance_stale_ = true;
    bool breakdown_stale_ = true;
    Comparison comparison_;
    bool pair_stale_ = true;     // picture or reference changed since the last comparison
    bool worst_wanted_ = false;  // the next worst pixel is picked as soon as it is known

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
    struct SharpBoundsInput {  // what the sharp bounds depend on, besides the ray
        const Technique* technique;
        float theta;
        Range depths;
        friend bool operator==(const SharpBoundsInput&, const SharpBoundsInput&) = default;
    };
    BackgroundWork<std::optional<SharpBounds>> sharp_bounds_;
    std::optional<SharpBoundsInput> sharp_input_;  // of the last request; nullopt: none for this ray
    bool help_ = false;
    bool escape_is_taken_ = false;  // by a popup, dialog, text field or scene that is read
    std::optional<ParameterId> to_type_;
    bool focus_go_to_ = false;
    std::optional<std::filesystem::path> window_export_;
    int frames_to_export_ = 0;
    std::optional<ThemeKind> styled_;
};

}  // namespace momentscope::ui
