// convolution.hpp -- convolves one number per pixel along both axes, row by row.
#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace momentscope {

using Kernel = std::vector<double>;  // odd number of weights; the middle one is at 0

/// One number per pixel.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    Plane(int width_, int height_)
        : width(width_),
          height(height_),
          values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    double& at(int x, int y) { return values[static_cast<std::size_t>(y * width + x)]; }
    const double& at(int x, int y) const { return values[static_cast<std::size_t>(y * width + x)]; }
};

// The number of neighbouring sums that are computed together. The compiler keeps them in registers.
constexpr int CONVOLVED_TOGETHER = 16;

// sums[x] = sum of kernel[k] * source(k)[x].
template <typename Source>
void weighted_rows(double* sums, int width, const Kernel& kernel, const Source& source) {
    int x = 0;
    for (; x + CONVOLVED_TOGETHER <= width; x += CONVOLVED_TOGETHER) {
        double block[CONVOLVED_TOGETHER] = {};
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const double* row = source(k) + x;
            for (int i = 0; i < CONVOLVED_TOGETHER; ++i) block[i] += kernel[k] * row[i];
        }
        std::copy_n(block, CONVOLVED_TOGETHER, sums + x);
    }
    for (; x < width; ++x)
        for (std::size_t k = 0; k < kernel.size(); ++k) sums[x] += kernel[k] * source(k)[x];
}

/// Convolves a plane along both axes and returns it row by row, from the row `first` on. It keeps only the
/// rows that the next one needs, so these stay in the cache. Pixels beyond the edge repeat those at the edge.
class Convolution {
public:
    Convolution(const Plane& plane, int first, Kernel along_x, Kernel along_y)
        : plane_(plane),
          along_x_(std::move(along_x)),
          along_y_(std::move(along_y)),
          padded_(static_cast<std::size_t>(plane.width) + along_x_.size() - 1),
          rows_(along_y_.size(), std::vector<double>(static_cast<std::size_t>(plane.width))),
          sums_(static_cast<std::size_t>(plane.width)),
          known_(std::max(first - static_cast<int>(along_y_.size()) / 2, 0)),
          row_(first) {}

    /// The next row; valid until the next call.
    const std::vector<double>& next() {
        const int radius = static_cast<int>(along_y_.size()) / 2;
        const int last = plane_.height - 1;
        for (; known_ <= std::min(row_ + radius, last); ++known_) convolve_along_x(known_);
        std::ranges::fill(sums_, 0.0);
        weighted_rows(sums_.data(), plane_.width, along_y_, [&](std::size_t k) {
            return row_of(std::clamp(row_ + static_cast<int>(k) - radius, 0, last)).data();
        });
        ++row_;
        return sums_;
    }

private:
    std::vector<double>& row_of(int y) { return rows_[static_cast<std::size_t>(y) % rows_.size()]; }

    void convolve_along_x(int y) {
        const int radius = static_cast<int>(along_x_.size()) / 2;
        for (int x = -radius; x < plane_.width + radius; ++x)
            padded_[static_cast<std::size_t>(x + radius)] = plane_.at(std::clamp(x, 0, plane_.width - 1), y);
        std::vector<double>& row = row_of(y);
        std::ranges::fill(row, 0.0);
        weighted_rows(row.data(), plane_.width, along_x_, [&](std::size_t k) { return &padded_[k]; });
    }

    const Plane& plane_;
    Kernel along_x_, along_y_;
    std::vector<double> padded_;
    std::vector<std::vector<double>> rows_;  // convolved along x; a ring of as many as along_y_ needs
    std::vector<double> sums_;
    int known_, row_;  // the first row that is not convolved along x; the next row
};

}  // namespace momentscope
