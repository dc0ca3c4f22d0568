#include "ui/model/link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/scene/scenes.hpp"
#include "core/support/error.hpp"
#include "core/support/json_text.hpp"
#include "ui/model/course.hpp"
#include "ui/model/selection.hpp"

namespace momentscope::ui {

namespace {

using nlohmann::ordered_json;

// What differs from `fresh`, in which an object stands for all its keys.
ordered_json difference(const ordered_json& value, const ordered_json& fresh) {
    ordered_json differing = ordered_json::object();
    for (const auto& [key, inner] : value.items()) {
        const auto before = fresh.find(key);
        if (before == fresh.end() || !before->is_object() || !inner.is_object()) {
            if (before == fresh.end() || *before != inner) differing[key] = inner;
        } else if (ordered_json part = difference(inner, *before); !part.empty()) {
            differing[key] = std::move(part);
        }
    }
    return differing;
}

void set_word(ExplorerState& state, const std::string& key, const std::string& value) {
    if (key == "scene") {
        if (!is_builtin_scene(value))
            throw Error(fmt::format(
                "The link asks for the scene '{}', which is not one of the built-in scenes.", value));
        return choose_scene(state, value);
    }
    if (key == "technique") {
        state.technique = &require_technique(value);
        return;
    }
    if (key == "lesson") {
        const auto lesson = std::ranges::find(own_lessons(), value, &Lesson::id);
        if (lesson == own_lessons().end())
            throw Error(fmt::format(
                "The link asks for the lesson '{}', which is not one of the built-in ones.", value));
        return open_lesson(state, *lesson);
    }
    const Parameter* const row = find_parameter(key);
    if (row == nullptr)
        throw Error(fmt::format(
            "The link has a word '{}', which is neither scene, technique, lesson nor a parameter.", key));
    state.parameters.set(row->id, parse_parameter(*row, value));
}

}  // namespace

std::string link_text(const ExplorerState& state) {
    require_session_name(state.scene);
    ordered_json text = difference(session_to_json(state), session_to_json(ExplorerState()));
    text["momentscope_session"] = SESSION_VERSION;
    return json_text(text);
}

ExplorerState state_of_words(const std::string& words, ExplorerState base) {
    for (std::size_t begin = 0; begin < words.size();) {
        const std::size_t end = std::min(words.find('&', begin), words.size());
        const std::string word = words.substr(begin, end - begin);
        const std::size_t equals = word.find('=');
        if (equals == std::string::npos)
            throw Error(
                fmt::format("The link has '{}' where a word, an equals sign and a value belong.", word));
        set_word(base, word.substr(0, equals), word.substr(equals + 1));
        begin = end + 1;
    }
    return base;
}

}  // namespace momentscope::ui
