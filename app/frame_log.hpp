// frame_log.hpp -- which frames were drawn, and what each had to compute: for --log.
#pragma once
#include <fstream>
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
    std::ofstream file_;
    long frames_ = 0;
};

}  // namespace momentscope
