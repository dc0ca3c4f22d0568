#include "core/compare/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "core/compare/color_spaces.hpp"
#include "core/compare/convolution.hpp"
#include "core/support/parallel_for.hpp"

namespace momentscope {

namespace {

template <typename Function>
Kernel sampled(int radius, const Function& function) {
    Kernel kernel;
    for (int k = -radius; k <= radius; ++k) kernel.push_back(function(static_cast<double>(k)));
    return kernel;
}

double sum_of(const Kernel& kernel) {
    double sum = 0;
    for (const double weight : kernel) sum += weight;
    return sum;
}

/// A Gaussian of the contrast sensitivity: a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees.
struct Sensitivity {
    double a, b;
};

/// Blurs a channel by its contrast sensitivity, a sum of Gaussians, and returns it row by row.
class Filter {
public:
    Filter(const Plane& plane, int first, std::initializer_list<Sensitivity> gaussians) {
        constexpr double PI = std::numbers::pi;
        // Three standard deviations of the widest Gaussian of all channels.
        const int radius =
            static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * PI * PI)) * PIXELS_PER_DEGREE));
        for (const Sensitivity& one : gaussians) {
            const Kernel kernel = sampled(radius, [&](double k) {
                const double degrees = k / PIXELS_PER_DEGREE;
                return std::exp(-PI * PI * degrees * degrees / one.b);
            });
            parts_.push_back({Convolution(plane, first, kernel, kernel), one.a * std::sqrt(PI / one.b)});
            weight_ += parts_.back().factor * sum_of(kernel) * sum_of(kernel);
        }
        row_.resize(static_cast<std::size_t>(plane.width));
    }

    const std::vector<double>& next() {
        std::ranges::fill(row_, 0.0);
        for (Part& part : parts_) {
            const std::vector<double>& row = part.convolution.next();
            for (std::size_t x = 0; x < row_.size(); ++x) row_[x] += part.factor * row[x];
        }
        for (double& value : row_) value /= weight_;
        return row_;
    }

private:
    struct Part {
        Convolution convolution;
        double factor;
    };
    std::vector<Part> parts_;
    double weight_ = 0;
    std::vector<double> row_;
};

struct Opponent {
    Plane y, cx, cz;
};

Opponent opponent_planes(const Image& image) {
    Opponent planes = {{image.width, image.height}, {image.width, image.height}, {image.width, image.height}};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::dvec3 linear = glm::clamp(glm::dvec3(image.pixels[i]), 0.0, 1.0);
        const glm::dvec3 opponent = opponent_of_linear(linear);
        planes.y.values[i] = opponent.x;
        planes.cx.values[i] = opponent.y;
        planes.cz.values[i] = opponent.z;
    }
    return planes;
}

// CIELAB with chroma that decreases in dark colours (Hunt effect).
glm::dvec3 hunt_lab(const glm::dvec3& linear) {
    const glm::dvec3 lab = lab_of_linear(linear);
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double color_distance(const glm::dvec3& a, const glm::dvec3& b) {
    const double hyab = std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
    return std::pow(hyab, 0.7);
}

/// Rows of a picture: `first` to `end` - 1.
struct Rows {
    int first, end;
};

// The colours, blurred like the eye sees them at this distance.
void see_colors(const Opponent& planes, Rows rows, std::span<glm::dvec3> colors) {
    Filter y(planes.y, rows.first, {{1, 0.0047}}), cx(planes.cx, rows.first, {{1, 0.0053}}),
        cz(planes.cz, rows.first, {{34.1, 0.04}, {13.5, 0.025}});
    for (auto at = colors.begin(); at != colors.end();) {
        const std::vector<double>&y_row = y.next(), &cx_row = cx.next(), &cz_row = cz.next();
        for (std::size_t x = 0; x < y_row.size(); ++x) {
            const glm::dvec3 linear = linear_of_opponent({y_row[x], cx_row[x], cz_row[x]});
            *at++ = hunt_lab(glm::clamp(linear, 0.0, 1.0));
        }
    }
}

// Scales positive and negative weights, so that each sum to 1 in magnitude.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const double weight : kernel) (weight > 0 ? positive : negative) += weight;
    for (double& weight : kernel) weight /= weight > 0 ? positive : -negative;
    return kernel;
}

