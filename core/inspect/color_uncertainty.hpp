// color_uncertainty.hpp -- what the moments of a pixel cannot know of its colour, without the truth, beside
// how wrong the colour is.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/inspect/pixel_capture.hpp"
#include "core/techniques/configuration.hpp"

namespace momentscope {

/// Both numbers are linear luminances.
struct ColorUncertainty {
    bool covered = false;  // are there fragments?
    float open = 0;        // the sum over fragments of opacity, luminance and (T high - T low)
    float error = 0;       // |luminance of the technique's colour - luminance of the true colour|
};

/// The open luminance with the last colour of a map.
constexpr float OPEN_FULL_SCALE = 2;

/// The uncertainty and the error of a captured pixel. The technique must have moments.
ColorUncertainty color_uncertainty(const PixelCapture& capture, const Configuration& configuration);

/// Numbers over all pixels with fragments, as text: means, their correlation, and how many errors exceed what
/// is open. This happens where fragments share a depth, or by renormalisation, bias and rounding.
std::string uncertainty_text(std::span<const ColorUncertainty> pixels);

}  // namespace momentscope
