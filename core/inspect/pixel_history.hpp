// pixel_history.hpp -- what each fragment did to a pixel: the rows of the window's table.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/inspect/curve.hpp"

namespace momentscope {

struct PixelHistoryRow {
    std::size_t fragment;                   // index into ViewRay::fragments
    float absorbance;                       // -ln(1 - alpha_l), as the shaders compute it
    double true_transmittance;              // of all that lies strictly in front
    float transmittance;                    // reconstructed in C++; the truth for techniques without moments
    std::optional<float> gl_transmittance;  // by the GL's second pass, where there is one
    glm::vec4 source;                       // what blending adds: T alpha_l (colour, 1); 0 if it is not drawn
    glm::vec4 sum;                          // what stood there before, with all submitted earlier

    /// Reconstructed minus true: positive where the fragment shines through too much.
    double error() const { return static_cast<double>(transmittance) - true_transmittance; }
};

/// One row per fragment, from front to back. gl_transmittance runs parallel to the fragments or is empty.
std::vector<PixelHistoryRow> pixel_history(const ViewRay& ray, std::span<const float> gl_transmittance,
                                           const Technique& technique, const ParameterValues& values);

/// The rows as CSV with a header.
std::string pixel_history_to_csv(const ViewRay& ray, const std::vector<PixelHistoryRow>& rows);

}  // namespace momentscope
