#include "app/frame_log.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/error.hpp"
#include "core/output_file.hpp"
#include "ui/session.hpp"

namespace momentscope {

FrameLog::FrameLog(const std::string& path) {
    if (path.empty()) return;
    require_writable(path);
    file_.open(path, std::ios::binary | std::ios::trunc);
    if (!file_) throw Error(fmt::format("The log '{}' cannot be written; check its permissions.", path));
}

void FrameLog::frame(const ui::Explorer& explorer) {
    ++frames_;
    if (!file_.is_open()) return;
    const std::string computed = explorer.report().text();
    line(fmt::format("frame {}: {}{}", frames_, computed.empty() ? "nothing computed" : computed,
                     changes(explorer)));
}

// What the frame's input did to the state, by its pointers in a session, and to lists and menus.
std::string FrameLog::changes(const ui::Explorer& explorer) {
    std::string text;
    if (state_ && !(*state_ == explorer.state())) {
        std::set<std::string> paths;  // an array has one for each element
        for (const auto& step : nlohmann::ordered_json::diff(ui::session_to_json(*state_),
                                                             ui::session_to_json(explorer.state())))
            paths.insert(step["path"].get<std::string>());
        text += fmt::format("; changed {}", fmt::join(paths, " "));
    }
    state_ = explorer.state();
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (popup != popup_) text += popup ? "; a popup opened" : "; a popup closed";
    popup_ = popup;
    return text;
}

void FrameLog::line(const std::string& text) {
    if (file_.is_open()) file_ << text << std::endl;  // flushed, so that a running window can be watched
}

}  // namespace momentscope
