#include "core/render/view_from_light.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace momentscope {

namespace {

// The fragment from front to back at which the transmittance falls to one half or less.
std::optional<std::size_t> half_covering(const ViewRay& ray) {
    float transmittance = 1;
    for (const std::size_t i : front_to_back(ray)) {
        transmittance *= 1 - ray.fragments[i].opacity;
        if (transmittance <= 0.5f) return i;
    }
    return std::nullopt;
}

std::string receiver_text(const ViewRay& ray, std::optional<std::size_t> fragment) {
    if (!fragment) return "the opaque surface";
    const std::vector<std::size_t> order = front_to_back(ray);
    return fmt::format("fragment {} of {}", std::ranges::find(order, *fragment) - order.begin() + 1,
                       order.size());
}

}  // namespace

std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> receiver) {
    const auto& fragments = eye.ray.fragments;
    const auto surface = renderer.lit_surface(pixel);
    if (fragments.empty() && !surface) return std::nullopt;
    LightView view;
    if (receiver != OPAQUE_SURFACE)
        view.fragment = receiver && *receiver < fragments.size() ? receiver : half_covering(eye.ray);
    if (!view.fragment && !surface) view.fragment = front_to_back(eye.ray).back();
    view.receiver = receiver_text(eye.ray, view.fragment);
    const ShadowSettings& settings = renderer.shadow_maps()->settings();
    const float view_depth = view.fragment ? fragments[*view.fragment].view_depth : surface->view_depth;
    view.world = renderer.world_place(pixel, view_depth);
    view.bundle = renderer.capture_light(pixel, view_depth);
    if (view.fragment)
        view.bundle.receiver_absorbance = fragment_absorbance(fragments[*view.fragment].opacity);
    view.ray = mixed_ray(view.bundle);
    view.opaque = opaque_ray(view.bundle);
    view.configuration = settings.transparent;
    view.breakdown = light_breakdown(view.bundle, settings.transparent, *settings.opaque);
    view.visibility = view.fragment ? static_cast<double>(renderer.fragment_lights(pixel)[*view.fragment])
                                    : static_cast<double>((1 - surface->shadowed) * surface->transmittance);
    return view;
}

}  // namespace momentscope
