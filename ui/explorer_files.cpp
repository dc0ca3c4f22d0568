// explorer_files.cpp -- files that the window opens and saves.
#include <fmt/format.h>

#include "core/ray/ray_json.hpp"
#include "core/report/curve_output.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "core/support/output_file.hpp"
#include "ui/explorer.hpp"
#include "ui/session.hpp"

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

}  // namespace

void Explorer::open_session_dialog() {
    file_purpose_ = FilePurpose::open_session;
    files_.open(FileDialog::Mode::open, "Open session", {{"session", "session", ".json"}}, "");
}

void Explorer::save_session_dialog() {
    file_purpose_ = FilePurpose::save_session;
    files_.open(FileDialog::Mode::save, "Save session", {{"session", "session", ".json"}},
                "momentscope.json");
}

void Explorer::open_mesh_dialog() {
    file_purpose_ = FilePurpose::open_mesh;
    files_.open(FileDialog::Mode::open, "Open mesh", {{"any", "any file", ""}}, "");
}

void Explorer::open_ray_dialog() {
    file_purpose_ = FilePurpose::open_ray;
    files_.open(FileDialog::Mode::open, "Open view ray", {{"ray", "view ray", ".json"}}, "");
}

void Explorer::export_dialog() {
    file_purpose_ = FilePurpose::save_export;
    files_.open(FileDialog::Mode::save, "Export", EXPORTS, "curves.csv");
}

void Explorer::draw_chart_panel(const Ui& ui) {
    if (!chart_panel_.draw(ui, scene_, state_, message_)) return;
    file_purpose_ = FilePurpose::save_chart;
    files_.open(FileDialog::Mode::save, "Save chart", CHART_FILES, "chart.csv");
}

void Explorer::measure_chart() {
    state_.panel = Panel::chart;
    chart_panel_.start(scene_, state_, message_);
}

void Explorer::draw_files(const Ui& ui) {
    const std::optional<FileDialog::Choice> choice = files_.draw(ui);
    if (!choice) return;
    try {
        use_file(*choice);
    } catch (const Error& error) {
        message_ = error.what();
    }
}

void Explorer::use_file(const FileDialog::Choice& choice) {
    switch (file_purpose_) {
        case FilePurpose::open_session: {
            Session session = read_session_file(choice.path);
            state_ = std::move(session.state);
            if (!session.ignored.empty())
                message_ = fmt::format(
                    "The session was opened, but this version does not know these keys and ignored them: {}.",
                    fmt::join(session.ignored, ", "));
            break;
        }
        case FilePurpose::save_session:
            write_session_file(state_, choice.path);
            message_ = fmt::format("The session was saved to {}.", choice.path.string());
            break;
        case FilePurpose::open_mesh:
            choose_scene(state_, choice.path.string());
            break;
        case FilePurpose::open_ray:
            state_.ray = read_ray_file(choice.path);
            state_.marked.reset();
            state_.plot.depth.reset();
            state_.plot.value.reset();
            break;
        case FilePurpose::save_export:
            export_to(choice);
            break;
        case FilePurpose::save_chart:
            chart_panel_.write(choice.path);
            message_ = fmt::format("Written to {}.", choice.path.string());
            break;
    }
}

void Explorer::export_to(const FileDialog::Choice& choice) {
    const std::string kind = choice.kind->id;
    const ViewRay& ray = measurement_.capture.ray;
    std::vector<Curve> curves = {measurement_.curve};
    curves.insert(curves.end(), measurement_.compared.begin(), measurement_.compared.end());
    if (kind == "window_png") {
        window_export_ = choice.path;
        frames_to_export_ = 2;  // the current frame still shows the dialog
        return;                 // the code that writes it shows the message
    } else if (kind.starts_with("picture")) {
        if (state_.ray) throw Error("A view ray without a scene has no picture; choose a scene first.");
        write_image(renderer_.read_picture(), choice.path, tone_map_of(state_.parameters));
    } else if (kind == "curves_csv") {
        write_file(curves_to_csv(curves), choice.path);
    } else if (kind == "curves_json") {
        write_file(curves_to_json(ray, curves), choice.path);
    } else if (kind == "ray_json") {
        write_file(json_text(ray_to_json(ray), 1) + "\n", choice.path);
    } else {
        if (!state_.ray && !measurement_.light && measurement_.capture.transmittance.empty() &&
            !ray.fragments.empty())
            measurement_.capture = renderer_.capture_pixel(measurement_.pixel);
        const auto rows =
            pixel_history(ray, measurement_.capture.transmittance, *state_.technique, state_.parameters);
        write_file(pixel_history_to_csv(ray, rows), choice.path);
    }
    message_ = fmt::format("Written to {}.", choice.path.string());
}

}  // namespace momentscope::ui
