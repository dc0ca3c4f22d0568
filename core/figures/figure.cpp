#include "core/figures/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/support/error.hpp"

namespace momentscope {

double RenderSource::error(const RenderSetup& setup, Metric metric, glm::vec4 part) {
    const Image truth = picture({setup.scene, "sorted"});
    const Image& shown = picture(setup);
    const auto at = [](float fraction, int extent) {
        return static_cast<int>(std::lround(fraction * static_cast<float>(extent)));
    };
    const glm::ivec2 low(at(part.x, truth.width), at(part.y, truth.height));
    const glm::ivec2 high(at(part.z, truth.width), at(part.w, truth.height));
    const std::vector<float> map = difference_map(truth, shown, metric);
    return mean_difference(part_of(map, truth.width, {low.x, low.y, high.x - low.x, high.y - low.y}), metric);
}

const Figure& require_figure(std::string_view id) {
    const auto all = figures();
    const auto found = std::ranges::find(all, id, [](const Figure& f) { return std::string_view(f.id); });
    if (found != all.end()) return *found;
    std::string ids;
    for (const Figure& figure : all) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", figure.id);
    throw Error(fmt::format("There is no figure '{}'; use all or one of {}.", id, ids));
}

std::string figure_section(const Figure& figure, const std::vector<ClaimResult>& results,
                           const std::string& picture) {
    std::string text = fmt::format("## `{}`: {}\n\nAfter {}.\n\n![{}]({})\n\n", figure.id, figure.title,
                                   figure.source, figure.title, picture);
    text += "| what the paper says | ours | measured |\n|---|---|---|\n";
    for (const ClaimResult& result : results)
        fmt::format_to(std::back_inserter(text), "| {} | {} | {}{}{} |\n", result.claim,
                       result.agrees ? "agree" : "**do not agree**", result.numbers,
                       result.remark.empty() ? "" : ". ", result.remark);
    return text;
}

}  // namespace momentscope
