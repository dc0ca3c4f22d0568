// command_list_plot.cpp -- the commands of the Compare and Plot menus.
#include <fmt/format.h>

#include "ui/commands/command_rows.hpp"
#include "ui/model/selection.hpp"
#include "ui/model/series.hpp"

namespace momentscope::ui {

namespace {

void add_modes(List& list) {
    const struct {
        CompareMode mode;
        const char* id;
        const char* name;
        const char* key;
        const char* help;
    } modes[] = {
        {CompareMode::wipe, "compare.wipe", "Wipe", "W",
         "Shows the reference and the picture on the two sides of a line that you can drag."},
        {CompareMode::difference, "compare.difference", "Difference", "M",
         "Shows the absolute difference from the reference, amplified."},
        {CompareMode::false_color, "compare.false_color", "Error in false colour", "H",
         "Shows the chosen metric of every pixel as a colour."},
        {CompareMode::uncertainty, "compare.uncertainty", "What the moments leave open", "Shift+H",
         "Shows as a colour how much the luminance of every pixel may change while the transmittance of "
         "each fragment stays within its bounds. This needs no reference."}};
    for (const auto& row : modes)
        list.push_back({row.id,
                        row.name,
                        {row.key},
                        row.help,
                        [mode = row.mode](Workspace& w) { toggle(w.state.compare, mode); },
                        has_picture,
                        [mode = row.mode](const Workspace& w) { return w.state.compare.mode == mode; }});
}

void add_chart(List& list) {
    list.push_back({"compare.measure_chart",
                    "Measure the chart",
                    {},
                    "Measures the time and the error of every technique on this scene, in the Chart tab.",
                    [](Workspace& w) { measure_chart(w); },
                    [](const Workspace& w) { return has_picture(w) && !w.chart.measuring(); }});
    list.push_back({"compare.cancel_chart",
                    "Stop measuring the chart",
                    {},
                    "Ends the measurement; finished rows stay.",
                    [](Workspace& w) { w.chart.cancel(); },
                    [](const Workspace& w) { return w.chart.measuring(); }});
}

}  // namespace

void add_compare(List& list) {
    list.push_back(plain("compare.flip", "Flip to the reference", {"G"},
                         "Shows the picture of the reference while the key is held.", {}));
    list.push_back(plain("compare.take_reference", "Take this technique as the reference", {"Shift+G"},
                         "Makes the current technique the reference for the techniques that you choose next.",
                         [](Workspace& w) { w.state.compare.reference = w.state.technique; }));
    add_modes(list);
    list.push_back({"compare.swap",
                    "Swap the sides of the wipe",
                    {"Shift+W"},
                    "Exchanges the sides of the reference and the picture.",
                    [](Workspace& w) { w.state.compare.swapped = !w.state.compare.swapped; },
                    [](const Workspace& w) { return w.state.compare.mode == CompareMode::wipe; },
                    [](const Workspace& w) { return w.state.compare.swapped; }});
    list.push_back(
        of_picture("compare.next_worst", "Next worst pixel", {"J"},
                   "Picks the pixel where the chosen metric is greatest, then the next worst, and so on.",
                   [](Workspace& w) { w.comparison.want_worst(); }));
    list.push_back(of_picture("compare.next_failed", "Next failed pixel", {"Shift+J"},
                              "Marks failed reconstructions and picks one, then the next, row by row.",
                              [](Workspace& w) { want_next_failed(w); }));
    list.push_back({"compare.forget_region",
                    "Forget the region",
                    {},
                    "Measures only the whole picture again.",
                    [](Workspace& w) { forget_region(w.state.compare); },
                    [](const Workspace& w) { return w.state.compare.region.has_value(); }});
    add_chart(list);
    for (const MetricRow& row : metrics())
        list.push_back(choice(
            fmt::format("compare.metric_{}", row.key), fmt::format("Metric: {}", row.name), {}, row.help,
            [id = row.id](Workspace& w) { w.state.compare.metric = id; },
            [id = row.id](const Workspace& w) { return w.state.compare.metric == id; }));
}

void add_plot(List& list) {
    list.push_back(
        plain("plot.fit", "Fit", {"F"}, "Shows the whole ray.", [](Workspace& w) { fit(w.state.plot); }));
    const auto transmittance = [](const Workspace& w) {
        return w.state.plot.quantity == Quantity::transmittance;
    };
    list.push_back(choice(
        "plot.quantity", "Transmittance", {"T"}, "Plots T(z) instead of A(z).",
        [transmittance](Workspace& w) {
            set_quantity(w.state.plot, transmittance(w) ? Quantity::absorbance : Quantity::transmittance);
        },
        transmittance));
    const auto view_depth = [](const Workspace& w) { return w.state.plot.axis == DepthAxis::view; };
    list.push_back({"plot.axis",
                    "View depth",
                    {"D"},
                    "Plots over view depth instead of warped depth.",
                    [view_depth](Workspace& w) {
                        set_depth_axis(w.state.plot, view_depth(w) ? DepthAxis::warped : DepthAxis::view);
                    },
                    [](const Workspace& w) { return w.measurement().capture.ray.warp.has_view_depths(); },
                    view_depth});
    list.push_back({"plot.light",
                    "Seen from the light",
                    {"V"},
                    "Plots what the light's map stores about the surface in the pixel, and turns shadows on.",
                    [](Workspace& w) {
                        set_viewpoint(w.state, seen_from_light(w.state) ? Viewpoint::eye
                                                                        : Viewpoint::transparent_casters);
                    },
                    has_picture,
                    [](const Workspace& w) { return seen_from_light(w.state); }});
    for (const SeriesRow& row : series_rows())
        list.push_back(choice(
            fmt::format("plot.{}", row.key), fmt::format("Show {}", row.name), {row.shortcut},
            "Shows or hides this series in the plot.",
            [i = static_cast<std::size_t>(row.id)](Workspace& w) {
                w.state.plot.shown[i] = !w.state.plot.shown[i];
            },
            [id = row.id](const Workspace& w) { return w.state.plot.shows(id); }));
}

}  // namespace momentscope::ui
