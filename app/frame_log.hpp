// frame_log.hpp -- which frames were drawn, what each had to compute, and what input changed: for --log.
#pragma once
#include <fstream>
#include <optional>
#include <string>

#include "ui/explorer.hpp"

namespace momentscope {

class FrameLog {
public:
    /// An empty path logs nothing. Throws Error when the file cannot be written.
    explicit FrameLog(const std::string& path);

    void frame(const ui::Explorer& explorer);
    void line(const std::string& text);
    long frames() const { return frames_; }

private:
    std::string changes(const ui::Explorer& explorer);

    std::ofstream file_;
    long frames_ = 0;
    std::optional<ui::ExplorerState> state_;  // of the last frame
    bool popup_ = false;                      // was one open in it?
};

}  // namespace momentscope
