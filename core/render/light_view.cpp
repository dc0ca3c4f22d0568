#include "core/render/light_view.hpp"

namespace momentscope {

std::optional<LightView> view_from_light(Renderer& renderer, glm::ivec2 pixel, const PixelCapture& eye,
                                         std::optional<std::size_t> fragment) {
    const auto& fragments = eye.ray.fragments;
    const auto surface = renderer.lit_surface(pixel);
    LightView view;
    if (fragment && *fragment < fragments.size())
        view.fragment = fragment;
    else if (!surface && !fragments.empty())
        view.fragment = front_to_back(eye.ray).front();
    else if (!surface)
        return std::nullopt;
    const ShadowSettings& settings = renderer.shadow_maps()->settings();
    view.bundle = renderer.capture_light(
        pixel, view.fragment ? fragments[*view.fragment].view_depth : surface->view_depth);
    view.ray = mixed_ray(view.bundle);
    view.configuration = settings.transparent;
    view.verdict = light_verdict(view.bundle, settings.transparent, *settings.opaque);
    view.visibility = view.fragment ? static_cast<double>(renderer.fragment_lights(pixel)[*view.fragment])
                                    : static_cast<double>((1 - surface->shadowed) * surface->transmittance);
    return view;
}

}  // namespace momentscope
