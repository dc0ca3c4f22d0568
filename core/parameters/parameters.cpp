#include "core/parameters/parameters.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/support/error.hpp"
#include "core/support/parse_number.hpp"

namespace momentscope {

namespace {

constexpr float PI = std::numbers::pi_v<float>;

// The names of the values of a choice, such as CHOICE_NAMES<Solver>.
template <typename Choice>
constexpr bool CHOICE_NAMES = false;
#define VALUE(enumerator, text) text
#define CHOICE(type, parameter, ...) \
    template <>                      \
    constexpr std::array CHOICE_NAMES<type> = {__VA_ARGS__};
#include "core/parameters/parameter_choices.def"
#undef CHOICE
#undef VALUE

// How transparent casters may be stored: moments in floats, which may be filtered; two sizes of Fourier
// series; the ground truth; or no such casters.
std::vector<const char*> shadow_techniques() {
    std::vector<const char*> ids;
#define MOMENT_TECHNIQUE(id, basis, count, bits, key, ...) \
    if (bits == 32) ids.push_back(key);
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    ids.insert(ids.end(), {"fourier-7", "fourier-15", "deep", "none"});
    return ids;
}
const std::vector<const char*> SHADOW_TECHNIQUES = shadow_techniques();

constexpr std::array OPAQUE_SHADOWS = {
#define OPAQUE_SHADOW(id, file, count, bits, key, ...) key,
#include "core/shadow/opaque_shadows.def"
#undef OPAQUE_SHADOW
};
constexpr float HAMBURGER_16 = 3;  // index in OPAQUE_SHADOWS

const std::array<Parameter, PARAMETER_COUNT> ROWS = {{
#define PARAMETER(id, ...) {ParameterId::id, __VA_ARGS__},
#include "core/parameters/parameters.def"
#undef PARAMETER
}};

bool is_whole(const Parameter& row) {
    return row.scale == Scale::choice || row.scale == Scale::whole || row.scale == Scale::toggle;
}

// A switch, or a choice whose first name is `off`; `on` then means its second.
bool can_be_off(const Parameter& row) {
    return row.scale == Scale::toggle ||
           (!row.choices.empty() && std::string_view(row.choices.front()) == "off");
}

}  // namespace

std::span<const Parameter> parameters() {
    return ROWS;
}

const Parameter& parameter(ParameterId id) {
    return ROWS[static_cast<std::size_t>(id)];
}

const Parameter* find_parameter(std::string_view key) {
    for (const Parameter& row : ROWS)
        if (key == row.key) return &row;
    return nullptr;
}

ParameterValues::ParameterValues() {
    for (const Parameter& row : ROWS) values_[static_cast<std::size_t>(row.id)] = row.default_value;
}

void ParameterValues::set(ParameterId id, std::optional<float> value) {
    const Parameter& row = parameter(id);
    const bool in_range = value && *value >= row.minimum && *value <= row.maximum;  // false if it is NaN
    const bool allowed =
        value ? in_range && (!is_whole(row) || *value == std::floor(*value)) : !row.default_value;
    if (!allowed)
        throw Error(fmt::format("The {} --{} cannot be {}; give {}.", row.name, row.key,
                                value ? fmt::format("{}", *value) : "auto", parameter_values_text(row)));
    values_[static_cast<std::size_t>(id)] = value;
}

ParameterValues values_with(const ParameterSettings& settings) {
    ParameterValues values;
    for (const auto& [id, value] : settings) values.set(id, value);
    return values;
}

std::optional<float> parse_parameter(const Parameter& row, std::string_view text) {
    if (text == "auto") return std::nullopt;
    if (can_be_off(row) && (text == "on" || text == "true")) return 1.0f;
    if (can_be_off(row) && (text == "off" || text == "false")) return 0.0f;
    const auto choice =
        std::ranges::find(row.choices, text, [](const char* name) { return std::string_view(name); });
    if (choice != row.choices.end()) return static_cast<float>(choice - row.choices.begin());
    const auto value = parse_number<float>(text);
    if (!value)
        throw Error(fmt::format("'{}' is not a value of the {} --{}; give {}.", text, row.name, row.key,
                                parameter_values_text(row)));
    return value;
}

std::string parameter_text(const Parameter& row, std::optional<float> value) {
    if (!value) return "auto";
    if (row.choices.empty()) return fmt::format("{:g}", *value);
    return row.choices[static_cast<std::size_t>(*value)];
}

std::string parameter_values_text(const Parameter& row) {
    if (row.scale == Scale::toggle) return "on or off";
    if (row.choices.empty())
        return fmt::format("a {}number from {:g} to {:g}{}{}{}", is_whole(row) ? "whole " : "", row.minimum,
                           row.maximum, *row.unit != '\0' ? " " : "", row.unit,
                           row.default_value ? "" : ", or auto");
    std::string list;
    for (std::size_t i = 0; i < row.choices.size(); ++i)
        list += fmt::format("{}{}",
                            i == 0                        ? ""
                            : i + 1 == row.choices.size() ? " or "
                                                          : ", ",
                            row.choices[i]);
    return list;
}

}  // namespace momentscope
