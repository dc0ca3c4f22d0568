// workspace.hpp -- the user's choices, and everything that the window holds besides them. Commands and panels
// read and change it; ui/window updates and draws it.
#pragma once
#include <functional>
#include <limits>

#include "core/gl/gl_info.hpp"
#include "ui/model/embedding.hpp"
#include "ui/model/history.hpp"
#include "ui/model/settings.hpp"
#include "ui/model/transition.hpp"
#include "ui/picture/picked_ray.hpp"
#include "ui/picture/picture_times.hpp"
#include "ui/picture/scene_panel.hpp"
#include "ui/picture/shown_scene.hpp"
#include "ui/plot/plot_panel.hpp"
#include "ui/tools/ray_editor.hpp"
#include "ui/tools/sharp_bounds_work.hpp"
#include "ui/tools/stress_run.hpp"
#include "ui/tools/technique_chart.hpp"
#include "ui/tools/tuning.hpp"
#include "ui/workspace/files.hpp"
#include "ui/workspace/host.hpp"
#include "ui/workspace/lesson_work.hpp"

namespace momentscope::ui {

/// During a drag, a picture that takes more milliseconds than this is replaced by a draft. With the plot and
/// the rest of the window, this allows 20 updates a second.
constexpr double DRAG_MILLISECONDS = 40;

struct WindowOptions {
    float scale = 1;         // scale of fonts and spacing
    bool show_times = true;  // milliseconds in the status line; off if pictures must repeat bit by bit
    // While the mouse drags, a picture that takes longer is replaced by a draft.
    double most_milliseconds = std::numeric_limits<double>::infinity();
    // before_long_picture is called before a picture that is expected to take longer than this, or whose time
    // is unknown. The caller can then call draw_waiting.
    double most_silent_milliseconds = 100;
    // Returns false if the user sees the notice already. True: the frame ends without the picture, which the
    // next frame draws.
    std::function<bool()> before_long_picture = {};
    Settings settings = {};  // unless the host has kept others
    Host host = {};
    Embedding embedding = {};
};

/// The list of commands that opens above the window.
struct PaletteState {
    bool open = false;
    bool begin = false;  // it was opened; the next frame shows it and gives it the keyboard
    std::string typed;
    int chosen = 0;  // the entry that Enter runs

    void toggle() {
        open = begin = !open;
        typed.clear();
        chosen = 0;
    }
};

/// What the host was given to keep last.
struct Kept {
    Settings settings;
    long progress_changes = 0;
    bool can_keep_settings = true, can_keep_progress = true;
};

struct Workspace {
    Workspace(Renderer& renderer, ExplorerState start, WindowOptions window_options);

    WindowOptions options;
    GlInfo gl;

    ExplorerState state;  // what the user wants
    ExplorerState shown;  // what the window shows: everything below was computed for this state
    History history;
    Status status;
    FrameReport report;  // of the last frame
    WidgetRects widget_rects;

    ShownScene scene;
    Picture picture;
    PictureTimes picture_times;
    PickedRay picked;
    PictureComparison comparison;
    ScenePicture scene_picture;
    ScenePanel scene_panel;
    PlotPanel plot_panel;

    SharpBoundsWork sharp_bounds;
    Tuning tuning;
    StressRun stress;
    TechniqueChart chart;
    RayEditor editor;
    Files files{options.host};
    PaletteState palette;

    Course course;
    LessonWork lesson;  // the open step
    Settings settings;
    Kept kept;
    bool present = false;              // only scene, plot and lesson are shown
    std::optional<Transition> moving;  // from step to step while presenting

    bool help = false;                   // is the list of keys open?
    bool fragment_moments = false;       // does Fragments show what each fragment adds to the moments?
    bool failed_wanted = false;          // the next failed pixel is picked as soon as they are known
    bool picture_waits = false;          // for the next frame; this one shows that it will take long
    bool escape_is_taken = false;        // by a popup, dialog, text field or scene that is read
    std::optional<ParameterId> to_type;  // the parameter whose control becomes a text field now

    const Measurement& measurement() const { return picked.measurement(); }
    Camera camera() const { return scene.camera(state); }
};

/// Is background work running? Frames are then needed to show its progress.
bool has_background_work(const Workspace& workspace);

/// Is another frame needed without input? True if the window does not show the state yet, and while long work
/// runs.
bool wants_frame(const Workspace& workspace);

void undo(Workspace& workspace);
void redo(Workspace& workspace);

/// Discards a state that could not be shown.
void go_back_to_shown(Workspace& workspace);

/// Opens the Controls tab, where the control of this parameter becomes a text field.
void type_parameter(Workspace& workspace, ParameterId id);

/// Marks failed reconstructions and picks the next one.
void want_next_failed(Workspace& workspace);

/// Opens the Chart tab and starts to measure.
void measure_chart(Workspace& workspace);

/// Dialogs and text fields close themselves on Escape; this function closes the first of the rest.
void close_topmost(Workspace& workspace);

}  // namespace momentscope::ui
