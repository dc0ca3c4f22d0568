#include "core/bench/gpu_check_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/support/json_text.hpp"

namespace momentscope {

namespace {

using json = nlohmann::ordered_json;

const char* ordered_text(OrderedAccess access) {
    switch (access) {
        case OrderedAccess::interlock:
            return "interlock";
        case OrderedAccess::framebuffer_fetch:
            return "framebuffer fetch";
        case OrderedAccess::none:
            break;
    }
    return "none";
}

const char* rounding_text(Rounding rounding) {
    switch (rounding) {
        case Rounding::precise:
            return "kept by 'precise'";
        case Rounding::unguarded:
            return "kept by the driver";
        case Rounding::guarded:
            return "kept by guards";
        case Rounding::lost:
            break;
    }
    return "lost";
}

// The capabilities as names and values.
std::vector<std::pair<const char*, json>> capability_rows(const Capabilities& can) {
    return {{"shaders", row_of(can.language.dialect).name},
            {"rounding", rounding_text(can.language.rounding)},
            {"storage", can.storage},
            {"ordered", ordered_text(can.ordered)},
            {"unorm16", can.unorm16},
            {"blending_per_target", can.blending_per_target},
            {"timer_queries", can.timer_queries},
            {"primitive_ids", can.primitive_ids},
            {"color_targets", can.color_targets}};
}

std::string text_of(const json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    return value.is_string() ? value.get<std::string>() : value.dump();
}

const char* state_text(CheckState state) {
    switch (state) {
        case CheckState::checked:
            return "runs";
        case CheckState::unavailable:
            return "unavailable";
        case CheckState::failed:
            return "failed";
        case CheckState::not_reached:
            break;
    }
    return "not checked";
}

std::string row_text(const TechniqueCheck& row) {
    if (row.state != CheckState::checked)
        return fmt::format("{:<12}{}: {}\n", row.technique->id, state_text(row.state), row.why_not);
    const std::string bits = row.fragments == 0 ? "-" : fmt::format("{}", row.different);
    return fmt::format("{:<12}{:>10}{:>11}{:>11.1e}{:>13.1e}{:>11.2f}{:>11.2f}\n", row.technique->id,
                       row.fragments, bits, row.worst, row.picture_error, row.first_pass, row.second_pass);
}

}  // namespace

std::string gpu_check_verdict(const GpuCheck& check) {
    const TechniqueCheck all = check.sum();
    std::string text = fmt::format("{} of {} techniques run here.", check.count(CheckState::checked),
                                   check.techniques.size());
    if (const long failed = check.count(CheckState::failed); failed > 0)
        text += fmt::format(" {} failed; please report the messages.", failed);
    if (const long left = check.count(CheckState::not_reached); left > 0)
        text += fmt::format(" {} were not checked.", left);
    if (check.count(CheckState::checked) == 0) return text;
    if (check.has_same_bits())
        text += fmt::format(" All {} values of T have the bits of C++.", all.fragments);
    else
        text += fmt::format(
            " {} of {} values of T differ from C++, by at most {:.1e}. So this driver rounds differently, and the "
            "plot shows the picture only that closely; please report it with this text.",
            all.different, all.fragments, all.worst);
    if (all.picture_error <= PICTURE_TOLERANCE)
        return text + fmt::format(" No picture is off by more than {:.1e}.", all.picture_error);
    return text +
           fmt::format(" A picture is off by {:.1e}, which rounding does not explain; please report it.",
                       all.picture_error);
}

std::string gpu_check_text(const GpuCheck& check, const std::string& kind) {
    std::string text = fmt::format("{:<20}{}, by {}\n{:<20}{}\n", "GL", check.gl.renderer, kind, "version",
                                   check.gl.version);
    for (const auto& [name, value] : capability_rows(check.gl.can))
        text += fmt::format("{:<20}{}\n", name, text_of(value));
    for (const MissingFeature& missing : check.gl.missing)
        text += fmt::format("missing: {}; {}.\n", missing.feature, missing.consequence);
    text += fmt::format("\n{:<12}{:>10}{:>11}{:>11}{:>13}{:>11}{:>11}\n", "technique", "fragments", "differ",
                        "T off by", "picture off", "1st ms", "2nd ms");
    for (const TechniqueCheck& row : check.techniques) text += row_text(row);
    return text + fmt::format("\n{} This took {:.0f} s.\n", gpu_check_verdict(check), check.seconds);
}

std::string gpu_check_json(const GpuCheck& check, const std::string& kind) {
    json can, rows = json::array();
    for (const auto& [name, value] : capability_rows(check.gl.can)) can[name] = value;
    for (const TechniqueCheck& row : check.techniques)
        rows.push_back({{"technique", row.technique->id},
                        {"state", state_text(row.state)},
                        {"why_not", row.why_not},
                        {"fragments", row.fragments},
                        {"different", row.different},
                        {"worst", row.worst},
                        {"picture_error", row.picture_error},
                        {"first_pass_ms", row.first_pass},
                        {"second_pass_ms", row.second_pass}});
    const json all = {{"kind", kind},
                      {"renderer", check.gl.renderer},
                      {"version", check.gl.version},
                      {"software", check.gl.software},
                      {"capabilities", can},
                      {"techniques", rows},
                      {"same_bits", check.has_same_bits()},
                      {"passed", check.passed()},
                      {"verdict", gpu_check_verdict(check)},
                      {"seconds", check.seconds}};
    return json_text(all, 2) + "\n";
}

}  // namespace momentscope
