// main.cpp -- the functions that the page's scripts call. Texts are UTF-8. A function that can fail returns
// what went wrong, as a sentence, or "".
#include <emscripten.h>
#include <fmt/format.h>
#include <glad/gl.h>
#include <imgui.h>

#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/image/image.hpp"
#include "core/inspect/curve.hpp"
#include "core/ray/ray_json.hpp"
#include "core/report/curve_output.hpp"
#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "page/host_calls.hpp"
#include "page/page.hpp"
#include "ui/model/link.hpp"

namespace momentscope {

namespace {

std::unique_ptr<Page> page;
std::string answer;  // of the last function that returned a text

const char* said(std::string text) {
    answer = std::move(text);
    return answer.c_str();
}

// What went wrong, or "".
template <typename Function>
const char* trouble(const Function& function) {
    try {
        function();
        return said("");
    } catch (const std::exception& error) {
        return said(error.what());
    }
}

// A link cannot hold the mesh that it shows.
void require_mesh(const std::string& scene) {
    std::error_code code;
    const std::filesystem::path path(scene);
    if (is_builtin_scene(scene) || std::filesystem::exists(path, code)) return;
    throw Error(fmt::format(
        "The link shows the mesh '{}', which it does not hold; open that file here first, then the link again.",
        path.filename().string()));
}

// The state of a link: `session` as link_text writes it, or "", and words over it.
ui::ExplorerState state_of(const std::string& session, const std::string& words) {
    ui::ExplorerState state;
    if (!session.empty()) state = ui::session_from_json(session).state;
    state = ui::state_of_words(words, std::move(state));
    if (!state.ray) require_mesh(state.scene);
    return state;
}

}  // namespace

}  // namespace momentscope

using namespace momentscope;

