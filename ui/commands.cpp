#include "ui/commands.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "core/scene/scenes.hpp"
#include "ui/camera_moves.hpp"
#include "ui/explorer.hpp"
#include "ui/lessons.hpp"

namespace momentscope::ui {

namespace {

constexpr Menu MENUS[] = {{"file", "File"},   {"edit", "Edit"},    {"view", "View"},
                          {"pixel", "Pixel"}, {"plot", "Plot"},    {"technique", "Technique"},
                          {"scene", "Scene"}, {"try", "Try this"}, {"help", "Help"}};

constexpr MouseAction MOUSE_ACTIONS[] = {
    {"scene", "left click or drag", "picks a pixel"},
    {"scene", "right drag", "orbits"},
    {"scene", "middle drag", "pans"},
    {"scene", "wheel", "zooms"},
    {"plot", "left click or drag", "moves the query depth; a click on a step marks its fragment"},
    {"plot", "right or middle drag", "pans"},
    {"plot", "wheel", "zooms at the mouse"},
    {"an axis of the plot", "wheel or drag", "zooms or pans that axis alone"},
    {"plot", "double-click", "fits; on an axis that axis alone"},
    {"legend", "click, hover", "shows or hides; highlights"},
    {"slider", "Ctrl+click", "types a value"},
    {"slider", "double-click", "resets"},
    {"table row", "click", "marks the fragment in the plot"}};

bool has_picture(const Explorer& e) {
    return !e.state().ray;
}

void add_file_and_edit(std::vector<Command>& list) {
    list.push_back(
        {"file.open_session", "Open session…", {"Ctrl+O"}, "Restores a saved session.", [](Explorer& e) {
             e.open_session_dialog();
         }});
    list.push_back({"file.save_session",
                    "Save session…",
                    {"Ctrl+S"},
                    "Saves everything that is chosen, as JSON.",
                    [](Explorer& e) { e.save_session_dialog(); }});
    list.push_back({"file.open_mesh",
                    "Open mesh…",
                    {"Ctrl+M"},
                    "Shows a mesh file as a transparent object.",
                    [](Explorer& e) { e.open_mesh_dialog(); }});
    list.push_back({"file.open_ray",
                    "Open view ray…",
                    {"Ctrl+J"},
                    "Plots a view ray from a JSON file.",
                    [](Explorer& e) { e.open_ray_dialog(); }});
    list.push_back({"file.export",
                    "Export…",
                    {"Ctrl+E"},
                    "Writes curves, fragments, picture or window to a file.",
                    [](Explorer& e) { e.export_dialog(); }});
    list.push_back({"edit.undo",
                    "Undo",
                    {"Ctrl+Z"},
                    "Takes the last change back.",
                    [](Explorer& e) { e.undo(); },
                    [](const Explorer& e) { return e.can_undo(); }});
    list.push_back({"edit.redo",
                    "Redo",
                    {"Ctrl+Y", "Ctrl+Shift+Z"},
                    "Makes a change again that was taken back.",
                    [](Explorer& e) { e.redo(); },
                    [](const Explorer& e) { return e.can_redo(); }});
    list.push_back({"edit.reset_parameters",
                    "Reset parameters",
                    {"R"},
                    "All parameters as at the start.",
                    [](Explorer& e) { e.state().parameters = {}; }});
    for (const Parameter& row : parameters()) {
        if (row.scale == Scale::toggle) continue;
        list.push_back({fmt::format("edit.type_{}", row.key),
                        fmt::format("Type {} {}…", row.name, row.symbol),
                        {},
                        "Opens the control for a number from the keyboard.",
                        [id = row.id](Explorer& e) { e.type_parameter(id); },
                        [id = row.id](const Explorer& e) { return e.state().technique->uses(id); }});
    }
    list.push_back(
        {"edit.reset_all", "Reset everything", {}, "The window as it first opens.", [](Explorer& e) {
             const ThemeKind theme = e.state().theme;
             e.state() = ExplorerState();
             e.state().theme = theme;
         }});
}

void add_view(std::vector<Command>& list) {
    list.push_back(
        {"view.truth", "Ground truth", {"G"}, "Shows the sorted fragments as long as the key is held.", {}});
    list.push_back({"view.lens",
                    "Pixel lens",
                    {"L"},
                    "Magnifies the pixels around the picked one, with their values.",
                    [](Explorer& e) { e.state().lens = !e.state().lens; },
                    {},
                    [](const Explorer& e) { return e.state().lens; }});
    list.push_back({"view.failures",
                    "Failed reconstructions",
                    {"O"},
                    "Marks pixels whose reconstruction failed or was clamped.",
                    [](Explorer& e) { e.state().failures = !e.state().failures; },
                    {},
                    [](const Explorer& e) { return e.state().failures; }});
    list.push_back({"view.reset",
                    "Reset camera",
                    {"Home"},
                    "Back to the scene's own camera.",
                    [](Explorer& e) { e.state().camera.reset(); },
                    has_picture});
    list.push_back({"view.zoom_in",
                    "Zoom in",
                    {"+"},
                    "Moves the camera towards its target.",
                    [](Explorer& e) { e.state().camera = zoomed(e.camera(), 1); },
                    has_picture});
    list.push_back({"view.zoom_out",
                    "Zoom out",
                    {"-"},
                    "Moves the camera away from its target.",
                    [](Explorer& e) { e.state().camera = zoomed(e.camera(), -1); },
                    has_picture});
    for (const NamedView& view : named_views())
        list.push_back({fmt::format("view.{}", view.id),
                        view.name,
                        {},
                        "Looks from this direction.",
                        [&view](Explorer& e) { e.state().camera = looking_from(e.camera(), view); },
                        has_picture});
    for (const Panel panel : {Panel::controls, Panel::fragments, Panel::technique}) {
        const auto index = static_cast<std::size_t>(panel);
        list.push_back({fmt::format("view.panel{}", index + 1),
                        fmt::format("Tab: {}", PANEL_NAMES[index]),
                        {fmt::format("Ctrl+{}", index + 1)},
                        "Opens this tab below the plot.",
                        [panel](Explorer& e) { e.state().panel = panel; },
                        {},
                        [panel](const Explorer& e) { return e.state().panel == panel; }});
    }
    list.push_back({"view.theme",
                    "Light theme",
                    {"Ctrl+T"},
                    "Dark on light, as for a projector.",
                    [](Explorer& e) {
                        e.state().theme =
                            e.state().theme == ThemeKind::dark ? ThemeKind::light : ThemeKind::dark;
                    },
                    {},
                    [](const Explorer& e) { return e.state().theme == ThemeKind::light; }});
}

void add_pixel(std::vector<Command>& list) {
    const struct {
        const char* key;
        const char* name;
        glm::ivec2 step;
    } arrows[] = {{"Left", "left", {-1, 0}},
                  {"Right", "right", {1, 0}},
                  {"Up", "up", {0, -1}},
                  {"Down", "down", {0, 1}}};
    for (const auto& arrow : arrows)
        for (const int distance : {1, 10})
            list.push_back({fmt::format("pixel.{}{}", arrow.name, distance == 1 ? "" : "10"),
                            fmt::format("{} {}", distance == 1 ? "One pixel" : "Ten pixels", arrow.name),
                            {fmt::format("{}{}", distance == 1 ? "" : "Shift+", arrow.key)},
                            "Moves the pick.",
                            [step = distance * arrow.step](Explorer& e) { e.move_pick(step); },
                            has_picture});
    list.push_back({"pixel.go_to",
                    "Go to…",
                    {"Ctrl+G"},
                    "Type the pixel to pick.",
                    [](Explorer& e) { e.type_pixel(); },
                    has_picture});
    list.push_back({"pixel.pin",
                    "Pin",
                    {"P"},
                    "Keeps a small plot of this pixel, or removes it; at most four.",
                    [](Explorer& e) { e.toggle_pin(); },
                    has_picture});
    list.push_back({"pixel.unpin_all",
                    "Remove all pins",
                    {"Shift+P"},
                    "Closes the small plots.",
                    [](Explorer& e) { e.state().pins.clear(); },
                    [](const Explorer& e) { return !e.state().pins.empty(); }});
    list.push_back(
        {"pixel.next_fragment", "Next fragment", {"N"}, "Marks the next fragment behind.", [](Explorer& e) {
             e.mark_next(1);
         }});
    list.push_back({"pixel.previous_fragment",
                    "Previous fragment",
                    {"Shift+N"},
                    "Marks the next fragment in front.",
                    [](Explorer& e) { e.mark_next(-1); }});
}

void add_plot(std::vector<Command>& list) {
    list.push_back(
        {"plot.fit", "Fit", {"F"}, "Shows the whole ray.", [](Explorer& e) { fit(e.state().plot); }});
    list.push_back({"plot.quantity",
                    "Transmittance",
                    {"T"},
                    "Plots T(z) instead of A(z).",
                    [](Explorer& e) {
                        const bool shown = e.state().plot.quantity == Quantity::transmittance;
                        set_quantity(e.state().plot, shown ? Quantity::absorbance : Quantity::transmittance);
                    },
                    {},
                    [](const Explorer& e) { return e.state().plot.quantity == Quantity::transmittance; }});
    list.push_back({"plot.axis",
                    "View depth",
                    {"D"},
                    "Plots over view depth instead of warped depth.",
                    [](Explorer& e) {
                        const bool shown = e.state().plot.axis == DepthAxis::view;
                        set_depth_axis(e.state().plot, shown ? DepthAxis::warped : DepthAxis::view);
                    },
                    [](const Explorer& e) { return e.measurement().capture.ray.warp.logarithmic; },
                    [](const Explorer& e) { return e.state().plot.axis == DepthAxis::view; }});
    const struct {
        Series series;
        const char* key;
        const char* name;
    } switches[] = {{Series::truth, "U", "Truth"},
                    {Series::reconstruction, "K", "Reconstruction"},
                    {Series::bounds, "B", "Band"},
                    {Series::ghost, "X", "Exact, no bias"},
                    {Series::stems, "C", "Canonical masses"},
                    {Series::errors, "E", "Errors at own depths"},
                    {Series::wrapping_zone, "Z", "Wrapping zone"}};
    for (const auto& one : switches) {
        const auto index = static_cast<std::size_t>(one.series);
        list.push_back({fmt::format("plot.{}", SERIES_KEYS[index]),
                        one.name,
                        {one.key},
                        "Shows or hides it in the plot.",
                        [index](Explorer& e) { e.state().plot.shown[index] = !e.state().plot.shown[index]; },
                        {},
                        [index](const Explorer& e) { return e.state().plot.shown[index]; }});
    }
}

void add_choices(std::vector<Command>& list) {
    std::size_t digit = 1;
    for (const Technique& technique : techniques()) {
        std::vector<std::string> keys;
        if (digit <= 9) keys.push_back(fmt::format("{}", digit));
        ++digit;
        list.push_back({fmt::format("technique.{}", technique.id),
                        fmt::format("{} ({})", technique.name, technique.id),
                        keys,
                        "Draws the picture with this technique.",
                        [&technique](Explorer& e) { e.state().technique = &technique; },
                        {},
                        [&technique](const Explorer& e) { return e.state().technique == &technique; }});
    }
    for (const SceneEntry& entry : scene_entries())
        list.push_back(
            {fmt::format("scene.{}", entry.id),
             entry.id,
             {},
             entry.description,
             [&entry](Explorer& e) { choose_scene(e.state(), entry.id); },
             {},
             [&entry](const Explorer& e) { return !e.state().ray && e.state().scene == entry.id; }});
    for (const Lesson& lesson : lessons())
        list.push_back({fmt::format("try.{}", lesson.id),
                        lesson.title,
                        {},
                        lesson.question,
                        [&lesson](Explorer& e) { open_lesson(e.state(), lesson); },
                        {},
                        [&lesson](const Explorer& e) { return e.state().card == lesson.id; }});
}

void add_help(std::vector<Command>& list) {
    list.push_back({"help.keys",
                    "Keys and mouse",
                    {"?", "F1"},
                    "Lists every key and what the mouse does.",
                    [](Explorer& e) { e.toggle_help(); },
                    {},
                    [](const Explorer& e) { return e.shows_help(); }});
    list.push_back({"help.palette",
                    "All commands…",
                    {"Ctrl+Shift+P"},
                    "Finds a command by typing parts of its name.",
                    [](Explorer& e) { e.toggle_palette(); }});
    list.push_back({"help.close",
                    "Close",
                    {"Escape"},
                    "Closes a dialog, the help or the message; else the open card.",
                    [](Explorer& e) { e.close_topmost(); }});
}

std::vector<Command> make_commands() {
    std::vector<Command> list;
    add_file_and_edit(list);
    add_view(list);
    add_pixel(list);
    add_plot(list);
    add_choices(list);
    add_help(list);
    return list;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> list = make_commands();
    return list;
}

std::span<const Menu> menus() {
    return MENUS;
}

std::span<const MouseAction> mouse_actions() {
    return MOUSE_ACTIONS;
}

bool is_enabled(const Command& command, const Explorer& explorer) {
    return !command.enabled || command.enabled(explorer);
}

void run_pressed_commands(Explorer& explorer) {
    // A dialog keeps the keyboard to itself; of the commands, Escape alone reaches through.
    const bool dialog = explorer.shows_file_dialog() || explorer.shows_palette() || explorer.busy();
    const bool typing = ImGui::GetIO().WantTextInput;  // Ctrl+Z then belongs to the text
    for (const Command& command : commands()) {
        if (!command.run || !is_enabled(command, explorer)) continue;
        if (dialog && command.id != "help.close" && command.id != "help.palette") continue;
        if (typing && command.id.starts_with("edit.")) continue;
        const bool repeats = command.id.starts_with("pixel.") || command.id.starts_with("edit.");
        for (const std::string& key : command.keys)
            if (const auto shortcut = parse_shortcut(key); shortcut && pressed(*shortcut, repeats)) {
                command.run(explorer);
                break;
            }
    }
}

}  // namespace momentscope::ui
