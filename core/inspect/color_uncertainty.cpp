#include "core/inspect/color_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/inspect/fragment_estimates.hpp"
#include "core/inspect/pixel_color.hpp"

namespace momentscope {

namespace {

constexpr glm::vec3 LUMINANCE = {0.2126f, 0.7152f, 0.0722f};  // of linear sRGB (Rec. 709)

double open_luminance(const ViewRay& ray, const std::vector<FragmentEstimate>& estimates) {
    double sum = 0;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        const Fragment& fragment = ray.fragments[i];
        const double wider = std::exp(-static_cast<double>(estimates[i].lower)) -
                             std::exp(-static_cast<double>(estimates[i].upper));
        sum += static_cast<double>(fragment.opacity * std::abs(glm::dot(LUMINANCE, fragment.color))) * wider;
    }
    return sum;
}

}  // namespace

ColorUncertainty color_uncertainty(const PixelCapture& capture, const Configuration& configuration) {
    if (capture.ray.fragments.empty()) return {};
    const Technique& technique = *configuration.technique;
    const ResolvedParameters parameters = resolve(configuration.values, technique);
    const auto rows = pixel_history(capture.ray, {}, technique, configuration.values);
    const PixelColors colors = pixel_colors(capture.ray, rows, technique, parameters, capture.behind);
    return {true,
            static_cast<float>(
                open_luminance(capture.ray, fragment_estimates(capture.ray, technique, parameters))),
            std::abs(glm::dot(LUMINANCE, colors.technique - colors.truth))};
}

std::string uncertainty_text(std::span<const ColorUncertainty> pixels) {
    double open = 0, error = 0, open2 = 0, error2 = 0, both = 0;
    long count = 0, beyond = 0;
    for (const ColorUncertainty& pixel : pixels) {
        if (!pixel.covered) continue;
        const auto u = static_cast<double>(pixel.open), e = static_cast<double>(pixel.error);
        open += u;
        error += e;
        open2 += u * u;
        error2 += e * e;
        both += u * e;
        beyond += e > u + 1e-3 ? 1 : 0;
        ++count;
    }
    if (count == 0) return "No pixel has a fragment.\n";
    const auto n = static_cast<double>(count);
    const double spread =
        std::sqrt(std::max(n * open2 - open * open, 0.0) * std::max(n * error2 - error * error, 0.0));
    return fmt::format(
        "Luminance that the bounds leave open, mean of {} pixels  {:.5f}\n"
        "Error of the luminance, mean                          {:.5f}\n"
        "Correlation of the two                                {:.2f}\n"
        "Pixels whose error exceeds what is open by 0.001      {:.1f} %\n",
        count, open / n, error / n, spread > 0 ? (n * both - open * error) / spread : 0.0,
        100.0 * static_cast<double>(beyond) / n);
}

}  // namespace momentscope
