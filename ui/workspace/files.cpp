#include "ui/workspace/files.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/ray/ray_json.hpp"
#include "core/report/curve_output.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/json_text.hpp"
#include "core/support/output_file.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/session.hpp"
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

namespace {

const std::vector<FileKind> EXPORTS = {{"curves_csv", "curves (CSV)", ".csv"},
                                       {"curves_json", "view ray and curves (JSON)", ".json"},
                                       {"fragments_csv", "fragments of the pixel (CSV)", ".csv"},
                                       {"ray_json", "view ray, to be opened again (JSON)", ".json"},
                                       {"picture_png", "picture (PNG, 8-bit sRGB)", ".png"},
                                       {"picture_exr", "picture (EXR, linear floats)", ".exr"},
                                       {"window_png", "whole window (PNG)", ".png"}};

const std::vector<FileKind> CHART_FILES = {{"chart_csv", "rows (CSV), also for advise --chart", ".csv"},
                                           {"chart_html", "chart (HTML page)", ".html"},
                                           {"chart_svg", "chart (SVG)", ".svg"},
                                           {"chart_md", "table (Markdown)", ".md"}};

// By the key with the version that sessions and lessons have.
bool has_key(const std::string& text, const char* key) {
    return text.find(key) != std::string::npos;
}

void add_lessons(const std::filesystem::path& path, Workspace& w) {
    const Course::Added added = w.course.add(path);
    ui::open_lesson(w.state, *added.first);
    const std::size_t more = added.problems.size();
    if (more > 0)
        w.status.say(more == 1 ? added.problems.front()
                               : fmt::format("{} And {} more.", added.problems.front(), more - 1));
}

}  // namespace

void Files::open(Purpose purpose, const char* title, const FileKind& kind) {
    purpose_ = purpose;
    if (host_.choose_file)
        host_.choose_file(kind.extension);
    else
        dialog_.open(FileDialog::Mode::open, title, {kind}, "");
}

void Files::open_session() {
    open(Purpose::open_session, "Open session", {"session", "session", ".json"});
}

void Files::save_session() {
    purpose_ = Purpose::save_session;
    dialog_.open(FileDialog::Mode::save, "Save session", {{"session", "session", ".json"}},
                 "momentscope.json");
}

void Files::open_mesh() {
    open(Purpose::open_mesh, "Open mesh", {"any", "any file", ""});
}

void Files::open_ray() {
    open(Purpose::open_ray, "Open view ray", {"ray", "view ray", ".json"});
}

void Files::open_dropped(const std::filesystem::path& path) {
    std::error_code code;
    purpose_ = path.extension() == ".json"                 ? Purpose::open_json
               : std::filesystem::is_directory(path, code) ? Purpose::open_lesson
                                                           : Purpose::open_mesh;
    open_chosen(path);
}

void Files::open_lesson() {
    open(Purpose::open_lesson, "Open lesson", {"lesson", "lesson", ".json"});
}

void Files::save_answers() {
    purpose_ = Purpose::save_answers;
    dialog_.open(FileDialog::Mode::save, "Export answers", {{"answers", "answers (Markdown)", ".md"}},
                 "answers.md");
}

void Files::save_export() {
    purpose_ = Purpose::save_export;
    dialog_.open(FileDialog::Mode::save, "Export", EXPORTS, "curves.csv");
}

void Files::save_chart() {
    purpose_ = Purpose::save_chart;
    dialog_.open(FileDialog::Mode::save, "Save chart", CHART_FILES, "chart.csv");
}

void Files::draw(const Ui& ui, Workspace& w) {
    std::optional<FileDialog::Choice> choice = dialog_.draw(ui);
    if (chosen_ && !w.scene.is_reading()) choice = std::exchange(chosen_, std::nullopt);
    if (!choice) return;
    try {
        use(*choice, w);
    } catch (const Error& error) {
        w.status.say(error.what());
    }
}

std::optional<std::filesystem::path> Files::take_window_export() {
    if (!window_export_ || --frames_to_export_ > 0) return std::nullopt;
    return std::exchange(window_export_, std::nullopt);
}

