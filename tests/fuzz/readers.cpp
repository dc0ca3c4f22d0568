#include "tests/fuzz/readers.hpp"

#include <imgui.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/event_player.hpp"
#include "core/chart/advice.hpp"
#include "core/chart/chart_csv.hpp"
#include "core/ray/ray_json.hpp"
#include "core/report/chart_html.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/support/error.hpp"
#include "core/support/input_file.hpp"
#include "core/support/json_text.hpp"
#include "core/support/output_file.hpp"
#include "core/table/run_table.hpp"
#include "core/techniques/configuration.hpp"
#include "ui/model/glossary.hpp"
#include "ui/model/lesson_file.hpp"
#include "ui/model/progress.hpp"
#include "ui/model/session.hpp"

namespace momentscope::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t MAX_INPUT_BYTES = std::uintmax_t{1} << 30;

void promise(bool kept, const char* what) {
    if (!kept) throw BrokenPromise(what);
}

void read_ray(const fs::path& file) {
    const std::string text = json_text(ray_to_json(read_ray_file(file)));
    promise(json_text(ray_to_json(ray_from_json(text))) == text, "A ray comes back as it was written.");
}

void read_session(const fs::path& file) {
    const ui::Session session = ui::read_session_file(file);
    if (session.state.scene.size() > 1000) return;
    try {
        ui::require_session_name(session.state.scene);
    } catch (const Error&) {
        return;
    }
    const std::string text = ui::session_text(session.state);
    promise(ui::session_text(ui::session_from_json(text).state) == text,
            "A session comes back as it was written.");
}

void read_lesson(const fs::path& file) {
    const ui::Lesson lesson = ui::read_lesson_file(file);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const ui::ExplorerState state = ui::lesson_state(lesson, i, true, {});
        promise(state.card == lesson.id && state.step == i, "A lesson can be opened at each step.");
        ui::text_runs(lesson.steps[i].action);
    }
}

void read_progress(const fs::path& file) {
    const ui::Progress progress = ui::progress_from_json(read_input_file(file, MAX_INPUT_BYTES, "input"));
    const std::string text = json_text(ui::progress_to_json(progress));
    promise(ui::progress_from_json(text) == progress, "Progress comes back as it was written.");
}

void read_chart(const RunTable& table, const std::string& name) {
    const Chart chart = chart_of(table, name);
    for (const std::span<const ChartRow> rows : scenes_of(chart))
        for (const AdviceBounds& bounds : {AdviceBounds{}, AdviceBounds{.max_bits = 300, .max_ms = 20}})
            advise(rows, bounds, HeldOutErrors(rows.size()));
    chart_to_markdown(chart, Metric::rmse);
    chart_to_svg(chart, Metric::flip);
    chart_to_html(chart, Metric::delta_e);
}

/// A file may contain several tables, separated by a line of equals signs: the shards of a run.
void read_tables(const fs::path& file) {
    constexpr std::string_view BETWEEN = "=====\n";
    std::string text = read_input_file(file, MAX_INPUT_BYTES, "input");
    std::vector<fs::path> shards;
    for (std::size_t end = 0; end != text.npos && shards.size() < 8;) {
        end = text.find(BETWEEN);
        shards.push_back(fs::path(file).concat("." + std::to_string(shards.size())));
        write_file(text.substr(0, end), shards.back());
        text.erase(0, end == text.npos ? end : end + BETWEEN.size());
    }
    const RunTable merged = merge_shards(shards);
    const std::string written = run_table_text(merged);
    if (setting(merged.settings, run_setting::COMMAND) == "chart") read_chart(merged, file.string());
}

void read_configurations(const fs::path& file) {
    const std::string text = read_input_file(file, MAX_INPUT_BYTES, "input");
    for (const std::string& one : split_configurations(text)) {
        const Configuration read = parse_configuration(one);
        const std::string again = configuration_text(read);
        promise(configuration_text(parse_configuration(again)) == again,
                "A configuration comes back as it was written.");
        configuration_options(read);
        stored_bits(*read.technique, read.values);
        bits_with_factor(*read.technique, read.values);
    }
}

void read_events(const fs::path& file) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().MousePos = {0, 0};
    HeadlessWindow window;
    try {
        EventPlayer(window).play_file(file);
    } catch (...) {
        ImGui::DestroyContext();
        throw;
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ImGui::DestroyContext();
    promise(std::abs(mouse.x) <= 1e6f && std::abs(mouse.y) <= 1e6f, "The mouse stays near the window.");
}

void read_mesh(const fs::path& file) {
    const Mesh mesh = read_mesh_here(file).mesh;
    promise(!mesh.indices.empty() && mesh.indices.size() % 3 == 0, "A mesh has triangles.");
    promise(mesh.normals.size() == mesh.positions.size(), "A vertex has a normal.");
    for (const std::uint32_t index : mesh.indices)
        promise(index < mesh.positions.size(), "Indices are in range.");
    for (const glm::vec3& p : mesh.positions)
        promise(glm::length(p) <= 1.001f, "Vertices lie within the unit sphere.");
    for (const glm::vec3& n : mesh.normals)
        promise(std::abs(glm::length(n) - 1.0f) < 1e-4f, "Normals are unit vectors.");
}

struct Reader {
    std::string_view name;
    void (*read)(const fs::path& file);
};

constexpr std::array READERS = {Reader{"ray", read_ray},       Reader{"session", read_session},
                                Reader{"lesson", read_lesson}, Reader{"progress", read_progress},
                                Reader{"table", read_tables},  Reader{"configuration", read_configurations},
                                Reader{"events", read_events}, Reader{"mesh", read_mesh}};

}  // namespace

void read_with(std::string_view reader, const fs::path& file) {
    for (const Reader& row : READERS)
        if (row.name == reader) return row.read(file);
    throw BrokenPromise("An input lies in a folder that is called like its reader.");
}

bool is_isolated(std::string_view reader) {
    return reader == "mesh";
}

}  // namespace momentscope::fuzz
