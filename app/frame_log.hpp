// frame_log.hpp -- which frames were drawn, what each had to compute, and what input changed: for --log.
#pragma once
#include <fstream>
#include <optional>
#include <string>

#include "ui/explorer.hpp"

namespace momentscope {

class FrameLog {
public:
    /// An empty path logs nothing. Throws Error when the file cannot be written. A new file can be watched
    /// while it grows. One that holds something is replaced by require_written(), so that nothing is lost
    /// when the run fails or the disk is full.
    explicit FrameLog(std::string path);

    void frame(const ui::Explorer& explorer);
    void line(const std::string& text);

    /// The end of a run that went well. Throws Error when lines were lost.
    void require_written();
    long frames() const { return frames_; }

private:
    std::string changes(const ui::Explorer& explorer);

    std::string path_;
    bool replaces_ = false;  // is there something that must not be lost?
    std::string held_;       // lines that are not in the file yet
    std::ofstream file_;
    long frames_ = 0;
    std::optional<ui::ExplorerState> state_;  // of the last frame
    bool popup_ = false;                      // was one open in it?
};

}  // namespace momentscope
