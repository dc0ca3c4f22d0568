// frame_report.hpp -- what a frame had to compute, for the log and for tests.
#pragma once
#include <string>

namespace momentscope::ui {

/// What a frame had to compute. All false if nothing changed.
struct FrameReport {
    bool draft = false;  // a draft was drawn instead of the full picture
    bool opaque = false, first_pass = false, second_pass = false, composite = false;
    bool failures = false, reference = false, comparison = false, capture = false, plot = false,
         query = false;

    /// Such as "second pass, composite, plot"; "" if nothing was computed.
    std::string text() const;
};

}  // namespace momentscope::ui
