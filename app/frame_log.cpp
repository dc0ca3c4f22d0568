#include "app/frame_log.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/output_file.hpp"

namespace momentscope {

FrameLog::FrameLog(const std::string& path) {
    if (path.empty()) return;
    require_writable(path);
    file_.open(path, std::ios::binary | std::ios::trunc);
    if (!file_) throw Error(fmt::format("The log '{}' cannot be written; check its permissions.", path));
}

void FrameLog::frame(const ui::Explorer& explorer) {
    ++frames_;
    const std::string computed = explorer.report().text();
    line(fmt::format("frame {}: {}", frames_, computed.empty() ? "nothing computed" : computed));
}

void FrameLog::line(const std::string& text) {
    if (file_.is_open()) file_ << text << std::endl;  // flushed, so that a running window can be watched
}

}  // namespace momentscope
