#include "app/frame_log.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "core/output_file.hpp"

namespace momentscope {

FrameLog::FrameLog(std::string path) : path_(std::move(path)) {
    if (!path_.empty()) require_writable(path_);
}

void FrameLog::frame(const ui::Explorer& explorer) {
    ++frames_;
    const std::string computed = explorer.report().text();
    if (!computed.empty()) open();
    line(fmt::format("frame {}: {}", frames_, computed.empty() ? "nothing computed" : computed));
}

void FrameLog::open() {
    if (path_.empty() || file_.is_open()) return;
    file_.open(path_, std::ios::binary | std::ios::trunc);
    file_ << std::exchange(held_, "") << std::flush;
}

void FrameLog::line(const std::string& text) {
    if (path_.empty()) return;
    if (file_.is_open())
        file_ << text << std::endl;  // flushed, so that a running window can be watched
    else
        held_ += text + "\n";
}

void FrameLog::require_written() {
    open();
    if (!file_)
        throw Error(fmt::format("The log '{}' could not be written; free space, or write elsewhere.", path_));
}

}  // namespace momentscope
