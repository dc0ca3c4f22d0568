// frame_log.hpp -- which frames were drawn, and what each had to compute: for --log.
#pragma once
#include <fstream>
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

    std::string path_;
    std::string held_;  // lines before that
    std::ofstream file_;
    long frames_ = 0;
};

}  // namespace momentscope
