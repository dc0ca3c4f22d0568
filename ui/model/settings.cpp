#include "ui/model/settings.hpp"

#include <nlohmann/json.hpp>

#include "core/support/bounded_json.hpp"
#include "ui/model/json_reader.hpp"

namespace momentscope::ui {

namespace {

constexpr int SETTINGS_VERSION = 1;
constexpr const char* THEME_NAMES[] = {"dark", "light"};
constexpr float MOST_PIXELS = 16384;

}  // namespace

nlohmann::ordered_json settings_to_json(const Settings& settings) {
    return {{"momentscope_settings", SETTINGS_VERSION},
            {"theme", THEME_NAMES[static_cast<std::size_t>(settings.theme)]},
            {"text_scale", settings.text_scale},
            {"window", {settings.window.x, settings.window.y}},
            {"expert", settings.expert},
            {"moves", settings.moves}};
}

Settings settings_from_json(const std::string& text) {
    const nlohmann::json root = parse_bounded_json(text, {.bytes = MAX_SETTINGS_BYTES});
    Settings settings;
    std::vector<std::string> ignored;  // keys of later versions
    JsonReader reader(root, "", ignored, "settings file");
    reader.version("momentscope_settings", SETTINGS_VERSION);
    reader.choice("theme", settings.theme, THEME_NAMES);
    reader.number("text_scale", settings.text_scale, MIN_TEXT_SCALE, MAX_TEXT_SCALE);
    if (const nlohmann::json* found = reader.find("window")) {
        const auto size = reader.numbers(*found, "window", 2, 0, MOST_PIXELS);
        settings.window = {static_cast<int>(size[0]), static_cast<int>(size[1])};
    }
    reader.flag("expert", settings.expert);
    reader.flag("moves", settings.moves);
    return settings;
}

}  // namespace momentscope::ui
