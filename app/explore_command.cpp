#include <fmt/format.h>

#include "app/command.hpp"
#include "app/event_player.hpp"
#include "app/ignored_options.hpp"
#include "app/open_window.hpp"
#include "app/output_conflicts.hpp"
#include "app/terminal.hpp"
#include "app/user_folder.hpp"
#include "core/ray/ray_json.hpp"
#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "core/support/parse_number.hpp"
#include "ui/model/course.hpp"
#include "ui/model/session.hpp"
#include "ui/workspace/keeping.hpp"

namespace momentscope {

namespace {

// Accepts numbers from 0.5 to 4.
float parse_scale(const std::string& text) {
    const auto scale = parse_number<float>(text);
    if (!scale || !(*scale >= 0.5f && *scale <= 4))
        throw Error(fmt::format(
            "'{}' is not a scale for the window's text; give --ui-scale a number from 0.5 to 4.", text));
    return *scale;
}

ui::ThemeKind parse_theme(const std::string& text) {
    if (text == "dark") return ui::ThemeKind::dark;
    if (text == "light") return ui::ThemeKind::light;
    throw Error(fmt::format("There is no theme '{}'; use dark or light.", text));
}

// The files of lessons that --lesson names.
struct OpenedLessons {
    ui::Course course;
    const ui::Lesson* first = nullptr;
    std::vector<std::string> problems;
};

class Explore : public ParsedCommand {
public:
    explicit Explore(CLI::App& app) : ParsedCommand(app) {
        CLI::Option* scene = add_scene(app, scene_);
        add_size(app, size_);
        add_gl(app);
        CLI::Option* pixel =
            app.add_option("--pixel", pixel_.text, "picked pixel of the scene's picture, such as 320,200");
        CLI::Option* ray =
            app.add_option("--ray", ray_, "JSON file with a view ray, instead of a pixel of a scene");
        ray->excludes(scene, pixel);
        CLI::Option* techniques = add_techniques(
            app, techniques_,
            "ids of techniques (momentscope list techniques); all after the first are only plotted");
        add_parsed<const Technique*>(app, "--compare", reference_,
                                     "id of the technique that the picture is compared with [sorted]",
                                     [](const std::string& id) { return &require_technique(id); });
        app.add_option("--session", session_, "JSON file that the window saved, to continue from there")
            ->excludes(scene, ray, techniques);
        app.add_option("--lesson", lesson_, "JSON file of a lesson, or a folder of them, to open")
            ->excludes("--session");
        app.add_flag("--headless", headless_, "draw without a display");
        app.add_option("--screenshot", screenshot_, "with --headless: where to write the window as .png");
        app.add_option("--events", events_, "with --headless: file with mouse and keyboard events to replay");
        app.add_option("--log", log_,
                       "where to write a log of the frames that were drawn and what they computed");
        add_parsed<float>(app, "--ui-scale", scale_, "size of the window's text, 0.5 to 4", parse_scale)
            ->default_str("1");
        add_parsed<std::optional<ui::ThemeKind>>(app, "--theme", theme_, "dark or light [dark]", parse_theme);
        parameters_.add_to(app);
    }

    // Parameters are never ignored: the window keeps them for other techniques and scenes that the user may
    // choose.
    void refuse_ignored() const override {
        refuse_ignored_options(
            app(), {{"--compare", !ray_.empty(), "together with --ray, because a view ray has no picture"}});
    }

    FileUse files() const override {
        FileUse use = {scene_files(scene_), {{"--screenshot", screenshot_}, {"--log", log_}}};
        use.inputs.insert(use.inputs.end(), {ray_, session_, events_, lesson_});
        return use;
    }

