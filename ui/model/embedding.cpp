#include "ui/model/embedding.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/support/error.hpp"

namespace momentscope::ui {

namespace {

std::string part_names() {
    std::string names = "scene, plot";
    for (const PanelRow& row : PANELS) names += fmt::format(", {}", row.key);
    return names;
}

ParameterId parameter_of(std::string_view key) {
    const Parameter* const row = find_parameter(key);
    if (row == nullptr)
        throw Error(fmt::format("The link asks for a control '{}', but there is no such parameter.", key));
    return row->id;
}

}  // namespace

Embedding parse_embedding(std::string_view part, std::string_view controls) {
    Embedding embedding;
    const auto* const panel =
        std::ranges::find(PANELS.data(), PANELS.data() + PANELS.size(), part, &PanelRow::key);
    if (part == "scene") {
        embedding.shown = Shown::scene;
    } else if (part == "plot") {
        embedding.shown = Shown::plot;
    } else if (panel != PANELS.data() + PANELS.size()) {
        embedding.shown = Shown::panel;
        embedding.panel = panel->id;
    } else if (!part.empty()) {
        throw Error(
            fmt::format("The link asks for the part '{}' of the window; there are {}.", part, part_names()));
    }
    for (std::size_t begin = 0; begin < controls.size();) {
        const std::size_t end = std::min(controls.find(',', begin), controls.size());
        embedding.controls.push_back(parameter_of(controls.substr(begin, end - begin)));
        begin = end + 1;
    }
    return embedding;
}

}  // namespace momentscope::ui
