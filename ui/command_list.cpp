#include "ui/command_list.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/scene/scenes.hpp"
#include "ui/camera_moves.hpp"
#include "ui/explorer.hpp"
#include "ui/lessons.hpp"
#include "ui/ray_editor.hpp"
#include "ui/series.hpp"

namespace momentscope::ui {

namespace {

using List = std::vector<Command>;
using Keys = std::vector<std::string>;

bool has_picture(const Explorer& e) {
    return !e.state().ray;
}

// A command that may always run and is no switch.
Command plain(const char* id, const char* name, Keys keys, const char* help,
              std::function<void(Explorer&)> run) {
    return {id, name, std::move(keys), help, std::move(run)};
}

// A switch of the state.
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

// One of several choices: checked while `chosen` holds.
Command choice(std::string id, std::string name, Keys keys, std::string help,
               std::function<void(Explorer&)> choose, std::function<bool(const Explorer&)> chosen) {
    return {std::move(id),    std::move(name), std::move(keys), std::move(help), std::move(choose), {},
            std::move(chosen)};
}

// Of the scene's picture, which a view ray of its own does not have.
Command of_picture(std::string id, std::string name, Keys keys, std::string help,
                   std::function<void(Explorer&)> run) {
    return {std::move(id), std::move(name), std::move(keys), std::move(help), std::move(run), has_picture};
}

void add_file(List& list) {
    list.push_back(plain("file.open_session", "Open session…", {"Ctrl+O"}, "Restores a saved session.",
                         [](Explorer& e) { e.open_session_dialog(); }));
    list.push_back(plain("file.save_session", "Save session…", {"Ctrl+S"},
                         "Saves everything that is chosen, as JSON.",
                         [](Explorer& e) { e.save_session_dialog(); }));
    list.push_back(plain("file.open_mesh", "Open mesh…", {"Ctrl+M"},
                         "Shows a mesh file as a transparent object.",
                         [](Explorer& e) { e.open_mesh_dialog(); }));
    list.push_back(plain("file.open_ray", "Open view ray…", {"Ctrl+J"}, "Plots a view ray from a JSON file.",
                         [](Explorer& e) { e.open_ray_dialog(); }));
    list.push_back(plain("file.export", "Export…", {"Ctrl+E"},
                         "Writes curves, fragments, picture or window to a file.",
                         [](Explorer& e) { e.export_dialog(); }));
}

void add_edit(List& list) {
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
    list.push_back({"edit.delete_fragment",
                    "Delete fragment",
                    {"Delete"},
                    "Takes the marked fragment out of a view ray of its own.",
                    [](Explorer& e) { delete_marked(e.state()); },
                    [](const Explorer& e) { return e.state().ray && e.state().marked.has_value(); }});
    list.push_back(plain("edit.reset_parameters", "Reset parameters", {"R"},
                         "All parameters as at the start.", [](Explorer& e) { e.state().parameters = {}; }));
    for (const Parameter& row : parameters()) {
        if (row.scale == Scale::toggle || row.scale == Scale::choice) continue;
        list.push_back({fmt::format("edit.type_{}", row.key),
                        fmt::format("Type {} {}…", row.name, row.symbol),
                        {},
                        "Opens the control for a number from the keyboard.",
                        [id = row.id](Explorer& e) { e.type_parameter(id); },
                        [id = row.id](const Explorer& e) { return e.state().technique->uses(id); }});
    }
    list.push_back(
        plain("edit.reset_all", "Reset everything", {}, "The window as it first opens.", [](Explorer& e) {
            const ThemeKind theme = e.state().theme;
            e.state() = ExplorerState();
            e.state().theme = theme;
        }));
}

void add_view(List& list) {
    list.push_back(flag("view.lens", "Pixel lens", "L",
                        "Magnifies the pixels around the picked one, with their values.",
                        &ExplorerState::lens));
    list.push_back({"view.lens_zoom",
                    "Lens: closer",
                    {"Shift+L"},
                    "Fewer and larger pixels in the lens, in the end with all digits; then from the start.",
                    [](Explorer& e) {
                        const LensZoom zoom = e.state().lens_zoom;
                        e.state().lens_zoom = zoom == zoomed(zoom, 1) ? LensZoom() : zoomed(zoom, 1);
                    },
                    [](const Explorer& e) { return e.state().lens; }});
    list.push_back(flag("view.failures", "Failed reconstructions", "O",
                        "Marks pixels whose reconstruction failed or was clamped.",
                        &ExplorerState::failures));
    list.push_back(of_picture("view.reset", "Reset camera", {"Home"}, "Back to the scene's own camera.",
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
        "view.theme", "Light theme", {"Ctrl+T"}, "Dark on light, as for a projector.",
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
    list.push_back(of_picture("pixel.go_to", "Go to…", {"Ctrl+G"}, "Type the pixel to pick.",
                              [](Explorer& e) { e.type_pixel(); }));
    list.push_back(of_picture("pixel.pin", "Pin", {"P"},
                              "Keeps a small plot of this pixel, or removes it; at most four.",
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

void add_compare(List& list) {
    list.push_back(plain("compare.flip", "Flip to the reference", {"G"},
                         "Shows the picture of the reference as long as the key is held.", {}));
    list.push_back(plain("compare.take_reference", "Take this technique as the reference", {"Shift+G"},
                         "Compares the techniques that are chosen next with the one that is chosen now.",
                         [](Explorer& e) { e.state().compare.reference = e.state().technique; }));
    const struct {
        CompareMode mode;
        const char* id;
        const char* name;
        const char* key;
        const char* help;
    } modes[] = {{CompareMode::wipe, "compare.wipe", "Wipe", "W",
                  "Shows reference and picture on two sides of a line that is dragged."},
                 {CompareMode::difference, "compare.difference", "Difference", "M",
                  "Shows the absolute difference from the reference, amplified."},
                 {CompareMode::false_color, "compare.false_color", "Error in false colour", "H",
                  "Shows the chosen metric of every pixel in colours."}};
    for (const auto& row : modes)
        list.push_back({row.id,
                        row.name,
                        {row.key},
                        row.help,
                        [mode = row.mode](Explorer& e) { toggle(e.state().compare, mode); },
                        has_picture,
                        [mode = row.mode](const Explorer& e) { return e.state().compare.mode == mode; }});
    list.push_back({"compare.swap",
                    "Swap the sides of the wipe",
                    {"Shift+W"},
                    "Exchanges the sides of reference and picture.",
                    [](Explorer& e) { e.state().compare.swapped = !e.state().compare.swapped; },
                    [](const Explorer& e) { return e.state().compare.mode == CompareMode::wipe; },
                    [](const Explorer& e) { return e.state().compare.swapped; }});
    list.push_back(of_picture("compare.next_worst", "Next worst pixel", {"J"},
                              "Picks the pixel where the chosen metric is greatest, then the next worst.",
                              [](Explorer& e) { e.next_worst_pixel(); }));
    list.push_back({"compare.forget_region",
                    "Forget the region",
                    {},
                    "Measures the whole picture alone.",
                    [](Explorer& e) { e.state().compare.region.reset(); },
                    [](const Explorer& e) { return e.state().compare.region.has_value(); }});
    list.push_back({"compare.measure_chart",
                    "Measure the chart",
                    {},
                    "Takes time and error of every technique on this scene, in the Chart tab.",
                    [](Explorer& e) { e.measure_chart(); },
                    [](const Explorer& e) { return has_picture(e) && !e.chart_panel().measuring(); }});
    list.push_back({"compare.cancel_chart",
                    "Stop measuring the chart",
                    {},
                    "Ends the measurement; rows that are done stay.",
                    [](Explorer& e) { e.cancel_chart(); },
                    [](const Explorer& e) { return e.chart_panel().measuring(); }});
    for (const MetricRow& row : metrics())
        list.push_back(choice(
            fmt::format("compare.metric_{}", row.key), fmt::format("Metric: {}", row.name), {}, row.help,
            [id = row.id](Explorer& e) { e.state().compare.metric = id; },
            [id = row.id](const Explorer& e) { return e.state().compare.metric == id; }));
}

void add_plot(List& list) {
    list.push_back(
        plain("plot.fit", "Fit", {"F"}, "Shows the whole ray.", [](Explorer& e) { fit(e.state().plot); }));
    const auto transmittance = [](const Explorer& e) {
        return e.state().plot.quantity == Quantity::transmittance;
    };
    list.push_back(choice(
        "plot.quantity", "Transmittance", {"T"}, "Plots T(z) instead of A(z).",
        [transmittance](Explorer& e) {
            set_quantity(e.state().plot, transmittance(e) ? Quantity::absorbance : Quantity::transmittance);
        },
        transmittance));
    const auto view_depth = [](const Explorer& e) { return e.state().plot.axis == DepthAxis::view; };
    list.push_back({"plot.axis",
                    "View depth",
                    {"D"},
                    "Plots over view depth instead of warped depth.",
                    [view_depth](Explorer& e) {
                        set_depth_axis(e.state().plot, view_depth(e) ? DepthAxis::warped : DepthAxis::view);
                    },
                    [](const Explorer& e) { return e.measurement().capture.ray.warp.has_view_depths(); },
                    view_depth});
    list.push_back(
        {"plot.light",
         "Seen from the light",
         {"V"},
         "Plots the function that the light's map has of what the pixel shows, and turns shadows on.",
         [](Explorer& e) {
             set_viewpoint(e.state(),
                           seen_from_light(e.state()) ? Viewpoint::eye : Viewpoint::transparent_casters);
         },
         has_picture,
         [](const Explorer& e) { return seen_from_light(e.state()); }});
    for (const SeriesRow& row : series_rows())
        list.push_back(choice(
            fmt::format("plot.{}", row.key), fmt::format("Show {}", row.name), {row.shortcut},
            "Shows or hides it in the plot.",
            [i = static_cast<std::size_t>(row.id)](Explorer& e) {
                e.state().plot.shown[i] = !e.state().plot.shown[i];
            },
            [id = row.id](const Explorer& e) { return e.state().plot.shows(id); }));
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
    list.push_back(
        plain("help.close", "Close", {"Escape"},
              "Closes a dialog, the help or the message; else forgets the region; else closes the card.",
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
