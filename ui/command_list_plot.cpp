// command_list_plot.cpp -- the commands of the Compare and Plot menus.
#include <fmt/format.h>

#include "ui/command_rows.hpp"
#include "ui/series.hpp"

namespace momentscope::ui {

void add_compare(List& list) {
    list.push_back(plain("compare.flip", "Flip to the reference", {"G"},
                         "Shows the picture of the reference while the key is held.", {}));
    list.push_back(plain("compare.take_reference", "Take this technique as the reference", {"Shift+G"},
                         "Makes the current technique the reference for the techniques that you choose next.",
                         [](Explorer& e) { e.state().compare.reference = e.state().technique; }));
    const struct {
        CompareMode mode;
        const char* id;
        const char* name;
        const char* key;
        const char* help;
    } modes[] = {{CompareMode::wipe, "compare.wipe", "Wipe", "W",
                  "Shows the reference and the picture on the two sides of a line that you can drag."},
                 {CompareMode::difference, "compare.difference", "Difference", "M",
                  "Shows the absolute difference from the reference, amplified."},
                 {CompareMode::false_color, "compare.false_color", "Error in false colour", "H",
                  "Shows the chosen metric of every pixel as a colour."}};
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
                    "Exchanges the sides of the reference and the picture.",
                    [](Explorer& e) { e.state().compare.swapped = !e.state().compare.swapped; },
                    [](const Explorer& e) { return e.state().compare.mode == CompareMode::wipe; },
                    [](const Explorer& e) { return e.state().compare.swapped; }});
    list.push_back(
        of_picture("compare.next_worst", "Next worst pixel", {"J"},
                   "Picks the pixel where the chosen metric is greatest, then the next worst, and so on.",
                   [](Explorer& e) { e.next_worst_pixel(); }));
    list.push_back({"compare.forget_region",
                    "Forget the region",
                    {},
                    "Measures only the whole picture again.",
                    [](Explorer& e) { e.state().compare.region.reset(); },
                    [](const Explorer& e) { return e.state().compare.region.has_value(); }});
    list.push_back({"compare.measure_chart",
                    "Measure the chart",
                    {},
                    "Measures the time and the error of every technique on this scene, in the Chart tab.",
                    [](Explorer& e) { e.measure_chart(); },
                    [](const Explorer& e) { return has_picture(e) && !e.chart_panel().measuring(); }});
    list.push_back({"compare.cancel_chart",
                    "Stop measuring the chart",
                    {},
                    "Ends the measurement; finished rows stay.",
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
    list.push_back({"plot.light",
                    "Seen from the light",
                    {"V"},
                    "Plots what the light's map stores about the surface in the pixel, and turns shadows on.",
                    [](Explorer& e) {
                        set_viewpoint(e.state(), seen_from_light(e.state()) ? Viewpoint::eye
                                                                            : Viewpoint::transparent_casters);
                    },
                    has_picture,
                    [](const Explorer& e) { return seen_from_light(e.state()); }});
    for (const SeriesRow& row : series_rows())
        list.push_back(choice(
            fmt::format("plot.{}", row.key), fmt::format("Show {}", row.name), {row.shortcut},
            "Shows or hides this series in the plot.",
            [i = static_cast<std::size_t>(row.id)](Explorer& e) {
                e.state().plot.shown[i] = !e.state().plot.shown[i];
            },
            [id = row.id](const Explorer& e) { return e.state().plot.shows(id); }));
}

}  // namespace momentscope::ui
