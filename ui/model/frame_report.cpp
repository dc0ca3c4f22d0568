#include "ui/model/frame_report.hpp"

namespace momentscope::ui {

std::string FrameReport::text() const {
    std::string text;
    const auto add = [&](bool happened, const char* name) {
        if (happened) text += (text.empty() ? "" : ", ") + std::string(name);
    };
    add(draft, "draft");
    add(opaque, "opaque");
    add(first_pass, "first pass");
    add(second_pass, "second pass");
    add(composite, "composite");
    add(failures, "failures");
    add(reference, "reference");
    add(comparison, "comparison");
    add(capture, "capture");
    add(plot, "plot");
    add(query && !plot, "query depth");
    return text;
}

}  // namespace momentscope::ui
