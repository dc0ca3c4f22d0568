#include "core/shadow/light_ray.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace momentscope {

namespace {

// The opacity whose absorbance is `share` times that of this opacity.
float shared_opacity(float opacity, float share) {
    const double absorbance = static_cast<double>(fragment_absorbance(opacity)) * static_cast<double>(share);
    return static_cast<float>(-std::expm1(-absorbance));
}

double absorbance_in_front(const LightTexel& texel, float depth) {
    double sum = 0;
    for (const Fragment& fragment : texel.fragments)
        if (fragment.depth < depth) sum += static_cast<double>(fragment_absorbance(fragment.opacity));
    return sum;
}

PixelStateFragment receiver_fragment(float depth) {
    PixelStateFragment fragment;
    fragment.depth = 0.5f * (depth + 1.0f);
    fragment.view_depth = 1;
    fragment.window_depth = fragment.plane_depth = fragment.depth;
    return fragment;
}

}  // namespace

ViewRay mixed_ray(const ShadowFilterSamples& bundle) {
    ViewRay ray;
    ray.warp = bundle.warp;
    ray.near_plane = bundle.near_plane;
    ray.far_plane = bundle.far_plane;
    for (const LightTexel& texel : bundle.texels)
        for (Fragment fragment : texel.fragments) {
            fragment.opacity = shared_opacity(fragment.opacity, texel.weight);
            ray.fragments.push_back(fragment);
        }
    return ray;
}

ViewRay opaque_ray(const ShadowFilterSamples& bundle) {
    ViewRay ray;
    ray.warp = bundle.warp;
    for (const OpaqueShare& share : bundle.opaque) {
        Fragment fragment;
        fragment.depth = share.depth;
        fragment.view_depth = to_view_depth(share.depth, bundle.warp);
        fragment.opacity = static_cast<float>(-std::expm1(-static_cast<double>(share.weight)));
        ray.fragments.push_back(fragment);
    }
    return ray;
}

double deep_transmittance(const ShadowFilterSamples& bundle, float depth) {
    double sum = 0;
    for (const LightTexel& texel : bundle.texels)
        sum += static_cast<double>(texel.weight) * std::exp(-absorbance_in_front(texel, depth));
    return bundle.texels.empty() ? 1 : sum;
}

double mixed_transmittance(const ShadowFilterSamples& bundle, float depth) {
    double absorbance = 0;
    for (const LightTexel& texel : bundle.texels)
        absorbance += static_cast<double>(texel.weight) * absorbance_in_front(texel, depth);
    return std::exp(-absorbance);
}

float light_transmittance(const ShadowFilterSamples& bundle, const Configuration& transparent, float depth) {
    if (bundle.texels.empty()) return 1;
    const Technique& technique = *transparent.technique;
    if (technique.is_truth()) return static_cast<float>(deep_transmittance(bundle, depth));
    assert(!bundle.sums.empty() && "the map of the bundle is of another technique");
    const ResolvedParameters parameters = resolve(transparent.values, technique);
    if (technique.has_pixel_states()) {
        PixelState state;
        std::ranges::copy(bundle.sums, state.f.begin());
        return technique.pixel_state_kernel().transmittance_at(state, receiver_fragment(depth),
                                                               parameters.settings);
    }
    MomentVector moments;
    moments.b0 = bundle.sums.front();
    std::copy(bundle.sums.begin() + 1, bundle.sums.end(), moments.b.begin());
    ReconstructionSettings settings = settings_of(parameters);
    settings.solver = Solver::robust;
    settings.estimate = Estimate::own_beta;
    FragmentEstimate estimate;
    technique.moment_kernel().estimates(moments, settings, {&depth, 1}, {&bundle.receiver_absorbance, 1},
                                        {&estimate, 1});
    return estimate.transmittance;
}

float light_shadowed(const ShadowFilterSamples& bundle, const OpaqueShadow& opaque, float depth) {
    if (bundle.texels.empty()) return 0;
    if (!opaque.unfiltered) return opaque.shadowed(bundle.texel, depth);
    double sum = 0;
    for (const OpaqueShare& share : bundle.opaque)
        sum += static_cast<double>(share.weight * opaque.shadowed(opaque.texel(share.depth), depth));
    return static_cast<float>(sum);
}

}  // namespace momentscope
