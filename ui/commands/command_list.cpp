#include "ui/commands/command_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/scene/scenes.hpp"
#include "ui/commands/command_rows.hpp"
#include "ui/model/camera_moves.hpp"
#include "ui/model/selection.hpp"
#include "ui/workspace/presenting.hpp"
#include "ui/workspace/workspace.hpp"

namespace momentscope::ui {

namespace {

// A command that switches a flag of the state.
Command flag(const char* id, const char* name, const char* key, const char* help,
             bool ExplorerState::*field) {
    return {id,
            name,
            {key},
            help,
            [field](Workspace& w) { w.state.*field = !(w.state.*field); },
            {},
            [field](const Workspace& w) { return w.state.*field; }};
}

void add_file(List& list) {
    list.push_back(plain("file.open_session", "Open session…", {"Ctrl+O"}, "Restores a saved session.",
                         [](Workspace& w) { w.files.open_session(); }));
    list.push_back(plain("file.save_session", "Save session…", {"Ctrl+S"}, "Saves all your choices as JSON.",
                         [](Workspace& w) { w.files.save_session(); }));
    list.push_back(plain("file.open_mesh", "Open mesh…", {"Ctrl+M"},
                         "Shows a mesh file as a transparent object.",
                         [](Workspace& w) { w.files.open_mesh(); }));
    list.push_back(plain("file.open_ray", "Open view ray…", {"Ctrl+J"}, "Plots a view ray from a JSON file.",
                         [](Workspace& w) { w.files.open_ray(); }));
    list.push_back(plain("file.export", "Export…", {"Ctrl+E"},
                         "Writes curves, fragments, the picture or the window to a file.",
                         [](Workspace& w) { w.files.save_export(); }));
    list.push_back({"file.copy_link",
                    "Copy link",
                    {},
                    "Copies the address that opens this state. Only the browser edition has addresses.",
                    [](Workspace& w) { w.options.host.copy_link(w.state); },
                    [](const Workspace& w) { return static_cast<bool>(w.options.host.copy_link); }});
}

void add_edit(List& list) {
    list.push_back({"edit.undo",
                    "Undo",
                    {"Ctrl+Z"},
                    "Undoes the last change.",
                    [](Workspace& w) { undo(w); },
                    [](const Workspace& w) { return w.history.can_undo(); }});
    list.push_back({"edit.redo",
                    "Redo",
                    {"Ctrl+Y", "Ctrl+Shift+Z"},
                    "Repeats a change that was undone.",
                    [](Workspace& w) { redo(w); },
                    [](const Workspace& w) { return w.history.can_redo(); }});
    list.push_back({"edit.delete_fragment",
                    "Delete fragment",
                    {"Delete"},
                    "Removes the marked fragment from a view ray without a scene.",
                    [](Workspace& w) { delete_marked(w.state); },
                    [](const Workspace& w) { return w.state.ray && w.state.marked.has_value(); }});
    list.push_back(plain("edit.reset_parameters", "Reset parameters", {"R"},
                         "Sets all parameters to their defaults.",
                         [](Workspace& w) { w.state.parameters = {}; }));
    for (const Parameter& row : parameters()) {
        if (row.scale == Scale::toggle || row.scale == Scale::choice) continue;
        list.push_back({fmt::format("edit.type_{}", row.key),
                        fmt::format("Type {} {}…", row.name, row.symbol),
                        {},
                        "Lets you type a value for this parameter.",
                        [id = row.id](Workspace& w) { type_parameter(w, id); },
                        [id = row.id](const Workspace& w) { return w.state.technique->uses(id); }});
    }
    list.push_back(plain("edit.reset_all", "Reset everything", {}, "Restores the window as it first opens.",
                         [](Workspace& w) {
                             const ThemeKind theme = w.state.theme;
                             w.state = ExplorerState();
                             w.state.theme = theme;
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
                    [](Workspace& w) {
                        const LensZoom zoom = w.state.lens_zoom;
                        w.state.lens_zoom = zoom == zoomed(zoom, 1) ? LensZoom() : zoomed(zoom, 1);
                    },
                    [](const Workspace& w) { return w.state.lens; }});
    list.push_back(flag("view.failures", "Failed reconstructions", "O",
                        "Marks pixels where a reconstruction failed or was clamped.",
                        &ExplorerState::failures));
    list.push_back(of_picture("view.reset", "Reset camera", {"Home"}, "Returns to the scene's own camera.",
                              [](Workspace& w) { reset_camera(w.state); }));
    list.push_back(of_picture("view.zoom_in", "Zoom in", {"+"}, "Moves the camera towards its target.",
                              [](Workspace& w) { w.state.camera = zoomed(w.camera(), 1); }));
    list.push_back(of_picture("view.zoom_out", "Zoom out", {"-"}, "Moves the camera away from its target.",
                              [](Workspace& w) { w.state.camera = zoomed(w.camera(), -1); }));
    for (const NamedView& view : named_views())
        list.push_back(
            of_picture(fmt::format("view.{}", view.id), view.name, {}, "Looks from this direction.",
                       [&view](Workspace& w) { w.state.camera = looking_from(w.camera(), view); }));
}

void add_tabs_and_theme(List& list) {
    for (std::size_t index = 0; index < PANELS.size(); ++index) {
        const Panel panel = PANELS[index].id;
        list.push_back(choice(
            fmt::format("view.panel{}", index + 1), fmt::format("Tab: {}", PANELS[index].name),
            {panel_shortcut(index)}, "Opens this tab below the plot.",
            [panel](Workspace& w) { w.state.panel = panel; },
            [panel](const Workspace& w) { return w.state.panel == panel; }));
    }
    const auto light = [](const Workspace& w) { return w.state.theme == ThemeKind::light; };
    list.push_back(choice(
        "view.theme", "Light theme", {"Ctrl+T"}, "Switches to a light theme, which suits a projector.",
        [light](Workspace& w) {
            w.state.theme = w.settings.theme = light(w) ? ThemeKind::dark : ThemeKind::light;
        },
        light));
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
        list.push_back(
            of_picture(fmt::format("pixel.{}", arrow.name), fmt::format("One pixel {}", arrow.name),
                       {arrow.key}, "Moves the pick.",
                       [step = arrow.step](Workspace& w) { move_pick(w.state, w.measurement(), step); }));
        list.push_back(of_picture(
            fmt::format("pixel.{}10", arrow.name), fmt::format("Ten pixels {}", arrow.name),
            {fmt::format("Shift+{}", arrow.key)}, "Moves the pick.",
            [step = 10 * arrow.step](Workspace& w) { move_pick(w.state, w.measurement(), step); }));
    }
}

void add_pixel(List& list) {
    add_arrows(list);
    list.push_back(of_picture("pixel.go_to", "Go to…", {"Ctrl+G"}, "Lets you type the pixel to pick.",
                              [](Workspace& w) { w.scene_panel.focus_go_to(); }));
    list.push_back(of_picture(
        "pixel.pin", "Pin", {"P"},
        "Keeps a small plot of this pixel, or removes it; at most four can be pinned.", [](Workspace& w) {
            if (!toggle_pin(w.state, w.measurement()))
                w.status.say(
                    "Four pixels are pinned already, and there is no room for more; remove one first.");
        }));
    list.push_back({"pixel.unpin_all",
                    "Remove all pins",
                    {"Shift+P"},
                    "Closes the small plots.",
                    [](Workspace& w) { remove_pins(w.state); },
                    [](const Workspace& w) { return !w.state.pins.empty(); }});
    list.push_back(plain("pixel.next_fragment", "Next fragment", {"N"}, "Marks the next fragment behind.",
                         [](Workspace& w) { mark_next(w.state, w.measurement(), 1); }));
    list.push_back(plain("pixel.previous_fragment", "Previous fragment", {"Shift+N"},
                         "Marks the next fragment in front.",
                         [](Workspace& w) { mark_next(w.state, w.measurement(), -1); }));
}

void add_registries(List& list) {
    std::size_t digit = 1;
    for (const Technique& technique : techniques()) {
        const Keys keys = digit <= 9 ? Keys{fmt::format("{}", digit)} : Keys{};
        ++digit;
        list.push_back(choice(
            fmt::format("technique.{}", technique.id), fmt::format("{} ({})", technique.name, technique.id),
            keys, "Draws the picture with this technique.",
            [&technique](Workspace& w) { w.state.technique = &technique; },
            [&technique](const Workspace& w) { return w.state.technique == &technique; }));
    }
    for (const SceneEntry& entry : scene_entries())
        list.push_back(choice(
            fmt::format("scene.{}", entry.id), entry.id, {}, entry.description,
            [&entry](Workspace& w) { choose_scene(w.state, entry.id); },
            [&entry](const Workspace& w) { return !w.state.ray && w.state.scene == entry.id; }));
}

void add_lessons(List& list) {
    list.push_back(plain("try.next", "Next step", {"PageDown"},
                         "Goes to the next step of the lesson, or opens the first lesson.", next_step));
    list.push_back(
        plain("try.previous", "Previous step", {"PageUp"}, "Goes back to the step before.", previous_step));
    list.push_back(plain("try.open", "Open lesson…", {}, "Adds a lesson from a JSON file.",
                         [](Workspace& w) { w.files.open_lesson(); }));
    list.push_back(plain("try.export", "Export answers…", {},
                         "Writes what you have done and answered, for a teacher.",
                         [](Workspace& w) { w.files.save_answers(); }));
    list.push_back({"try.reset",
                    "Forget my progress",
                    {},
                    "Forgets which lessons are done, and all answers. This cannot be undone.",
                    [](Workspace& w) { w.lesson.reset(); },
                    [](const Workspace& w) { return !w.lesson.progress.empty(); }});
    for (const Lesson& lesson : own_lessons())
        list.push_back(choice(
            fmt::format("try.{}", lesson.id), lesson.title, {}, "Opens this lesson.",
            [id = lesson.id](Workspace& w) { open_lesson(w.state, *w.course.find(id)); },
            [id = lesson.id](const Workspace& w) { return w.state.card == id; }));
}

void add_present(List& list) {
    list.push_back(choice(
        "view.present", "Present", {"F9"},
        "Shows only scene, plot and lesson; PageDown and PageUp go from step to step.",
        [](Workspace& w) { w.present = !w.present; }, [](const Workspace& w) { return w.present; }));
    list.push_back(choice(
        "view.moves", "Move between steps", {}, "While presenting, states move into each other.",
        [](Workspace& w) { w.settings.moves = !w.settings.moves; },
        [](const Workspace& w) { return w.settings.moves; }));
    list.push_back({"view.fullscreen",
                    "Full screen",
                    {"F11"},
                    "Fills the screen with the window.",
                    [](Workspace& w) { w.options.host.toggle_fullscreen(); },
                    [](const Workspace& w) { return static_cast<bool>(w.options.host.toggle_fullscreen); }});
    const auto scale = [](float by) {
        return [by](Workspace& w) {
            w.settings.text_scale = std::clamp(by * w.settings.text_scale, MIN_TEXT_SCALE, MAX_TEXT_SCALE);
        };
    };
    list.push_back(
        plain("view.text_larger", "Larger text", {"Ctrl+Plus"}, "Makes all text larger.", scale(1.1f)));
    list.push_back(plain("view.text_smaller", "Smaller text", {"Ctrl+Minus"}, "Makes all text smaller.",
                         scale(1 / 1.1f)));
    list.push_back(plain("view.text_standard", "Standard text", {"Ctrl+0"},
                         "Brings the standard size of text back.",
                         [](Workspace& w) { w.settings.text_scale = 1; }));
}

void add_help(List& list) {
    list.push_back(choice(
        "help.keys", "Keys and mouse", {"?", "F1"}, "Lists every key and what the mouse does.",
        [](Workspace& w) { w.help = !w.help; }, [](const Workspace& w) { return w.help; }));
    list.push_back(plain("help.palette", "All commands…", {"Ctrl+Shift+P"},
                         "Finds a command by typing parts of its name.",
                         [](Workspace& w) { w.palette.toggle(); }));
    list.push_back(plain(
        "help.close", "Close", {"Escape"},
        "Closes the first of these that is there: a list or menu, a dialog, the help, the message, the region, the presentation, the lesson.",
        [](Workspace& w) { close_topmost(w); }));
}

}  // namespace

std::vector<Command> make_command_list() {
    List list;
    for (const auto add : {add_file, add_edit, add_view, add_tabs_and_theme, add_present, add_pixel,
                           add_compare, add_plot, add_registries, add_lessons, add_help})
        add(list);
    return list;
}

}  // namespace momentscope::ui
