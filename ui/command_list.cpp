#include "ui/command_list.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/scene/scenes.hpp"
#include "ui/camera_moves.hpp"
#include "ui/command_rows.hpp"
#include "ui/explorer.hpp"
#include "ui/lessons.hpp"
#include "ui/ray_editor.hpp"

namespace momentscope::ui {

namespace {

// A command that switches a flag of the state.
Command flag(const char* id, const char* name, const char* key, const char* help,
             bool ExplorerState::*field) {
    return {id,
            name,
            {key},
            help,
            [field](Explorer& e) { e.state().*field = !(e.state().*field); },
            {},
            [field](const Explorer& e) { return e.state().*field; }};
}

void add_file(List& list) {
    list.push_back(plain("file.open_session", "Open session…", {"Ctrl+O"}, "Restores a saved session.",
                         [](Explorer& e) { e.open_session_dialog(); }));
    list.push_back(plain("file.save_session", "Save session…", {"Ctrl+S"}, "Saves all your choices as JSON.",
                         [](Explorer& e) { e.save_session_dialog(); }));
    list.push_back(plain("file.open_mesh", "Open mesh…", {"Ctrl+M"},
                         "Shows a mesh file as a transparent object.",
                         [](Explorer& e) { e.open_mesh_dialog(); }));
    list.push_back(plain("file.open_ray", "Open view ray…", {"Ctrl+J"}, "Plots a view ray from a JSON file.",
                         [](Explorer& e) { e.open_ray_dialog(); }));
    list.push_back(plain("file.export", "Export…", {"Ctrl+E"},
                         "Writes curves, fragments, the picture or the window to a file.",
                         [](Explorer& e) { e.export_dialog(); }));
}

void add_edit(List& list) {
    list.push_back({"edit.undo",
                    "Undo",
                    {"Ctrl+Z"},
                    "Undoes the last change.",
                    [](Explorer& e) { e.undo(); },
                    [](const Explorer& e) { return e.can_undo(); }});
    list.push_back({"edit.redo",
                    "Redo",
                    {"Ctrl+Y", "Ctrl+Shift+Z"},
                    "Repeats a change that was undone.",
                    [](Explorer& e) { e.redo(); },
                    [](const Explorer& e) { return e.can_redo(); }});
    list.push_back({"edit.delete_fragment",
                    "Delete fragment",
                    {"Delete"},
                    "Removes the marked fragment from a view ray without a scene.",
                    [](Explorer& e) { delete_marked(e.state()); },
                    [](const Explorer& e) { return e.state().ray && e.state().marked.has_value(); }});
    list.push_back(plain("edit.reset_parameters", "Reset parameters", {"R"},
                         "Sets all parameters to their defaults.",
                         [](Explorer& e) { e.state().parameters = {}; }));
    for (const Parameter& row : parameters()) {
        if (row.scale == Scale::toggle || row.scale == Scale::choice) continue;
        list.push_back({fmt::format("edit.type_{}", row.key),
                        fmt::format("Type {} {}…", row.name, row.symbol),
                        {},
                        "Lets you type a value for this parameter.",
                        [id = row.id](Explorer& e) { e.type_parameter(id); },
                        [id = row.id](const Explorer& e) { return e.state().technique->uses(id); }});
    }
    list.push_back(plain("edit.reset_all", "Reset everything", {}, "Restores the window as it first opens.",
                         [](Explorer& e) {
                             const ThemeKind theme = e.state().theme;
                             e.state() = ExplorerState();
                             e.state().theme = theme;
                         }));
}

void add_view(List& list) {
    list.push_back(flag("view.lens", "Pixel lens", "L",
                        "Magnifies the pixels around the picked one and shows their values.",
                        &ExplorerState::lens));
    list.push_back({"view.lens_zoom",
                    "Lens: closer",
                    {"Shift+L"},
                    "Shows fewer and larger pixels in the lens, at last with all digits, then starts over.",
                    [](Explorer& e) {
                        const LensZoom zoom = e.state().lens_zoom;
                        e.state().lens_zoom = zoom == zoomed(zoom, 1) ? LensZoom() : zoomed(zoom, 1);
                    },
                    [](const Explorer& e) { return e.state().lens; }});
    list.push_back(flag("view.failures", "Failed reconstructions", "O",
                        "Marks pixels where a reconstruction failed or was clamped.",
                        &ExplorerState::failures));
    list.push_back(of_picture("view.reset", "Reset camera", {"Home"}, "Returns to the scene's own camera.",
                              [](Explorer& e) { e.state().camera.reset(); }));
    list.push_back(of_picture("view.zoom_in", "Zoom in", {"+"}, "Moves the camera towards its target.",
                              [](Explorer& e) { e.state().camera = zoomed(e.camera(), 1); }));
    list.push_back(of_picture("view.zoom_out", "Zoom out", {"-"}, "Moves the camera away from its target.",
                              [](Explorer& e) { e.state().camera = zoomed(e.camera(), -1); }));
    for (const NamedView& view : named_views())
        list.push_back(
            of_picture(fmt::format("view.{}", view.id), view.name, {}, "Looks from this direction.",
                       [&view](Explorer& e) { e.state().camera = looking_from(e.camera(), view); }));
}

void add_tabs_and_theme(List& list) {
    for (std::size_t index = 0; index < PANEL_NAMES.size(); ++index) {
        const auto panel = static_cast<Panel>(index);
        list.push_back(choice(
            fmt::format("view.panel{}", index + 1), fmt::format("Tab: {}", PANEL_NAMES[index]),
            {fmt::format("Ctrl+{}", index + 1)}, "Opens this tab below the plot.",
            [panel](Explorer& e) { e.state().panel = panel; },
            [panel](const Explorer& e) { return e.state().panel == panel; }));
    }
    const auto light = [](const Explorer& e) { return e.state().theme == ThemeKind::light; };
    list.push_back(choice(
        "view.theme", "Light theme", {"Ctrl+T"}, "Switches to a light theme, which suits a projector.",
        [light](Explorer& e) { e.state().theme = light(e) ? ThemeKind::dark : ThemeKind::light; }, light));
}

void add_arrows(List& list) {
    const struct {
        const char* key;
        const char* name;
        glm::ivec2 step;
    } arrows[] = {{"Left", "left", {-1, 0}},
                  {"Right", "right", {1, 0}},
                  {"Up", "up", {0, -1}},
                  {"Down", "down", {0, 1}}};
    for (const auto& arrow : arrows) {
        list.push_back(of_picture(fmt::format("pixel.{}", arrow.name),
                                  fmt::format("One pixel {}", arrow.name), {arrow.key}, "Moves the pick.",
                                  [step = arrow.step](Explorer& e) { e.move_pick(step); }));
        list.push_back(of_picture(fmt::format("pixel.{}10", arrow.name),
                                  fmt::format("Ten pixels {}", arrow.name),
                                  {fmt::format("Shift+{}", arrow.key)}, "Moves the pick.",
                                  [step = 10 * arrow.step](Explorer& e) { e.move_pick(step); }));
    }
}

void add_pixel(List& list) {
    add_arrows(list);
    list.push_back(of_picture("pixel.go_to", "Go to…", {"Ctrl+G"}, "Lets you type the pixel to pick.",
                              [](Explorer& e) { e.type_pixel(); }));
    list.push_back(of_picture("pixel.pin", "Pin", {"P"},
                              "Keeps a small plot of this pixel, or removes it; at most four can be pinned.",
                              [](Explorer& e) { e.toggle_pin(); }));
    list.push_back({"pixel.unpin_all",
                    "Remove all pins",
                    {"Shift+P"},
                    "Closes the small plots.",
                    [](Explorer& e) { e.state().pins.clear(); },
                    [](const Explorer& e) { return !e.state().pins.empty(); }});
    list.push_back(plain("pixel.next_fragment", "Next fragment", {"N"}, "Marks the next fragment behind.",
                         [](Explorer& e) { e.mark_next(1); }));
    list.push_back(plain("pixel.previous_fragment", "Previous fragment", {"Shift+N"},
                         "Marks the next fragment in front.", [](Explorer& e) { e.mark_next(-1); }));
}

void add_registries(List& list) {
    std::size_t digit = 1;
    for (const Technique& technique : techniques()) {
        const Keys keys = digit <= 9 ? Keys{fmt::format("{}", digit)} : Keys{};
        ++digit;
        list.push_back(choice(
            fmt::format("technique.{}", technique.id), fmt::format("{} ({})", technique.name, technique.id),
            keys, "Draws the picture with this technique.",
            [&technique](Explorer& e) { e.state().technique = &technique; },
            [&technique](const Explorer& e) { return e.state().technique == &technique; }));
    }
    for (const SceneEntry& entry : scene_entries())
        list.push_back(choice(
            fmt::format("scene.{}", entry.id), entry.id, {}, entry.description,
            [&entry](Explorer& e) { choose_scene(e.state(), entry.id); },
            [&entry](const Explorer& e) { return !e.state().ray && e.state().scene == entry.id; }));
    for (const Lesson& lesson : lessons())
        list.push_back(choice(
            fmt::format("try.{}", lesson.id), lesson.title, {}, lesson.question,
            [&lesson](Explorer& e) { open_lesson(e.state(), lesson); },
            [&lesson](const Explorer& e) { return e.state().card == lesson.id; }));
}

void add_help(List& list) {
    list.push_back(choice(
        "help.keys", "Keys and mouse", {"?", "F1"}, "Lists every key and what the mouse does.",
        [](Explorer& e) { e.toggle_help(); }, [](const Explorer& e) { return e.shows_help(); }));
    list.push_back(plain("help.palette", "All commands…", {"Ctrl+Shift+P"},
                         "Finds a command by typing parts of its name.",
                         [](Explorer& e) { e.toggle_palette(); }));
    list.push_back(plain(
        "help.close", "Close", {"Escape"},
        "Closes the first of these that is there: a list or menu, a dialog, the help, the message, the region, the card.",
        [](Explorer& e) { e.close_topmost(); }));
}

}  // namespace

std::vector<Command> make_command_list() {
    List list;
    for (const auto add : {add_file, add_edit, add_view, add_tabs_and_theme, add_pixel, add_compare, add_plot,
                           add_registries, add_help})
        add(list);
    return list;
}

}  // namespace momentscope::ui