extern "C" {

/// A text that the browser has kept. Call it before page_start.
EMSCRIPTEN_KEEPALIVE void page_kept(const char* name, const char* text) {
    kept_texts()[name] = text;
}

/// Begins. If the link is wrong, begins with the state of a fresh window and says what is wrong with the link
/// in the status line.
EMSCRIPTEN_KEEPALIVE const char* page_start(int width, int height, float scale, const char* session,
                                            const char* words, const char* part, const char* controls) {
    return trouble([&] {
        make_web_context();
        std::string wrong;
        ui::ExplorerState start;
        ui::Embedding embedding;
        try {
            embedding = ui::parse_embedding(part, controls);
            start = state_of(session, words);
        } catch (const Error& error) {
            wrong = error.what();
        }
        page = std::make_unique<Page>(start, embedding, glm::ivec2(width, height), scale);
        if (session[0] == '\0') page->workspace().state.theme = page->workspace().settings.theme;
        if (!wrong.empty()) page->workspace().status.say(wrong);
    });
}

/// Begins again with the same state after the GL lost everything.
EMSCRIPTEN_KEEPALIVE const char* page_restore(int width, int height, float scale) {
    return trouble([&] {
        const ui::ExplorerState state = page->workspace().state;
        const ui::Embedding embedding = page->workspace().options.embedding;
        page.reset();
        while (glGetError() != GL_NO_ERROR) {  // from deleting what the GL has lost
        }
        prepare_web_context();
        page = std::make_unique<Page>(state, embedding, glm::ivec2(width, height), scale);
    });
}

EMSCRIPTEN_KEEPALIVE const char* page_frame(double seconds) {
    return trouble([&] { page->frame(seconds); });
}
EMSCRIPTEN_KEEPALIVE bool page_due() {
    return page->due();
}
EMSCRIPTEN_KEEPALIVE void page_resize(int width, int height, float scale) {
    page->resize({width, height}, scale);
}

// Input. Places are in pixels of the canvas.
EMSCRIPTEN_KEEPALIVE void page_move(float x, float y) {
    page->push(ui::InputQueue::Move{{x, y}});
}
EMSCRIPTEN_KEEPALIVE void page_leave() {
    page->push(ui::InputQueue::Move{ui::InputQueue::OUTSIDE});
}
EMSCRIPTEN_KEEPALIVE void page_button(int which, bool down) {
    page->push(ui::InputQueue::Button{which, down});
}
EMSCRIPTEN_KEEPALIVE void page_wheel(float x, float y) {
    page->push(ui::InputQueue::Wheel{{x, y}});
}
EMSCRIPTEN_KEEPALIVE void page_key(int number, bool down) {
    page->push(ui::InputQueue::Key{number, down});
}
EMSCRIPTEN_KEEPALIVE void page_character(unsigned code) {
    page->push(ui::InputQueue::Character{code});
}
EMSCRIPTEN_KEEPALIVE void page_focus(bool here) {
    page->push(ui::InputQueue::Focus{here});
}

/// Is a text being edited?
EMSCRIPTEN_KEEPALIVE bool page_types() {
    return ImGui::GetIO().WantTextInput;
}

/// ImGuiMouseCursor_
EMSCRIPTEN_KEEPALIVE int page_cursor() {
    return ImGui::GetMouseCursor();
}

/// Shows the state of a link.
EMSCRIPTEN_KEEPALIVE const char* page_open(const char* session, const char* words) {
    return trouble([&] { page->open(state_of(session, words)); });
}

/// The link of a new step, or "".
EMSCRIPTEN_KEEPALIVE const char* page_step() {
    return said(page->take_step());
}

/// The link of the state.
EMSCRIPTEN_KEEPALIVE const char* page_link() {
    return said(ui::link_text(page->workspace().state));
}

/// A file that was chosen, or dropped.
EMSCRIPTEN_KEEPALIVE void page_file(const char* path, bool dropped) {
    ui::Files& files = page->workspace().files;
    if (dropped)
        files.open_dropped(path);
    else
        files.open_chosen(path);
    page->push(ui::InputQueue::Focus{true});
}

/// Shows a sentence in the status line.
EMSCRIPTEN_KEEPALIVE void page_say(const char* sentence) {
    page->workspace().status.say(sentence);
    page->push(ui::InputQueue::Focus{true});
}

/// The message in the status line.
EMSCRIPTEN_KEEPALIVE const char* page_message() {
    return said(page->workspace().status.message);
}

/// The view ray and its curves as JSON, as `momentscope inspect` writes them.
EMSCRIPTEN_KEEPALIVE const char* page_curves() {
    const ui::Measurement& measurement = page->workspace().measurement();
    std::vector<Curve> curves = {measurement.curve};
    curves.insert(curves.end(), measurement.compared.begin(), measurement.compared.end());
    return said(curves_to_json(measurement.capture.ray, curves));
}

/// What `momentscope inspect --ray … --technique … --samples N --format json` prints, or {"error": a
/// sentence}.
EMSCRIPTEN_KEEPALIVE const char* page_inspect(const char* ray_text, const char* configuration_text,
                                              int samples) {
    try {
        const ViewRay ray = ray_from_json(ray_text);
        const Configuration configuration = parse_configuration(configuration_text);
        const Curve curve = sample_curve(ray, *configuration.technique, configuration.values,
                                         even_depths(static_cast<std::size_t>(samples)));
        return said(curves_to_json(ray, {curve}));
    } catch (const std::exception& error) {
        return said(json_text(nlohmann::json{{"error", error.what()}}));
    }
}

/// Writes a picture to a file, like `momentscope render`.
EMSCRIPTEN_KEEPALIVE const char* page_render(const char* scene_id, const char* configuration_text, int width,
                                             int height, const char* path) {
    return trouble([&] {
        const Configuration configuration = parse_configuration(configuration_text);
        const Scene scene = load_scene(scene_id, configuration.values.number(ParameterId::opacity));
        Renderer renderer(page->programs());
        renderer.set_scene(scene);
        renderer.render({scene.camera, {width, height}, configuration.technique, configuration.values});
        write_image(renderer.read_picture(), path);
    });
}

/// Why a technique does not run here, or "".
EMSCRIPTEN_KEEPALIVE const char* page_why_not(const char* technique) {
    return said(why_unavailable(require_technique(technique), page->programs()->gl()));
}

/// The widgets of the last frame as JSON: {"id": [left, top, right, bottom], ...}. For tests.
EMSCRIPTEN_KEEPALIVE const char* page_widgets() {
    nlohmann::json all = nlohmann::json::object();
    for (const auto& [id, rect] : page->workspace().widget_rects)
        all[id] = {rect.low.x, rect.low.y, rect.high.x, rect.high.y};
    return said(json_text(all));
}
}

int main() {
    emscripten_exit_with_live_runtime();
}
