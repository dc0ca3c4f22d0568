// view_ray.hpp -- the fragments along one view ray, and the true functions of depth that they make.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

namespace momentscope {

/// One transparent fragment of a pixel.
struct Fragment {
    float depth = 0;       // warped, [-1, 1]
    float view_depth = 0;  // distance from the camera plane in scene units, > 0; equals depth without a warp
    float opacity = 0;     // alpha_l in [0, 1]
    glm::vec3 color{0};    // linear RGB, shaded, >= 0
    std::uint32_t draw = 0;       // index of the draw call, in the order of submission
    std::uint32_t primitive = 0;  // index of the triangle within it
    std::uint32_t seed = 0;       // of its random numbers, for techniques that draw some
    float threshold = 0.5f;       // of hashed alpha testing, [0, 1]
    friend bool operator==(const Fragment&, const Fragment&) = default;
};

/// How view depth became depth: logarithmically for the eye (Section 3.3), linearly for the light (Section
/// 6). Without a warp they are the same.
struct DepthWarp {
    enum class Kind { none, logarithmic, linear } kind = Kind::none;
    float z_min = -1;  // view depths that map to -1 and 1; 0 < z_min < z_max unless none
    float z_max = 1;
    bool has_view_depths() const { return kind != Kind::none; }
    friend bool operator==(const DepthWarp&, const DepthWarp&) = default;
};

/// The fragments that moments at low resolution hold for a pixel that reads them, with its share.
struct LowResolutionSource {
    float weight = 1;  // [0, 1]; those of a pixel sum to 1
    std::vector<Fragment> fragments;
    friend bool operator==(const LowResolutionSource&, const LowResolutionSource&) = default;
};

/// All fragments of a ray in submission order, which is the order in which moments are summed.
struct ViewRay {
    std::vector<Fragment> fragments;
    DepthWarp warp;
    float near_plane = 0;  // of the camera, 0 when unknown
    float far_plane = 0;
    std::vector<LowResolutionSource> low_resolution_sources =
        {};  // what the pixel's moments are mixed of; empty: its own fragments
    friend bool operator==(const ViewRay&, const ViewRay&) = default;
};

/// The seed of an object's fragment in a pixel, x + 65536 y counted from the lower left, with the bits of its
/// view depth (shaders/shared/random_bits.glsl).
std::uint32_t fragment_seed(std::uint32_t pixel, std::uint32_t object, std::uint32_t depth_bits);

/// The i-th random number in [0, 1) of a seed.
float unit_random(std::uint32_t seed, int i);

/// Absorbance -ln(1 - alpha_l) as the shaders compute it, in [0, 10].
float fragment_absorbance(float opacity);

/// exp(-absorbance) as the shaders compute it.
float transmittance(float absorbance);

/// Depth in [-1, 1] of a view depth as the shaders compute it, and its inverse.
float to_depth(float view_depth, const DepthWarp& warp);
float to_view_depth(float depth, const DepthWarp& warp);

/// origin, scale and whether it is linear (0 or 1), of shaders/shared/fragment.glsl; kind is not none.
glm::vec3 depth_warp_factors(const DepthWarp& warp);

/// Sum of all absorbances: b0.
double total_absorbance(const ViewRay& ray);

/// The depth of each fragment, in submission order.
std::vector<float> own_depths(const ViewRay& ray);

/// "1 fragment", "5 fragments".
std::string fragment_count_text(std::size_t count);

/// A(z), the sum of the absorbances of all fragments with z_l < z, at each depth; `depths` in any order.
std::vector<double> true_absorbance(const ViewRay& ray, std::span<const float> depths);

/// Indices of the fragments from front to back. Of a tie, what was submitted later lies in front, as in
/// sorted.frag.
std::vector<std::size_t> front_to_back(const ViewRay& ray);

}  // namespace momentscope