// The lengths of the first derivative (edges) or of the second (points) of brightness.
void see_features(const Plane& brightness, bool points, Rows rows, std::span<double> lengths) {
    const double sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE;  // in pixels
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    Kernel across = sampled(radius, gauss);
    const double weight = sum_of(across);
    for (double& value : across) value /= weight;
    const Kernel derivative = balanced(
        sampled(radius, [&](double x) { return (points ? x * x / (sigma * sigma) - 1 : -x) * gauss(x); }));
    Convolution along_x(brightness, rows.first, derivative, across),
        along_y(brightness, rows.first, across, derivative);
    for (auto at = lengths.begin(); at != lengths.end();) {
        const std::vector<double>&x_row = along_x.next(), &y_row = along_y.next();
        for (std::size_t x = 0; x < x_row.size(); ++x) *at++ = std::hypot(x_row[x], y_row[x]);
    }
}

constexpr int BAND = 64;  // rows of a part

}  // namespace

/// What FLIP compares of a picture.
struct FlipParts::Seen {
    Opponent planes;
    Plane brightness;
    std::vector<glm::dvec3> colors;
    std::vector<double> edges, points;

    explicit Seen(const Image& image)
        : planes(opponent_planes(image)),
          brightness(planes.y),
          colors(image.pixels.size()),
          edges(image.pixels.size()),
          points(image.pixels.size()) {
        for (double& value : brightness.values) value = (value + 16) / 116;
    }
};

FlipParts::FlipParts(const Image& reference, const Image& test)
    : bands_(static_cast<std::size_t>((reference.height + BAND - 1) / BAND)) {
    seen_.reserve(2);
    seen_.emplace_back(reference);
    seen_.emplace_back(test);
}

FlipParts::~FlipParts() = default;

std::size_t FlipParts::count() const {
    return 2 * 3 * bands_;
}

void FlipParts::run(std::size_t part) {
    Seen& one = seen_[part % 2];
    const int first = BAND * static_cast<int>(part / 6);
    const Rows rows{first, std::min(first + BAND, one.planes.y.height)};
    const auto of_band = [&](auto& values) {
        const auto width = static_cast<std::size_t>(one.planes.y.width);
        return std::span(values).subspan(static_cast<std::size_t>(rows.first) * width,
                                         static_cast<std::size_t>(rows.end - rows.first) * width);
    };
    switch (part / 2 % 3) {
        case 0:
            return see_colors(one.planes, rows, of_band(one.colors));
        case 1:
            return see_features(one.brightness, false, rows, of_band(one.edges));
        default:
            return see_features(one.brightness, true, rows, of_band(one.points));
    }
}

std::vector<float> FlipParts::map() const {
    const Seen &a = seen_[0], &b = seen_[1];
    const double most = color_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    constexpr double KNEE = 0.4, AT_KNEE = 0.95;
    std::vector<float> map(a.colors.size());
    const auto width = static_cast<std::size_t>(a.planes.y.width);
    parallel_for(static_cast<std::size_t>(a.planes.y.height), [&](std::size_t row) {
        for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
            const double c = color_distance(a.colors[i], b.colors[i]);
            const double knee = KNEE * most;
            const double color =
                c < knee ? AT_KNEE * c / knee : AT_KNEE + (1 - AT_KNEE) * (c - knee) / (most - knee);
            const double feature =
                std::sqrt(std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) /
                          std::numbers::sqrt2);
            map[i] = static_cast<float>(std::pow(color, 1 - feature));
        }
    });
    return map;
}

std::vector<float> flip_map(const Image& reference, const Image& test, const std::stop_token& stop) {
    FlipParts parts(reference, test);
    parallel_for(
        parts.count(), [&](std::size_t part) { parts.run(part); }, stop);
    if (stop.stop_requested()) return {};
    return parts.map();
}

}  // namespace momentscope
