#include "app/frame_log.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "core/support/error.hpp"
#include "core/support/output_file.hpp"
#include "ui/model/session.hpp"

namespace momentscope {

FrameLog::FrameLog(std::string path) : path_(std::move(path)) {
    if (path_.empty()) return;
    require_writable(path_);
    std::error_code code;
    replaces_ = std::filesystem::exists(path_, code) && std::filesystem::file_size(path_, code) > 0;
}

void FrameLog::frame(const ui::Explorer& explorer) {
    ++frames_;
    if (path_.empty()) return;
    const std::string computed = explorer.workspace().report.text();
    line(fmt::format("frame {}: {}{}", frames_, computed.empty() ? "nothing computed" : computed,
                     changes(explorer)));
}

// What the input of the frame changed in the state, as paths in a session, and whether lists or menus opened
// or closed.
std::string FrameLog::changes(const ui::Explorer& explorer) {
    std::string text;
    if (state_ && !(*state_ == explorer.workspace().state)) {
        std::set<std::string> paths;  // an array has one path for each element
        for (const auto& step : nlohmann::ordered_json::diff(ui::session_to_json(*state_),
                                                             ui::session_to_json(explorer.workspace().state)))
            paths.insert(step["path"].get<std::string>());
        text += fmt::format("; changed {}", fmt::join(paths, " "));
    }
    state_ = explorer.workspace().state;
    const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
    if (popup != popup_) text += popup ? "; a popup opened" : "; a popup closed";
    popup_ = popup;
    return text;
}

void FrameLog::line(const std::string& text) {
    if (path_.empty()) return;
    if (replaces_) {
        held_ += text + "\n";
        return;
    }
    if (!file_.is_open()) file_.open(path_, std::ios::binary);
    file_ << text << '\n' << std::flush;  // so that the log of a running window can be watched
}

void FrameLog::require_written() {
    if (replaces_) return write_file(held_, path_);
    if (!path_.empty() && !file_)
        throw Error(
            fmt::format("The log '{}' could not be written; free some space, or write it elsewhere.", path_));
}

}  // namespace momentscope
