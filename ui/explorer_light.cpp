// explorer_light.cpp -- the plot seen from the light.
#include "core/shadow/shadow_settings.hpp"
#include "ui/explorer.hpp"

namespace momentscope::ui {

// Replaces the ray of the capture by the light's ray.
void Explorer::see_from_light(glm::ivec2 pixel) {
    measurement_.light = view_from_light(renderer_, pixel, measurement_.capture, state_.receiver);
    if (!measurement_.light) {
        message_ =
            "This pixel shows nothing that could receive light, so the plot shows the eye's ray; pick another one.";
        set_viewpoint(state_, Viewpoint::eye);
        return;
    }
    measurement_.capture.ray = ray_of(*measurement_.light, state_.viewpoint);
    measurement_.capture.transmittance.clear();
}

// Goes back to the eye if shadows were turned off.
void Explorer::leave_light_without_shadows() {
    if (state_.viewpoint != Viewpoint::eye && !has_shadows(state_.parameters))
        set_viewpoint(state_, Viewpoint::eye);
}

}  // namespace momentscope::ui
