#include "core/shadow/shadow_settings.hpp"

#include <algorithm>
#include <string_view>

#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

namespace {

std::string_view chosen(const ParameterValues& values, ParameterId id) {
    return parameter(id).choices[values.number_of_choice(id)];
}

const OpaqueShadow& opaque_row(const ParameterValues& values) {
    return opaque_shadows()[values.number_of_choice(ParameterId::opaque_shadow)];
}

}  // namespace

bool has_shadows(const ParameterValues& values) {
    return values.is_on(ParameterId::shadows);
}

Configuration light_configuration(const ParameterValues& values) {
    const std::string_view id = chosen(values, ParameterId::shadow_technique);
    Configuration result = {nullptr, values};
    result.values.set(ParameterId::beta, values[ParameterId::shadow_beta]);
    result.values.set(Solver::robust);  // maps are always read by the robust solver
    if (id.starts_with("fourier-")) {
        result.technique = &require_technique("fourier");
        result.values.set(id == "fourier-15" ? FourierCoefficients::fifteen : FourierCoefficients::seven);
    } else {
        result.technique = &require_technique(id == "deep" || id == "none" ? "sorted" : id);
    }
    return result;
}

Configuration opaque_configuration(const ParameterValues& values) {
    const OpaqueShadow& row = opaque_row(values);
    Configuration result = {&require_technique("sorted"), values};
    result.values.set(ParameterId::beta, 0.0f);
    result.values.set(Solver::robust);
    if (row.moment_count == 0) return result;
    const bool circle = row.moment_count == 2;
    result.technique = &require_technique(circle ? "trig2-32" : "power4-32");
    result.values.set(ParameterId::alpha, row.bias);
    result.values.set(ParameterId::theta, row.theta);
    return result;
}

ShadowSettings shadow_settings(const ParameterValues& values, const Light& of_scene) {
    return {.casters = chosen(values, ParameterId::shadow_technique) != "none",
            .transparent = light_configuration(values),
            .opaque = &opaque_row(values),
            .size = values.count(ParameterId::shadow_size),
            .radius = values.count(ParameterId::shadow_radius),
            .light = {values[ParameterId::light_azimuth].value_or(of_scene.azimuth),
                      values[ParameterId::light_elevation].value_or(of_scene.elevation)},
            .distance = values[ParameterId::light_distance]};
}

bool same_lookup(const ShadowSettings& a, const ShadowSettings& b) {
    const Technique& technique = *a.transparent.technique;
    if (&technique != b.transparent.technique || a.casters != b.casters || a.opaque != b.opaque ||
        a.size != b.size || a.radius != b.radius)
        return false;
    const ResolvedParameters before = resolve(a.transparent.values, technique);
    const ResolvedParameters after = resolve(b.transparent.values, technique);
    const auto same = [&](ParameterId id, float ResolvedParameters::*value) {
        return !technique.uses(id) || before.*value == after.*value;
    };
    return same(ParameterId::beta, &ResolvedParameters::beta) &&
           same(ParameterId::alpha, &ResolvedParameters::alpha) &&
           same(ParameterId::theta, &ResolvedParameters::theta) &&
           same(ParameterId::tolerance, &ResolvedParameters::tolerance) &&
           (!technique.has_pixel_states() ||
            std::ranges::all_of(technique.pixel_state_kernel().settings, [&](const PixelStateSetting& one) {
                return before.settings[one.parameter] == after.settings[one.parameter];
            }));
}

int texel_numbers(const Configuration& configuration) {
    const Technique& technique = *configuration.technique;
    if (technique.has_moments()) return 1 + technique.moment_kernel().moment_floats;
    if (technique.has_pixel_states()) return technique.pixel_states().floats(configuration.values);
    return 0;
}

}  // namespace momentscope
