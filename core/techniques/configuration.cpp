#include "core/techniques/configuration.hpp"

#include <fmt/format.h>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

// With all digits, unlike parameter_text.
std::string exact_text(const Parameter& row, const std::optional<float>& value) {
    return value && row.choices.empty() ? fmt::format("{}", *value) : parameter_text(row, value);
}

/// Calls visit(row, text of the value) for every parameter of the technique that does not have its default
/// value.
template <typename Visit>
void for_each_change(const Configuration& configuration, const Visit& visit) {
    for (const ParameterId id : configuration.technique->parameters) {
        const Parameter& row = parameter(id);
        const std::optional<float>& value = configuration.values[id];
        if (value != row.default_value) visit(row, exact_text(row, value));
    }
}

std::string keys_of(const Technique& technique) {
    std::string keys;
    for (const ParameterId id : technique.parameters)
        keys += fmt::format("{}{}", keys.empty() ? "" : ", ", parameter(id).key);
    return keys;
}

void set_parameter(Configuration& configuration, std::string_view setting) {
    const Technique& technique = *configuration.technique;
    const std::size_t equals = setting.find('=');
    const std::string_view key = setting.substr(0, equals);
    const Parameter* row = find_parameter(key);
    if (row == nullptr || !technique.uses(row->id)) {
        const std::string keys = keys_of(technique);
        throw Error(keys.empty()
                        ? fmt::format("'{}' takes no parameters; leave ':{}' out.", technique.id, setting)
                        : fmt::format("'{}' has no parameter '{}'; use one of {}.", technique.id, key, keys));
    }
    if (equals == std::string_view::npos)
        throw Error(fmt::format("'{}' has no value; write {}:{}=VALUE.", setting, technique.id, key));
    configuration.values.set(row->id, parse_parameter(*row, setting.substr(equals + 1)));
}

}  // namespace

int geometry_passes(const Configuration& configuration) {
    const Technique& technique = *configuration.technique;
    const bool twice = technique.uses(ParameterId::moment_passes) &&
                       configuration.values.get<MomentSets>() != MomentSets::one;
    const bool depths_first = technique.uses(ParameterId::interval) &&
                              configuration.values.get<MomentInterval>() == MomentInterval::pixel;
    return technique.geometry_passes + (twice ? 1 : 0) + (depths_first ? 1 : 0);
}

std::string configuration_text(const Configuration& configuration) {
    std::string text = configuration.technique->id;
    char separator = ':';
    for_each_change(configuration, [&](const Parameter& row, const std::string& value) {
        text += fmt::format("{}{}={}", separator, row.key, value);
        separator = ',';
    });
    return text;
}

std::string configuration_options(const Configuration& configuration) {
    std::string options = fmt::format("--technique {}", configuration.technique->id);
    for_each_change(configuration, [&](const Parameter& row, const std::string& value) {
        options += fmt::format(" --{} {}", row.key, value);
    });
    return options;
}

Configuration parse_configuration(std::string_view text, const ParameterValues& base) {
    const std::size_t colon = text.find(':');
    Configuration configuration = {&require_technique(text.substr(0, colon)), base};
    while (colon != std::string_view::npos && !text.empty()) {
        text.remove_prefix(text.find_first_of(":,") + 1);
        const std::size_t end = text.find(',');
        set_parameter(configuration, text.substr(0, end));
        if (end == std::string_view::npos) break;
    }
    if (const char* why = why_refused(*configuration.technique, configuration.values); why != nullptr)
        throw Error(why);
    return configuration;
}

std::vector<std::string> split_configurations(std::string_view list) {
    std::vector<std::string> texts;
    for (;;) {
        const std::size_t end = list.find(',');
        const std::string_view part = list.substr(0, end);
        const bool goes_on =
            part.find('=') != std::string_view::npos && part.find(':') == std::string_view::npos;
        if (goes_on && !texts.empty())
            texts.back() += fmt::format(",{}", part);
        else
            texts.emplace_back(part);
        if (end == std::string_view::npos) return texts;
        list.remove_prefix(end + 1);
    }
}

}  // namespace momentscope
