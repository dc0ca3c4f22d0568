#include "app/ignored_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

template <typename Range>
bool contains(const Range& ids, ParameterId id) {
    return std::ranges::find(ids, id) != ids.end();
}

// Returns an empty text if the parameter is read.
std::string why_ignored(ParameterId id, const ParameterReading& reading, const ParameterValues& values) {
    if (contains(reading.others, id)) return "";
    if (std::ranges::any_of(reading.techniques, [&](const Technique* t) { return t->uses(id); })) return "";
    if (id == ParameterId::opacity)
        return reading.mesh
                   ? ""
                   : "without a mesh file, because built-in scenes and rays have their own opacities";
    if (id == ParameterId::tone_map)
        return reading.tone_map ? "" : "here, because it is only for pictures that end in .png";
    if (id == ParameterId::order && reading.order) return "";
    if (id == ParameterId::order_seed && reading.order)
        return values.get<OrderKind>() == OrderKind::shuffled ? "" : "without --order shuffled";
    if (id == ParameterId::shadows && reading.picture) return "";
    if (contains(SHADOW_PARAMETERS, id) && reading.picture)
        return values.is_on(ParameterId::shadows) ? "" : "without --shadows";
    if (reading.techniques.empty()) return "here";
    if (reading.techniques.size() == 1) return fmt::format("with {}", reading.techniques.front()->id);
    return "with these techniques";
}

}  // namespace

void refuse_ignored_options(const CLI::App& command, std::initializer_list<Ignored> rows) {
    for (const Ignored& row : rows)
        if (row.when && command.get_option(row.option)->count() > 0)
            throw Error(fmt::format("{} changes nothing {}; leave it out.", row.option, row.why));
}

void refuse_ignored_parameters(const ParameterOptions& typed, const ParameterReading& reading) {
    const ParameterValues values = typed.over();
    for (const Parameter& row : parameters()) {
        if (!typed.has(row.id)) continue;
        const std::string why = why_ignored(row.id, reading, values);
        if (!why.empty()) throw Error(fmt::format("--{} changes nothing {}; leave it out.", row.key, why));
    }
}

std::vector<const Technique*> techniques_in(const std::vector<Configuration>& configurations) {
    std::vector<const Technique*> techniques;
    for (const Configuration& one : configurations) techniques.push_back(one.technique);
    return techniques;
}

std::vector<ParameterId> reconstruction_parameters(const std::vector<const Technique*>& techniques) {
    std::vector<ParameterId> read;
    using enum ParameterId;
    for (const ParameterId id : {beta, theta, alpha, preset, solver, tolerance, estimate, ends, interval})
        if (std::ranges::any_of(techniques, [&](const Technique* t) { return t->uses(id); }))
            read.push_back(id);
    return read;
}

void refuse_nonsense(std::span<const Technique* const> techniques, const ParameterValues& values) {
    for (const Technique* technique : techniques)
        if (const char* why = why_refused(*technique, values); why != nullptr)
            throw Error(fmt::format("{}: {}", technique->id, why));
}

bool ends_in(const std::string& path, const char* extension) {
    return std::filesystem::path(path).extension() == extension;
}

void refuse_empty_switches(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_items_expected_min() == 0 &&
            std::ranges::find(option->results(), "") != option->results().end())
            throw Error(fmt::format("{} has an empty value; give on or off, or leave the value out.",
                                    option->get_name()));
}

void refuse_empty_values(CLI::App& command) {
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0)
            option->check(
                [](const std::string& value) { return std::string(value.empty() ? "has no value" : ""); });
}

// CLI11 treats "--renormalize=" like "--renormalize".
void refuse_empty_assignments(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word.starts_with("--") && word.ends_with("=") && word.find('=') == word.size() - 1)
            throw Error(fmt::format("'{}' has no value; write one after it, or leave the option out.", word));
    }
}

}  // namespace momentscope
