#include "core/compare/flip.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>

#include "core/compare/color_spaces.hpp"

namespace momentscope {

namespace {

using Kernel = std::vector<double>;  // odd number of weights, the middle one at 0

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

/// Thrown through everything when the result is not wanted any more.
struct Stopped {};

// Sums of so many neighbours at once, which the compiler keeps in registers.
constexpr int BLOCK = 16;

// sums[x] = sum of kernel[k] * source(k)[x].
template <typename Source>
void weighted_rows(double* sums, int width, const Kernel& kernel, const Source& source) {
    int x = 0;
    for (; x + BLOCK <= width; x += BLOCK) {
        double block[BLOCK] = {};
        for (std::size_t k = 0; k < kernel.size(); ++k) {
            const double* row = source(k) + x;
            for (int i = 0; i < BLOCK; ++i) block[i] += kernel[k] * row[i];
        }
        std::copy_n(block, BLOCK, sums + x);
    }
    for (; x < width; ++x)
        for (std::size_t k = 0; k < kernel.size(); ++k) sums[x] += kernel[k] * source(k)[x];
}

// Beyond the edge lies what is at the edge.
Plane convolved_along_x(const Plane& from, const Kernel& kernel, const std::stop_token& stop) {
    const int radius = static_cast<int>(kernel.size()) / 2;
    Plane to(from.width, from.height);
    std::vector<double> padded(static_cast<std::size_t>(from.width + 2 * radius));
    for (int y = 0; y < from.height; ++y) {
        if (stop.stop_requested()) throw Stopped();
        for (int x = -radius; x < from.width + radius; ++x)
            padded[static_cast<std::size_t>(x + radius)] = from.at(std::clamp(x, 0, from.width - 1), y);
        weighted_rows(&to.at(0, y), from.width, kernel, [&](std::size_t k) { return &padded[k]; });
    }
    return to;
}

Plane convolved_along_y(const Plane& from, const Kernel& kernel, const std::stop_token& stop) {
    const int radius = static_cast<int>(kernel.size()) / 2;
    Plane to(from.width, from.height);
    for (int y = 0; y < from.height; ++y) {
        if (stop.stop_requested()) throw Stopped();
        weighted_rows(&to.at(0, y), from.width, kernel, [&](std::size_t k) {
            return &from.at(0, std::clamp(y + static_cast<int>(k) - radius, 0, from.height - 1));
        });
    }
    return to;
}

Plane convolved(const Plane& plane, const Kernel& along_x, const Kernel& along_y,
                const std::stop_token& stop) {
    return convolved_along_y(convolved_along_x(plane, along_x, stop), along_y, stop);
}

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

Plane filtered(const Plane& plane, std::initializer_list<Sensitivity> gaussians,
               const std::stop_token& stop) {
    constexpr double PI = std::numbers::pi;
    // Three standard deviations of the widest of all channels.
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * PI * PI)) * PIXELS_PER_DEGREE));
    Plane sum(plane.width, plane.height);
    double weight = 0;
    for (const Sensitivity& one : gaussians) {
        const Kernel kernel = sampled(radius, [&](double k) {
            const double degrees = k / PIXELS_PER_DEGREE;
            return std::exp(-PI * PI * degrees * degrees / one.b);
        });
        const double factor = one.a * std::sqrt(PI / one.b);
        const Plane part = convolved(plane, kernel, kernel, stop);
        for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += factor * part.values[i];
        weight += factor * sum_of(kernel) * sum_of(kernel);
    }
    for (double& value : sum.values) value /= weight;
    return sum;
}

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

// CIELAB with chroma that fades in the dark, as Hunt found.
glm::dvec3 hunt_lab(const glm::dvec3& linear) {
    const glm::dvec3 lab = lab_of_linear(linear);
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double color_distance(const glm::dvec3& a, const glm::dvec3& b) {
    const double hyab = std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
    return std::pow(hyab, 0.7);
}

// Blurred as by the eye at that distance.
std::vector<glm::dvec3> seen_colors(const Opponent& planes, const std::stop_token& stop) {
    const Plane y = filtered(planes.y, {{1, 0.0047}}, stop);
    const Plane cx = filtered(planes.cx, {{1, 0.0053}}, stop);
    const Plane cz = filtered(planes.cz, {{34.1, 0.04}, {13.5, 0.025}}, stop);
    std::vector<glm::dvec3> colors;
    colors.reserve(y.values.size());
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        const glm::dvec3 linear = linear_of_opponent({y.values[i], cx.values[i], cz.values[i]});
        colors.push_back(hunt_lab(glm::clamp(linear, 0.0, 1.0)));
    }
    return colors;
}

/// Lengths of the first and second derivatives of brightness.
struct Features {
    std::vector<double> edge, point;
};

// Positive and negative weights each sum to 1 in magnitude.
Kernel balanced(Kernel kernel) {
    double positive = 0, negative = 0;
    for (const double weight : kernel) (weight > 0 ? positive : negative) += weight;
    for (double& weight : kernel) weight /= weight > 0 ? positive : -negative;
    return kernel;
}

Features features_of(const Plane& y, const std::stop_token& stop) {
    const double sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE;  // in pixels
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    Kernel across = sampled(radius, gauss);
    const double weight = sum_of(across);
    for (double& value : across) value /= weight;
    const Kernel first = balanced(sampled(radius, [&](double x) { return -x * gauss(x); }));
    const Kernel second =
        balanced(sampled(radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * gauss(x); }));
    Plane brightness = y;
    for (double& value : brightness.values) value = (value + 16) / 116;
    const auto lengths = [&](const Kernel& derivative) {
        const Plane along_x = convolved(brightness, derivative, across, stop);
        const Plane along_y = convolved(brightness, across, derivative, stop);
        std::vector<double> result;
        result.reserve(along_x.values.size());
        for (std::size_t i = 0; i < along_x.values.size(); ++i)
            result.push_back(std::hypot(along_x.values[i], along_y.values[i]));
        return result;
    };
    return {lengths(first), lengths(second)};
}

struct Seen {
    std::vector<glm::dvec3> colors;
    Features features;
};

Seen seen(const Image& image, const std::stop_token& stop) {
    const Opponent planes = opponent_planes(image);
    return {seen_colors(planes, stop), features_of(planes.y, stop)};
}

std::vector<float> flip_differences(const Image& reference, const Image& test, const std::stop_token& stop) {
    auto other = std::async(std::launch::async, [&] { return seen(test, stop); });
    const Seen a = seen(reference, stop);
    const Seen b = other.get();
    const double most = color_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    constexpr double KNEE = 0.4, AT_KNEE = 0.95;
    std::vector<float> map;
    map.reserve(a.colors.size());
    for (std::size_t i = 0; i < a.colors.size(); ++i) {
        const double c = color_distance(a.colors[i], b.colors[i]);
        const double knee = KNEE * most;
        const double color =
            c < knee ? AT_KNEE * c / knee : AT_KNEE + (1 - AT_KNEE) * (c - knee) / (most - knee);
        const double feature = std::sqrt(std::max(std::abs(a.features.edge[i] - b.features.edge[i]),
                                                  std::abs(a.features.point[i] - b.features.point[i])) /
                                         std::numbers::sqrt2);
        map.push_back(static_cast<float>(std::pow(color, 1 - feature)));
    }
    return map;
}

}  // namespace

std::vector<float> flip_map(const Image& reference, const Image& test, const std::stop_token& stop) try {
    return flip_differences(reference, test, stop);
} catch (const Stopped&) {
    return {};
}

}  // namespace momentscope
