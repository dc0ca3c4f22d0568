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
    float depth = 0;              // warped, in [-1, 1]
    float view_depth = 0;         // distance from the camera plane in scene units, > 0; without a warp: depth
    float opacity = 0;            // alpha_l, in [0, 1]
    glm::vec3 color{0};           // linear RGB, shaded, >= 0
    std::uint32_t draw = 0;       // index of the draw call, in submission order
    std::uint32_t primitive = 0;  // index of the triangle in this draw call
    std::uint32_t seed = 0;       // seed of its random numbers, for stochastic techniques
    float threshold = 0.5f;       // in [0, 1]; with `hashed` it is opaque if its opacity reaches this
    friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// How view depth is mapped to depth: logarithmically for the eye (paper, Section 3.3), linearly for the
/// light (paper, Section 6). Without a warp, view depth and depth are the same number.
struct DepthWarp {
    enum class Kind { none, logarithmic, linear } kind = Kind::none;
    float z_min = -1;  // maps to -1, and z_max to 1; 0 < z_min < z_max, except if kind is none
    float z_max = 1;
    bool has_view_depths() const { return kind != Kind::none; }
    friend bool operator==(const DepthWarp&, const DepthWarp&) = default;
};

/// One low-resolution pixel from which a pixel of the picture reads moments: its fragments, and its weight in
/// the mixture.
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

/// The warp in the form that shaders use, DepthWarpFactors of shaders/shared/fragment.glsl: origin, scale and
/// linear (0 or 1). The kind must not be none.
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

/// Indices of the fragments from front to back. They are compared by depth, then by view depth. If both are
/// equal, the fragment that was submitted later lies in front, as in sorted.frag.
std::vector<std::size_t> front_to_back(const ViewRay& ray);

}  // namespace momentscope