    void run() const override {
        if (headless_) return run_headless();
        if (!screenshot_.empty() || !events_.empty())
            throw Error("--screenshot and --events work only with --headless; add it.");
        if (app().count("--gl") > 0)
            throw Error("--gl chooses how to draw without a window; add --headless, or leave --gl out.");
        run_window(start());
    }

private:
    // What the user has kept holds unless the command line says otherwise.
    WindowStart start() const {
        const ui::Settings kept = ui::kept_settings(kept_for_user);
        OpenedLessons lessons = open_lessons();
        WindowStart start = {initial_state(lessons.first),
                             std::move(lessons.course),
                             lessons.problems.empty() ? "" : lessons.problems.front(),
                             size_,
                             scale_,
                             pixel_,
                             log_};
        if (!theme_ && session_.empty()) start.state.theme = kept.theme;
        if (app().count("--size") == 0 && kept.window.x > 0 && kept.window.y > 0) start.size = kept.window;
        return start;
    }

    OpenedLessons open_lessons() const {
        OpenedLessons lessons;
        if (lesson_.empty()) return lessons;
        ui::Course::Added added = lessons.course.add(lesson_);
        lessons.first = added.first;
        lessons.problems = std::move(added.problems);
        for (const std::string& problem : lessons.problems) warn(problem);
        return lessons;
    }

    void run_headless() const {
        if (screenshot_.empty() && events_.empty())
            throw Error("--headless has no window to show; add --screenshot FILE.png, or --events FILE.");
        if (headless_gl_key() == "window")  // what a hidden window shows is undefined
            throw Error(
                "--gl window draws pictures, not the window; leave out --headless, or use another --gl.");
        if (!screenshot_.empty()) {
            require_writable(screenshot_);
            if (!ends_in(screenshot_, ".png"))
                throw Error(fmt::format("A screenshot is a .png file; '{}' is not.", screenshot_));
        }
        FrameLog log(log_);
        const OpenedLessons lessons = open_lessons();
        HeadlessWindow window(size_, initial_state(lessons.first),
                              {.scale = scale_, .show_times = false, .settings = ui::NEW_USER}, log);
        window.explorer().workspace().course = lessons.course;
        window.settle();
        pick_option(pixel_, window.explorer());
        window.settle();
        const std::string warning = window.explorer().workspace().status.warning;
        if (!warning.empty()) warn(warning);
        const std::string& message = window.explorer().workspace().status.message;
        if (!message.empty() && message != warning) throw Error(message);
        if (!events_.empty()) EventPlayer(window, files_of(files())).play_file(events_);
        if (!screenshot_.empty()) window.write_png(screenshot_);
        log.require_written();
    }

    ui::ExplorerState initial_state(const ui::Lesson* lesson) const {
        ui::ExplorerState state = session_.empty() ? state_of_options() : state_of_session();
        if (lesson != nullptr) ui::open_lesson(state, *lesson);
        if (reference_ != nullptr) {
            state.compare.reference = reference_;
            state.panel = ui::Panel::compare;  // this tab shows the choice
        }
        if (theme_) state.theme = *theme_;
        return state;
    }

    // Typed parameters override those of the session.
    ui::ExplorerState state_of_session() const {
        ui::Session session = ui::read_session_file(session_);
        if (!session.ignored.empty())
            warn(fmt::format("The session has keys that this version does not know: {}.",
                             fmt::join(session.ignored, ", ")));
        session.state.parameters = parameters_.over(session.state.parameters);
        return session.state;
    }

    ui::ExplorerState state_of_options() const {
        ui::ExplorerState state;
        state.parameters = parameters_.over();
        const auto techniques = techniques_of(techniques_, "power6-32");
        state.technique = techniques.front();
        state.compared.assign(techniques.begin() + 1, techniques.end());
        state.scene = scene_;
        if (!ray_.empty()) state.ray = read_ray_file(ray_);
        return state;
    }

    std::string scene_ = STANDARD_SCENE;
    glm::ivec2 size_ = {1280, 800};
    PixelOption pixel_;
    std::string ray_;
    TechniqueIds techniques_;
    const Technique* reference_ = nullptr;
    std::string session_;
    std::string lesson_;
    bool headless_ = false;
    std::string screenshot_, events_, log_;
    float scale_ = 1;
    std::optional<ui::ThemeKind> theme_;
    ParameterOptions parameters_;
};

}  // namespace

std::unique_ptr<ParsedCommand> add_explore(CLI::App& app) {
    return std::make_unique<Explore>(app);
}

}  // namespace momentscope
