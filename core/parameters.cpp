#include "core/parameters.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace momentscope {

namespace {

constexpr float PI = 3.14159265f;

const std::array<Parameter, PARAMETER_COUNT> ROWS = {{
    {ParameterId::beta, "beta", "β", "overestimation weight", "", 0.0f, 1.0f, 0.25f, Scale::linear,
     Stage::color,
     "How much of the mass at the query depth counts as in front of it. With power moments 0 gives the "
     "lower bound, where no surface occludes itself but all appear too visible, and 1 the upper bound; with "
     "trigonometric moments these are no bounds.",
     "Münstermann et al. 2018, Section 3.2"},
    {ParameterId::theta, "theta", "θ", "wrapping zone angle", "rad", 0.0f, PI, PI / 10.0f, Scale::linear,
     Stage::moments,
     "Trigonometric moments only: the arc of the circle that holds no depths, where the end of the depth "
     "range wraps to its start. Wider is smoother and less precise in depth; 0 makes jumps.",
     "Münstermann et al. 2018, Section 5.2"},
    {ParameterId::alpha, "alpha", "α", "moment bias", "", 0.0f, 0.1f, std::nullopt, Scale::logarithmic,
     Stage::color,
     "How far the moments are pulled towards harmless ones before reconstruction, to make up for rounding. "
     "`auto` is the value of the supplementary's Table 1 for the technique. Less is sharper until matrices "
     "become singular.",
     "Münstermann et al. 2018, supplementary, Section 1 and Table 1"},
    {ParameterId::renormalize, "renormalize", "Eq. 2", "renormalisation", "", 0.0f, 1.0f, 1.0f, Scale::toggle,
     Stage::composite,
     "1 scales the transparent colour so that all weights sum to the true coverage, 0 leaves the sum as it is.",
     "Münstermann et al. 2018, Section 3.4, Equation 2"},
    {ParameterId::opacity, "opacity", "α_l", "opacity of mesh files", "", 0.0f, 0.99f, 0.4f, Scale::linear,
     Stage::scene,
     "Opacity of every fragment of a mesh that was loaded from a file. Built-in scenes bring their own.",
     "Münstermann et al. 2018, Section 2"},
}};

}  // namespace

std::span<const Parameter> parameters() {
    return ROWS;
}

const Parameter& parameter(ParameterId id) {
    return ROWS[static_cast<std::size_t>(id)];
}

const Parameter* find_parameter(std::string_view key) {
    const auto* row =
        std::ranges::find(ROWS, key, [](const Parameter& p) { return std::string_view(p.key); });
    return row == ROWS.end() ? nullptr : row;
}

ParameterValues::ParameterValues() {
    for (const Parameter& row : ROWS) values_[static_cast<std::size_t>(row.id)] = row.standard;
}

void ParameterValues::set(ParameterId id, std::optional<float> value) {
    const Parameter& row = parameter(id);
    if (!value && row.standard)
        throw Error(fmt::format("The {} --{} has no automatic value; give a number from {} to {}.", row.name,
                                row.key, row.minimum, row.maximum));
    if (value && !(*value >= row.minimum && *value <= row.maximum))  // NaN is refused too
        throw Error(fmt::format("The {} --{} is {}; give a number from {} to {}.", row.name, row.key, *value,
                                row.minimum, row.maximum));
    values_[static_cast<std::size_t>(id)] = value;
}

std::optional<float> parse_parameter(const Parameter& row, std::string_view text) {
    if (text == "auto") return std::nullopt;
    float value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size())
        throw Error(fmt::format("'{}' is not a number for the {} --{}; give one from {} to {}{}.", text,
                                row.name, row.key, row.minimum, row.maximum,
                                row.standard ? "" : ", or auto"));
    return value;
}

}  // namespace momentscope
