// lesson_keys.hpp -- reads an object of a lesson key by key, and refuses keys that it does not know.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/support/error.hpp"
#include "core/support/plain_text.hpp"

namespace momentscope::ui {

/// An object of a lesson, whose keys are taken one by one. Each function that takes a key throws Error if its
/// value has another type. where: such as "step 2: ", for messages.
class LessonKeys {
public:
    LessonKeys(const nlohmann::json& object, std::string where) : object_(object), where_(std::move(where)) {
        if (!object.is_object()) throw Error(where_ + "it must be an object.");
    }
    /// nullptr if the key is missing.
    const nlohmann::json* take(const char* key) {
        taken_.emplace_back(key);
        const auto found = object_.find(key);
        return found == object_.end() ? nullptr : &*found;
    }
    /// One paragraph, or a list of paragraphs.
    std::string text(const char* key) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return "";
        if (found->is_string()) return found->get<std::string>();
        std::string joined;
        const auto is_text = [](const nlohmann::json& entry) { return entry.is_string(); };
        if (!found->is_array() || !std::ranges::all_of(*found, is_text))
            fail(key, "a text or a list of texts");
        for (const nlohmann::json& entry : *found)
            joined += (joined.empty() ? "" : "\n\n") + entry.get<std::string>();
        return joined;
    }
    std::vector<std::string> texts(const char* key) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return {};
        const auto is_text = [](const nlohmann::json& entry) { return entry.is_string(); };
        if (!found->is_array() || !std::ranges::all_of(*found, is_text)) fail(key, "a list of texts");
        return found->get<std::vector<std::string>>();
    }
    nlohmann::json object(const char* key) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return nlohmann::json::object();
        if (!found->is_object()) fail(key, "an object");
        return *found;
    }
    std::optional<double> number(const char* key) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return std::nullopt;
        if (!found->is_number()) fail(key, "a number");
        return found->get<double>();
    }
    /// A number from 1 to `most`.
    std::optional<std::size_t> count(const char* key, std::size_t most) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return std::nullopt;
        if (!found->is_number_unsigned() || found->get<std::size_t>() < 1 || found->get<std::size_t>() > most)
            fail(key, fmt::format("a whole number from 1 to {}", most));
        return found->get<std::size_t>();
    }
    bool flag(const char* key) {
        const nlohmann::json* found = take(key);
        if (found == nullptr) return false;
        if (!found->is_boolean()) fail(key, "true or false");
        return found->get<bool>();
    }
    /// Throws Error for keys that were not taken. Call this last.
    void require_known() const {
        for (const auto& item : object_.items())
            if (std::ranges::find(taken_, item.key()) == taken_.end())
                throw Error(fmt::format("{}there is no key \"{}\" here; it may have {}.", where_,
                                        one_line(item.key().substr(0, 60)), fmt::join(taken_, ", ")));
    }
    [[noreturn]] void fail(const char* key, const std::string& what) const {
        throw Error(fmt::format("{}\"{}\" must be {}.", where_, key, what));
    }
    const std::string& where() const { return where_; }

private:
    const nlohmann::json& object_;
    std::string where_;
    std::vector<std::string> taken_;
};

}  // namespace momentscope::ui
