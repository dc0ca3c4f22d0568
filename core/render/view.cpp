#include "core/render/view.hpp"

#include <algorithm>
#include <array>

#include "core/shadow/shadow_settings.hpp"

namespace momentscope {

bool light_changed(const View& before, const View& after) {
    if (!has_shadows(after.parameters)) return has_shadows(before.parameters);
    constexpr std::array OF_PLACE = {ParameterId::light_azimuth, ParameterId::light_elevation,
                                     ParameterId::light_distance};  // `auto` means the place in the scene
    const auto differs = [&](ParameterId id) { return before.parameters[id] != after.parameters[id]; };
    return differs(ParameterId::shadows) || std::ranges::any_of(OF_PLACE, differs) ||
           !same_lookup(shadow_settings(before.parameters, {}), shadow_settings(after.parameters, {}));
}

namespace {

Stage first_stale_of_technique(const View& before, const View& after) {
    if (before.technique != after.technique) return Stage::moments;
    Stage first = Stage::nothing;
    for (const ParameterId id : after.technique->parameters)
        if (before.parameters[id] != after.parameters[id]) first = std::min(first, parameter(id).invalidates);
    // A second set of moments, and formats that hold biased moments, are made in the first pass.
    if (after.technique->uses(ParameterId::moment_passes))
        for (const ParameterId id : {ParameterId::beta, ParameterId::alpha})
            if (before.parameters[id] != after.parameters[id]) first = std::min(first, Stage::moments);
    // What is uncertain about weights is summed in the second pass.
    const auto before_uncertain = before.parameters.get<Renormalization>() == Renormalization::uncertain;
    const auto after_uncertain = after.parameters.get<Renormalization>() == Renormalization::uncertain;
    if (after.technique->uses(ParameterId::renormalize) && before_uncertain != after_uncertain)
        first = std::min(first, Stage::color);
    for (const ParameterId id : PICTURE_PARAMETERS)
        if (before.parameters[id] != after.parameters[id]) first = std::min(first, parameter(id).invalidates);
    return first;
}

}  // namespace

// A change of light alters only colours. If the first pass stores colours, it must run again, too.
Stage first_stale_stage(const View& before, const View& after) {
    if (before.technique == nullptr || before.size != after.size || !(before.camera == after.camera))
        return Stage::opaque;
    const Stage first = first_stale_of_technique(before, after);
    if (!light_changed(before, after)) return first;
    const bool colors_first =
        after.technique->has_pixel_states() && after.technique->pixel_state_kernel().holds_colors;
    return first <= Stage::moments || colors_first ? Stage::opaque : Stage::shading;
}

ToneMap tone_map_of(const ParameterValues& values) {
    return values.get<ToneMap>();
}

}  // namespace momentscope
