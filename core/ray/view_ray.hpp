// view_ray.hpp -- the fragments along one view ray, and the true functions of depth along it.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace momentscope {

/// One transparent fragment of a pixel.
struct Fragment {
    float depth = 0;         // warped, in [-1, 1]
    float view_depth = 0;    // distance from the camera plane in scene units, > 0; depth if there is no warp
    float opacity = 0;       // alpha_l, in [0, 1]
    glm::vec3 color{0};      // linear RGB, shaded, >= 0
    std::uint32_t draw = 0;  // index of the draw call, in submission order
    std::uint32_t primitive = 0;  // index of the triangle in this draw call
    std::uint32_t seed = 0;       // of its random numbers, for stochastic techniques
    float threshold = 0.5f;       // of hashed alpha testing, in [0, 1]
    friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// How view depth is mapped to depth: logarithmically for the eye (paper, Section 3.3), linearly for the
/// light (paper, Section 6). Without a warp both are equal.
struct DepthWarp {
    enum class Kind { none, logarithmic, linear } kind = Kind::none;
    float z_min = -1;  // this view depth maps to -1, z_max to 1; 0 < z_min < z_max unless none
    float z_max = 1;
    bool has_view_depths() const { return kind != Kind::none; }
    friend bool operator==(const DepthWarp&, const DepthWarp&) = default;
};

/// The fragments of one low-resolution pixel from which a pixel reads moments, and its weight in the mixture.
struct LowResolutionSource {
    float weight = 1;  // in [0, 1]; the weights of a pixel sum to 1
    std::vector<Fragment> fragments;
    friend bool operator==(const LowResolutionSource&, const LowResolutionSource&) = default;
};

/// All fragments of a ray in submission order. Moments are summed in this order.
struct ViewRay {
    std::vector<Fragment> fragments;
    DepthWarp warp;
    float near_plane = 0;  // of the camera; 0 if unknown
    float far_plane = 0;
    /// The pixel reads a mixture of these. If there are none, it reads its own fragments.
    std::vector<LowResolutionSource> low_resolution_sources = {};
    friend bool operator==(const ViewRay&, const ViewRay&) = default;
};

/// The seed of the random numbers of a fragment (shaders/shared/random_bits.glsl). pixel: x + 65536 y,
/// counted from the lower left. depth_bits: the bits of the view depth.
std::uint32_t fragment_seed(std::uint32_t pixel, std::uint32_t object, std::uint32_t depth_bits);

/// The i-th random number of a seed, in [0, 1).
float unit_random(std::uint32_t seed, int i);

/// The absorbance -ln(1 - alpha_l) as the shaders compute it, in [0, 10].
float fragment_absorbance(float opacity);

/// exp(-absorbance) as the shaders compute it.
float transmittance(float absorbance);

/// The depth in [-1, 1] of a view depth as the shaders compute it, and the inverse of this function.
float to_depth(float view_depth, const DepthWarp& warp);
float to_view_depth(float depth, const DepthWarp& warp);

/// The members of DepthWarpFactors (shaders/shared/fragment.glsl): origin, scale, linear (0 or 1). The kind
/// must not be none.
glm::vec3 depth_warp_factors(const DepthWarp& warp);

/// The sum of all absorbances, b0.
double total_absorbance(const ViewRay& ray);

/// The depth of each fragment, in submission order.
std::vector<float> own_depths(const ViewRay& ray);

/// "1 fragment", "5 fragments".
std::string fragment_count_text(std::size_t count);

/// A(z) at each depth: the sum of the absorbances of all fragments with z_l < z. `depths` may be in any
/// order.
std::vector<double> true_absorbance(const ViewRay& ray, std::span<const float> depths);

/// Indices of the fragments from front to back. At equal depths, the fragment that was submitted later lies
/// in front, as in sorted.frag.
std::vector<std::size_t> front_to_back(const ViewRay& ray);

}  // namespace momentscope
