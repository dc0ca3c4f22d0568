// json_reader.hpp -- reads an object of a session or another file key by key, checks every value, and reports
// unknown keys.
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/support/error.hpp"

namespace momentscope::ui {

constexpr std::size_t MAX_NAMED = 20;  // number of unknown keys that are reported; a file may have millions
constexpr std::size_t MAX_NAME = 60;   // length of a reported key

/// Reads the keys of one object. All keys that were not read are unknown; the first of them are reported.
class JsonReader {
public:
    /// what: names the file in messages.
    JsonReader(const nlohmann::json& object, std::string path, std::vector<std::string>& ignored,
               const char* what = "session")
        : object_(object), path_(std::move(path)), ignored_(ignored), what_(what) {
        if (!object.is_object()) fail("", "an object");
    }
    ~JsonReader() {
        for (const auto& item : object_.items())
            if (!known_.contains(item.key()) && ignored_.size() < MAX_NAMED)
                ignored_.push_back(path_ + item.key().substr(0, MAX_NAME));
    }
    JsonReader(const JsonReader&) = delete;
    JsonReader& operator=(const JsonReader&) = delete;

    /// nullptr if the key is missing.
    const nlohmann::json* find(const std::string& key) {
        known_.insert(key);
        const auto found = object_.find(key);
        return found == object_.end() ? nullptr : &*found;
    }
    /// Fails unless the key holds this version of the file's form.
    void version(const std::string& key, int version) {
        const nlohmann::json* found = find(key);
        if (found == nullptr || *found != version) fail(key, fmt::format("{}", version));
    }
    void flag(const std::string& key, bool& value) {
        if (const nlohmann::json* found = find(key)) {
            if (!found->is_boolean()) fail(key, "true or false");
            value = found->get<bool>();
        }
    }
    void number(const std::string& key, float& value, float low, float high) {
        if (const nlohmann::json* found = find(key)) value = checked(*found, key, low, high);
    }
    void text(const std::string& key, std::string& value) {
        if (const nlohmann::json* found = find(key)) {
            if (!found->is_string()) fail(key, "a text");
            value = found->get<std::string>();
        }
    }
    template <typename Enum>
    void choice(const std::string& key, Enum& value, std::span<const char* const> names) {
        const nlohmann::json* found = find(key);
        if (found == nullptr) return;
        const std::string name = found->is_string() ? found->get<std::string>() : "";
        const auto at = std::ranges::find(names, name);
        if (at == names.end()) fail(key, fmt::format("one of {}", fmt::join(names, ", ")));
        value = static_cast<Enum>(at - names.begin());
    }
    /// A list of `count` numbers, each in [low, high].
    std::vector<float> numbers(const nlohmann::json& list, const std::string& key, std::size_t count,
                               float low, float high) const {
        if (!list.is_array() || list.size() != count) fail(key, fmt::format("a list of {} numbers", count));
        std::vector<float> values;
        for (const nlohmann::json& entry : list) values.push_back(checked(entry, key, low, high));
        return values;
    }
    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        const std::string name = path_ + key;
        throw Error(fmt::format("The {0}'s {1} must be {2}; correct it, or save the {0} anew.", what_,
                                name.empty() ? "content" : "\"" + name + "\"", what));
    }

private:
    float checked(const nlohmann::json& value, const std::string& key, float low, float high) const {
        const float number = value.is_number() ? value.get<float>() : std::nanf("");
        if (!(number >= low && number <= high))
            fail(key, fmt::format("a number from {:g} to {:g}", low, high));
        return number;
    }

    const nlohmann::json& object_;
    std::string path_;
    std::vector<std::string>& ignored_;
    const char* what_;
    std::set<std::string> known_;
};

}  // namespace momentscope::ui
