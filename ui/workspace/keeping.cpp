#include "ui/workspace/keeping.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "core/support/error.hpp"
#include "core/support/json_text.hpp"

namespace momentscope::ui {

namespace {

constexpr const char* SETTINGS = "settings";
constexpr const char* PROGRESS = "progress";

// Calls `read` with the kept text, if there is one. False if it cannot be used.
template <typename Read>
bool restore(Workspace& w, const char* name, const Read& read) {
    try {
        const std::string text = w.options.host.kept(name);
        if (!text.empty()) read(text);
        return true;
    } catch (const Error& error) {
        w.status.say(error.what());
        return false;
    }
}

void keep(Workspace& w, const char* name, const std::string& text, bool& can_keep) {
    if (!can_keep) return;
    try {
        w.options.host.keep(name, text);
    } catch (const Error& error) {
        can_keep = false;
        w.status.say(error.what());
    }
}

}  // namespace

Settings kept_settings(const std::function<std::string(const std::string&)>& kept) {
    try {
        const std::string text = kept(SETTINGS);
        return text.empty() ? NEW_USER : settings_from_json(text);
    } catch (const Error&) {
        return NEW_USER;
    }
}

void restore_kept(Workspace& w) {
    if (!w.options.host.keep) return;
    w.kept.can_keep_settings =
        restore(w, SETTINGS, [&](const std::string& text) { w.settings = settings_from_json(text); });
    w.kept.can_keep_progress =
        restore(w, PROGRESS, [&](const std::string& text) { w.lesson.progress = progress_from_json(text); });
    w.kept.settings = w.settings;
}

void keep_changes(Workspace& w) {
    if (!w.options.host.keep) return;
    if (!(std::exchange(w.kept.settings, w.settings) == w.settings))
        keep(w, SETTINGS, json_text(settings_to_json(w.settings), 1) + "\n", w.kept.can_keep_settings);
    if (std::exchange(w.kept.progress_changes, w.lesson.changes()) != w.lesson.changes())
        keep(w, PROGRESS, json_text(progress_to_json(w.lesson.progress), 1) + "\n", w.kept.can_keep_progress);
}

}  // namespace momentscope::ui
