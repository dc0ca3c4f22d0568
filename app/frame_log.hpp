// frame_log.hpp -- the log of --log: the frames that were drawn, what each computed, and what input changed.
#pragma once
#include <fstream>
#include <optional>
#include <string>

#include "ui/window/explorer.hpp"

namespace momentscope {

class FrameLog {
public:
    /// An empty path logs nothing. Throws Error if the file cannot be written. A new file grows during the
    /// run and can be watched. A file with content is replaced only by require_written(), so that nothing is
    /// lost if the run fails or the disk is full.
    explicit FrameLog(std::string path);

    void frame(const ui::Explorer& explorer);
    void line(const std::string& text);

    /// Call this at the end of a successful run. Throws Error if lines were lost.
    void require_written();
    long frames() const { return frames_; }

private:
    std::string changes(const ui::Explorer& explorer);

    std::string path_;
    bool replaces_ = false;  // whether the file has content that must not be lost
    std::string held_;       // lines that are not in the file yet
    std::ofstream file_;
    long frames_ = 0;
    std::optional<ui::ExplorerState> state_;  // state in the last frame
    bool popup_ = false;                      // whether a popup was open in it
};

}  // namespace momentscope
