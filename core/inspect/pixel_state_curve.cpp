#include "core/inspect/pixel_state_curve.hpp"

#include <algorithm>
#include <cassert>

#include "core/scene/camera.hpp"
#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl::pixel_state_curve {
#define MAX_STATE_FLOATS 4
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "shaders/shared/portable_math.glsl"
// pixel_state.glsl needs portable_math.glsl before it.
#include "shaders/shared/pixel_state.glsl"
#pragma GCC diagnostic pop
#undef MAX_STATE_FLOATS
}  // namespace glsl::pixel_state_curve

PixelStateFragment pixel_state_fragment(const ViewRay& ray, const Fragment& fragment) {
    PixelStateFragment result;
    const bool known = ray.near_plane > 0 && ray.far_plane > ray.near_plane;
    const float near = known ? ray.near_plane : NEAR_PLANE;
    const float far = known ? ray.far_plane : FAR_PLANE;
    result.depth = 0.5f * (fragment.depth + 1.0f);
    result.view_depth = ray.warp.has_view_depths() ? fragment.view_depth : 2.0f + fragment.depth;
    result.window_depth = glsl::pixel_state_curve::window_depth_of(result.view_depth, near, far);
    result.plane_depth = glsl::pixel_state_curve::plane_depth_of(result.view_depth, near, far);
    result.opacity = fragment.opacity;
    result.red = fragment.color.r;
    result.green = fragment.color.g;
    result.blue = fragment.color.b;
    result.seed = fragment.seed;
    result.threshold = fragment.threshold;
    return result;
}

namespace {

// The state that the passes store for the fragments of one pixel, as later passes read it.
PixelState state_of(const std::vector<Fragment>& fragments, const ViewRay& ray,
                    const PixelStateKernel& kernel, const ParameterValues& settings) {
    PixelState state = kernel.empty_state(settings);
    for (const Fragment& fragment : fragments)
        state = kernel.with_fragment(state, pixel_state_fragment(ray, fragment), settings);
    const PixelState read = kernel.readable(state, settings);
    if (kernel.accumulate_second_pass == nullptr) return read;
    for (const Fragment& fragment : fragments)
        state = kernel.accumulate_second_pass(state, read, pixel_state_fragment(ray, fragment), settings);
    return kernel.readable(state, settings);
}

}  // namespace

PixelState pixel_state(const ViewRay& ray, const Technique& technique, const ParameterValues& settings) {
    const PixelStateKernel& kernel = technique.pixel_state_kernel();
    PixelState state;
    if (resolution_divisor(technique, settings) == 1 || ray.low_resolution_sources.empty()) {
        state = state_of(ray.fragments, ray, kernel, settings);
    } else {
        for (const LowResolutionSource& share : ray.low_resolution_sources) {
            const PixelState part = state_of(share.fragments, ray, kernel, settings);
            for (std::size_t i = 0; i < part.f.size(); ++i) state.f[i] += share.weight * part.f[i];
        }
    }
    if (kernel.exact_absorbance_slot >= 0) {
        float& own = state.f[static_cast<std::size_t>(kernel.exact_absorbance_slot)];
        own = 0;
        for (const Fragment& fragment : ray.fragments) own += fragment_absorbance(fragment.opacity);
    }
    return state;
}

std::vector<float> pixel_state_transmittance(const ViewRay& ray, const Technique& technique,
                                             const ParameterValues& settings, std::span<const float> depths) {
    assert(technique.pixel_state_kernel().has_depths());
    const PixelState state = pixel_state(ray, technique, settings);
    Fragment mean;
    for (const Fragment& fragment : ray.fragments)
        mean.opacity += fragment.opacity / static_cast<float>(ray.fragments.size());
    mean.threshold = 0;  // hashed alpha testing draws it
    std::vector<float> t;
    t.reserve(depths.size());
    for (const float depth : depths) {
        mean.depth = depth;
        mean.view_depth = ray.warp.has_view_depths() ? to_view_depth(depth, ray.warp) : depth;
        t.push_back(ray.fragments.empty() ? 1.0f
                                          : technique.pixel_state_kernel().transmittance_at(
                                                state, pixel_state_fragment(ray, mean), settings));
    }
    return t;
}

std::vector<float> own_transmittance(const ViewRay& ray, const Technique& technique,
                                     const ParameterValues& settings) {
    const PixelStateKernel& kernel = technique.pixel_state_kernel();
    std::vector<float> t(ray.fragments.size());
    if (kernel.has_depths()) {
        const PixelState state = pixel_state(ray, technique, settings);
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = kernel.transmittance_at(state, pixel_state_fragment(ray, ray.fragments[i]), settings);
        return t;
    }
    assert(kernel.accumulation == Accumulation::over);
    PixelState drawn_later = kernel.empty_state(settings);
    for (std::size_t i = t.size(); i-- > 0;) {
        t[i] = kernel.composited(drawn_later, settings).transmittance;
        drawn_later =
            kernel.with_fragment(drawn_later, pixel_state_fragment(ray, ray.fragments[i]), settings);
    }
    return t;
}

glm::vec3 pixel_state_color(const ViewRay& ray, const Technique& technique,
                            const ResolvedParameters& parameters, const glm::vec3& background) {
    const PixelStateKernel& kernel = technique.pixel_state_kernel();
    const PixelState state = pixel_state(ray, technique, parameters.settings);
    const Composited all = kernel.composited(state, parameters.settings);
    glm::vec3 color(all.red, all.green, all.blue);
    if (!kernel.holds_colors) {
        glm::vec4 weighted(0);
        for (const Fragment& fragment : ray.fragments)
            weighted +=
                glm::vec4(fragment.color, 1) * fragment.opacity *
                kernel.transmittance_at(state, pixel_state_fragment(ray, fragment), parameters.settings);
        const bool scaled = parameters.renormalizes() && weighted.a > 0;
        color = glm::vec3(weighted) * (scaled ? (1 - all.transmittance) / weighted.a : 1.0f);
    }
    return color + background * all.transmittance;
}

}  // namespace momentscope
