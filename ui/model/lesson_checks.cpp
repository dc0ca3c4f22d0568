#include "ui/model/lesson_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/inspect/error_causes.hpp"
#include "core/support/error.hpp"
#include "ui/model/lesson_keys.hpp"

namespace momentscope::ui {

namespace {

using nlohmann::json;

MeasureId measure_from(const LessonKeys& keys, const json& value, const char* key) {
    const std::string name = value.is_string() ? value.get<std::string>() : "";
    const auto row =
        std::ranges::find(MEASURES, name, [](const MeasureRow& r) { return std::string_view(r.key); });
    if (row != MEASURES.end()) return row->id;
    std::vector<std::string_view> names;
    for (const MeasureRow& r : MEASURES) names.emplace_back(r.key);
    keys.fail(key, fmt::format("one of {}", fmt::join(names, ", ")));
}

Limits any_limits_from(LessonKeys& keys) {
    Limits limits = {
        .is = keys.number("is"), .at_least = keys.number("at_least"), .at_most = keys.number("at_most")};
    limits.within = keys.number("within").value_or(1e-6);
    return limits;
}

Limits limits_from(LessonKeys& keys) {
    const Limits limits = any_limits_from(keys);
    if (!limits.is && !limits.at_least && !limits.at_most)
        throw Error(keys.where() + "a check of a number needs \"is\", \"at_least\" or \"at_most\".");
    return limits;
}

Check state_check(LessonKeys& keys, const json& pointer) {
    StateCheck check;
    check.pointer = pointer.is_string() ? pointer.get<std::string>() : "";
    const json* is = keys.take("is");
    if (is != nullptr && !is->is_number()) {
        check.equals = *is;
        if (is->is_null()) keys.fail("is", "a value");
    } else {
        check.limits = limits_from(keys);
    }
    return check;
}

Check number_check(LessonKeys& keys, const json& measure) {
    const auto within = keys.number("within");
    if (!within || !(*within > 0)) keys.fail("within", "a number above 0: how far the typed one may be off");
    NumberCheck check = {measure_from(keys, measure, "number"), *within};
    const json* mistakes = keys.take("mistakes");
    if (mistakes != nullptr && !mistakes->is_array()) keys.fail("mistakes", "a list");
    for (const json& entry : mistakes == nullptr ? json::array() : *mistakes) {
        LessonKeys mistake(entry, keys.where() + "a mistake: ");
        const auto number = mistake.number("is");
        check.mistakes.push_back({number.value_or(0), mistake.text("why")});
        if (!number) mistake.fail("is", "a number");
        if (check.mistakes.back().why.empty()) mistake.fail("why", "what is said about it");
        mistake.require_known();
    }
    return check;
}

bool is_cause(std::string_view text) {
    return std::ranges::any_of(cause::ALL, [&](std::string_view one) { return one.starts_with(text); });
}

Check choice_check(LessonKeys& keys, const json& options) {
    constexpr std::size_t MOST = 8;
    if (!options.is_array() || options.size() < 2 || options.size() > MOST)
        keys.fail("choice", fmt::format("a list of 2 to {} options", MOST));
    ChoiceCheck check;
    for (const json& entry : options) {
        LessonKeys option(entry, keys.where() + "an option: ");
        check.options.push_back(
            {option.text("text"), option.text("why"), option.flag("right"), option.text("cause")});
        option.require_known();
        if (check.options.back().text.empty()) option.fail("text", "the text of the option");
        if (check.options.back().why.empty()) option.fail("why", "what is said if this is chosen");
    }
    for (const auto& option : check.options)
        if (!option.cause.empty() && !is_cause(option.cause))
            keys.fail("cause", fmt::format("the begin of one of: {}", fmt::join(cause::ALL, ", ")));
    const bool causes =
        std::ranges::none_of(check.options, [](const auto& option) { return option.cause.empty(); });
    if (!causes && std::ranges::count_if(check.options, &ChoiceCheck::Option::right) != 1)
        keys.fail("choice", "options of which exactly one is \"right\", or which all have a \"cause\"");
    return check;
}

Check text_check(LessonKeys& keys, const json& words) {
    if (!words.is_number_unsigned() || words.get<std::size_t>() < 1 || words.get<std::size_t>() > 1000)
        keys.fail("text", "the least number of words, from 1 to 1000");
    return TextCheck{words.get<std::size_t>()};
}

// The kinds of checks. The key of a kind names what is checked.
struct CheckKind {
    const char* key;
    Check (*read)(LessonKeys& keys, const json& value);
};
constexpr CheckKind CHECK_KINDS[] = {
    {"state", state_check},
    {"measure",
     [](LessonKeys& keys, const json& value) -> Check {
         return MeasureCheck{measure_from(keys, value, "measure"), any_limits_from(keys)};
     }},
    {"number", number_check},
    {"choice", choice_check},
    {"text", text_check},
};

Check check_from(const json& object, const std::string& where) {
    LessonKeys keys(object, where + "a check: ");
    const auto is_named = [&](const CheckKind& kind) { return object.contains(kind.key); };
    const auto kind = std::ranges::find_if(CHECK_KINDS, is_named);
    if (kind == std::end(CHECK_KINDS))
        throw Error(keys.where() +
                    "it names nothing; it needs one of state, measure, number, choice and text.");
    if (std::ranges::count_if(CHECK_KINDS, is_named) > 1)
        throw Error(keys.where() + "it names two kinds; make a list of two checks.");
    Check check = kind->read(keys, *keys.take(kind->key));
    keys.require_known();
    return check;
}

}  // namespace

std::vector<Check> checks_from(const json* value, const std::string& where) {
    std::vector<Check> checks;
    if (value == nullptr) return checks;
    if (!value->is_array()) return {check_from(*value, where)};
    for (const json& entry : *value) checks.push_back(check_from(entry, where));
    const auto asks = [](const Check& check) {
        return !std::holds_alternative<StateCheck>(check) && !std::holds_alternative<MeasureCheck>(check);
    };
    if (std::ranges::count_if(checks, asks) > 1)
        throw Error(where + "only one check of a step can ask for an answer; make two steps.");
    return checks;
}

}  // namespace momentscope::ui
