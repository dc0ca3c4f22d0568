#include "ui/plot/plot_notes.hpp"

#include <fmt/format.h>

namespace momentscope::ui {

std::string band_note(const Measurement& m) {
    if (m.curve.beta0.empty() || m.exit.where.empty()) return "";
    const std::string where = fmt::format(
        "Near z = {:.2f} the truth is outside the band by {:.3g}: ", m.exit.worst_depth, m.exit.worst);
    if (m.canonical.floored_pivots > 0)
        return where + "the matrix of the moments is singular in floats; increase the moment bias α.";
    return where + (m.curve.technique->has_bounds()
                        ? "the bounds are for the biased moments, not for the exact ones."
                        : "for trigonometric moments, β = 0 and β = 1 give no bounds.");
}

std::string failure_note(const Measurement& m) {
    if (m.failure.where.empty()) return "";
    return fmt::format(
        "At the depths ticked along the top, the result of the textbook solver is {}outside [0, b₀]: the matrix of the "
        "moments is singular in floats. Increase the moment bias α, or use the robust solver.",
        m.failure.no_number ? "NaN (drawn as 0) or " : "");
}

}  // namespace momentscope::ui
