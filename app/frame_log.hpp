// frame_log.hpp -- which frames were drawn, what each had to compute, and what input changed: for --log.
#pragma once
#include <fstream>
#include <optional>
#include <string>

#include "ui/explorer.hpp"

namespace momentscope {

class FrameLog {
public:
    /// An empty path logs nothing. Throws Error when the file cannot be written. What it holds stays until
    /// a frame has computed something: then all inputs were good.
    explicit FrameLog(std::string path);

    void frame(const ui::Explorer& explorer);
    void line(const std::string& text);

    /// The end of a run that went well. Throws Error when lines were lost.
    void require_written();
    long frames() const { return frames_; }

private:
    void open();
    std::string changes(const ui::Explorer& explorer);

    std::string path_;
    std::string held_;  // lines before the file is opened
    std::ofstream file_;
    long frames_ = 0;
    std::optional<ui::ExplorerState> state_;  // of the last frame
    bool popup_ = false;                      // was one open in it?
};

}  // namespace momentscope