void Files::say_written(const std::filesystem::path& path, Workspace& w) const {
    if (host_.deliver) {
        host_.deliver(path);
        w.status.say(fmt::format("Your browser saves {}.", path.filename().string()));
    } else {
        w.status.say(fmt::format("Written to {}.", path.string()));
    }
}

void Files::use(const FileDialog::Choice& choice, Workspace& w) {
    if (purpose_ == Purpose::open_json) {
        const std::string text = read_input_file(choice.path, MAX_SESSION_BYTES, "dropped");
        purpose_ = has_key(text, "\"momentscope_session\"")  ? Purpose::open_session
                   : has_key(text, "\"momentscope_lesson\"") ? Purpose::open_lesson
                                                             : Purpose::open_ray;
        if (purpose_ == Purpose::open_ray && !has_key(text, "\"fragments\""))
            throw Error(
                fmt::format("'{}' is neither a session nor a lesson nor a view ray; drop another file.",
                            choice.path.filename().string()));
        if (purpose_ == Purpose::open_ray && !has_key(text, "\"fragments\""))
            throw Error(
                fmt::format("'{}' is neither a session nor a lesson nor a view ray; drop another file.",
                            choice.path.filename().string()));
    }
    switch (purpose_) {
        case Purpose::open_session: {
            Session session = read_session_file(choice.path);
            w.state = std::move(session.state);
            if (!session.ignored.empty())
                w.status.say(fmt::format(
                    "The session was opened, but this version does not know these keys and ignored them: {}.",
                    fmt::join(session.ignored, ", ")));
            break;
        }
        case Purpose::save_session:
            write_session_file(w.state, choice.path);
            if (host_.deliver)
                say_written(choice.path, w);
            else
                w.status.say(fmt::format("The session was saved to {}.", choice.path.string()));
            break;
        case Purpose::open_mesh:
            choose_scene(w.state, choice.path.string());
            break;
        case Purpose::open_ray:
            ui::open_ray(w.state, read_ray_file(choice.path));
            break;
        case Purpose::open_lesson:
            add_lessons(choice.path, w);
            break;
        case Purpose::save_answers:
            write_file(answers_text(w.course.lessons(), w.lesson.progress), choice.path);
            say_written(choice.path, w);
            break;
        case Purpose::save_export:
            write_export(choice, w);
            break;
        case Purpose::save_chart:
            w.chart.write(choice.path, w.gl);
            say_written(choice.path, w);
            break;
        case Purpose::open_json:
            break;
    }
}

void Files::write_export(const FileDialog::Choice& choice, Workspace& w) {
    const std::string kind = choice.kind->id;
    Renderer& renderer = w.picture.renderer();
    const Measurement& measurement = w.measurement();
    const ViewRay& ray = measurement.capture.ray;
    std::vector<Curve> curves = {measurement.curve};
    curves.insert(curves.end(), measurement.compared.begin(), measurement.compared.end());
    if (kind == "window_png") {
        window_export_ = choice.path;
        frames_to_export_ = 2;  // the current frame still shows the dialog
        return;                 // the code that writes it shows the message
    } else if (kind.starts_with("picture")) {
        if (w.state.ray) throw Error("A view ray without a scene has no picture; choose a scene first.");
        write_image(renderer.read_picture(), choice.path, tone_map_of(w.state.parameters));
    } else if (kind == "curves_csv") {
        write_file(curves_to_csv(curves), choice.path);
    } else if (kind == "curves_json") {
        write_file(curves_to_json(ray, curves), choice.path);
    } else if (kind == "ray_json") {
        write_file(json_text(ray_to_json(ray), 1) + "\n", choice.path);
    } else {
        if (!w.state.ray) w.picked.require_transmittances(renderer);
        const auto rows =
            pixel_history(ray, measurement.capture.transmittance, *w.state.technique, w.state.parameters);
        write_file(pixel_history_to_csv(ray, rows), choice.path);
    }
    say_written(choice.path, w);
}

}  // namespace momentscope::ui
