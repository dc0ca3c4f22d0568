// pixel_history.hpp -- what each fragment contributed to a pixel: the rows of the table in the window.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

struct PixelHistoryRow {
    std::size_t fragment;                      // index into ViewRay::fragments
    float absorbance;                          // -ln(1 - alpha_l), as the shaders compute it
    double true_transmittance;                 // of everything strictly in front
    float transmittance;                       // computed in C++; for a ground truth, the truth
    std::optional<float> gl_transmittance;     // by the second pass of the GL, if there is one
    glm::vec4 source;                          // what blending adds: T alpha_l (colour, 1); 0 if not drawn
    glm::vec4 sum;                             // the sum before it, of all submitted earlier
    std::optional<FragmentEstimate> estimate;  // with moments: what bounds the transmittance
    glm::vec4 uncertain;  // what renormalisation may add or take: spread alpha_l (colour, 1)

    /// Computed minus true. Positive if the fragment is too visible.
    double error() const { return static_cast<double>(transmittance) - true_transmittance; }
};

/// One row per fragment, from front to back. gl_transmittance is empty or has one value per fragment, in
/// submission order.
std::vector<PixelHistoryRow> pixel_history(const ViewRay& ray, std::span<const float> gl_transmittance,
                                           const Technique& technique, const ParameterValues& values);

/// The rows as CSV with a header.
std::string pixel_history_to_csv(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows);

}  // namespace momentscope
