#include "core/techniques/technique.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"
#include "core/techniques/pixel_state_techniques.hpp"

namespace momentscope {

namespace {

// What a moment-based technique reads: the wrapping zone is a notion of bases on the circle alone, only
// published algorithms have a textbook, and what is stored in 16 bits cannot be blended.
std::vector<ParameterId> moment_parameters(const MomentKernel& kernel, std::string_view basis) {
    std::vector<ParameterId> ids = {ParameterId::beta};
    if (basis == "trigonometric") ids.push_back(ParameterId::theta);
    if (basis == "nested") ids.push_back(ParameterId::tolerance);
    ids.insert(ids.end(), {ParameterId::alpha, ParameterId::preset});
    if (kernel.has_textbook) ids.push_back(ParameterId::solver);
    // A stored factor takes more bits than storing moments in 16 bits saves.
    if (kernel.bits == 32) ids.push_back(ParameterId::factorisation);
    if (kernel.bits == 32) ids.push_back(ParameterId::accumulation);
    ids.push_back(ParameterId::renormalize);
    return ids;
}

Technique moment_technique(const MomentKernel& kernel, const char* basis, int moment_count, const char* id,
                           const char* name, float recommended_bias, float robust_bias, bool has_bounds,
                           const char* description, const char* source) {
    return {.id = id,
            .name = name,
            .description = description,
            .source = source,
            .path = RenderPath::moments,
            .kernel = &kernel,
            .basis = basis,
            .moment_count = moment_count,
            .parameters = moment_parameters(kernel, basis),
            .recommended_bias = recommended_bias,
            .robust_bias = robust_bias,
            .has_bounds = has_bounds,
            .geometry_passes = 2,
            .order_dependent = kernel.bits == 16};
}

/// Sets of five numbers: what is added up in floats, and what is read where it is converted.
int moment_transparency_bits(const PixelStateSettings& settings) {
    constexpr int READ_BITS[] = {0, 80, 96, 64};  // with b_0, a half float or a float
    const int sets = settings.size / 8;
    const int pixels = settings.divisor * settings.divisor;  // that share one
    return (sets * (160 + READ_BITS[settings.option % 4]) + pixels - 1) / pixels;
}

Technique pixel_state_technique(const PixelStateKernel& kernel, const char* file, const char* id,
                                const char* name, std::vector<ParameterId> parameters,
                                PixelStateSettings (*settings)(const ParameterValues&),
                                int (*state_floats)(const PixelStateSettings&),
                                int (*bits)(const PixelStateSettings&), const char* description,
                                const char* source) {
    return {.id = id,
            .name = name,
            .description = description,
            .source = source,
            .path = RenderPath::states,
            .math_file = file,
            .pixel_state = &kernel,
            .pixel_state_settings = settings,
            .state_floats = state_floats,
            .state_bits = bits,
            .parameters = std::move(parameters),
            .geometry_passes = kernel.holds_colors ? 1 : 2,
            .order_dependent =
                kernel.accumulation == Accumulation::over || kernel.accumulation == Accumulation::ordered};
}

std::vector<Technique> make_rows() {
    std::vector<Technique> rows = {
#define MOMENT_TECHNIQUE(id, basis, count, bits, ...) \
    moment_technique(moment_kernel(MomentKernelTag<MomentTechnique::id>()), #basis, count, __VA_ARGS__),
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    };
#define PARAMETERS(...) {__VA_ARGS__}
#define PIXEL_STATE_TECHNIQUE(id, file, key, name, parameters, settings, floats, bits, description, source) \
    rows.push_back(pixel_state_technique(                                                                   \
        pixel_state_kernel(PixelStateKernelTag<PixelStateTechnique::id>()), #file, key, name, parameters,   \
        []([[maybe_unused]] const ParameterValues& values) { return PixelStateSettings(settings); },        \
        []([[maybe_unused]] const PixelStateSettings& s) { return floats; },                                \
        []([[maybe_unused]] const PixelStateSettings& s) { return bits; }, description, source));
#include "core/techniques/pixel_state_techniques.def"
#undef PIXEL_STATE_TECHNIQUE
#undef PARAMETERS
    rows.push_back(
        {.id = "sorted",
         .name = "sorted fragments",
         .description =
             "The ground truth: every fragment of every pixel is captured, sorted by depth and "
             "composited front to back. Of fragments at the same depth the one that was submitted last lies on top.",
         .source = "Carpenter 1984; Yang et al. 2010",
         .path = RenderPath::sorted});
    rows.push_back(
        {.id = "peeling",
         .name = "depth peeling",
         .description =
             "A second ground truth that shares nothing with the first: the depth test peels one layer after "
             "another, and blending puts them together from front to back. One geometry pass per layer; of "
             "fragments at the same depth only one survives.",
         .source = "Everitt 2001",
         .path = RenderPath::peeling,
         .truth_bits = 64,  // two depth buffers
         .geometry_passes = 0});
    return rows;
}

}  // namespace

bool Technique::uses(ParameterId parameter_id) const {
    return std::ranges::find(parameters, parameter_id) != parameters.end();
}

std::span<const Technique> techniques() {
    static const std::vector<Technique> rows = make_rows();
    return rows;
}

std::vector<const Technique*> moment_based_techniques() {
    std::vector<const Technique*> rows;
    for (const Technique& row : techniques())
        if (row.kernel != nullptr) rows.push_back(&row);
    return rows;
}

const Technique* find_technique(std::string_view id) {
    const auto rows = techniques();
    const auto row = std::ranges::find(rows, id, [](const Technique& t) { return std::string_view(t.id); });
    return row == rows.end() ? nullptr : &*row;
}

const Technique& require_technique(std::string_view id) {
    if (const Technique* row = find_technique(id)) return *row;
    std::string ids;
    for (const Technique& row : techniques()) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", row.id);
    throw Error(fmt::format("There is no technique '{}'; use one of {}.", id, ids));
}

float automatic_bias(const ParameterValues& values, const Technique& technique) {
    if (technique.pixel_state != nullptr) {
        ParameterValues automatic = values;
        automatic.set(ParameterId::alpha, std::nullopt);
        return technique.pixel_state_settings(automatic).bias;
    }
    return values[ParameterId::preset].value_or(0.0f) >= 0.5f ? technique.robust_bias
                                                              : technique.recommended_bias;
}

ResolvedParameters resolve(const ParameterValues& values, const Technique& technique) {
    const auto on = [&](ParameterId id) { return technique.uses(id) && values[id].value_or(0.0f) >= 0.5f; };
    return {.beta = values[ParameterId::beta].value_or(0.0f),
            .theta = std::max(values[ParameterId::theta].value_or(0.0f), MIN_WRAPPING_ZONE),
            .alpha = values[ParameterId::alpha].value_or(automatic_bias(values, technique)),
            .textbook = on(ParameterId::solver),
            .factored_once = technique.uses(ParameterId::factorisation) && !on(ParameterId::factorisation) &&
                             !on(ParameterId::solver),
            .tolerance = technique.uses(ParameterId::tolerance) ? *values[ParameterId::tolerance] : 0.0f,
            .ordered = on(ParameterId::accumulation) || needs_order(technique),
            .renormalize = values[ParameterId::renormalize].value_or(1.0f) >= 0.5f,
            .pixel_state = technique.pixel_state != nullptr ? technique.pixel_state_settings(values)
                                                            : PixelStateSettings()};
}

int stored_bits(const Technique& technique, const ParameterValues& values) {
    if (technique.pixel_state != nullptr) return technique.state_bits(technique.pixel_state_settings(values));
    if (technique.kernel != nullptr) return technique.kernel->bits * (1 + technique.kernel->moment_floats);
    return technique.truth_bits;
}

int bits_with_factor(const Technique& technique, const ParameterValues& values) {
    const int stored = stored_bits(technique, values);
    if (technique.kernel == nullptr || !resolve(values, technique).factored_once) return stored;
    // The factor may take the place of the moments, whenever alpha rests; only the window keeps both.
    return std::max(stored, technique.kernel->bits * (1 + technique.kernel->factor_floats));
}

std::string bits_text(const Technique& technique, int bits) {
    if (bits > 0) return fmt::format("{}", bits);
    return technique.is_truth() ? "grows with the fragments" : "none";
}

const char* why_refused(const Technique& technique, const ParameterValues& values) {
    const bool low = technique.uses(ParameterId::resolution) && values[ParameterId::resolution] != 0.0f;
    if (low && values[ParameterId::read_format].value_or(0.0f) >= 2.0f)
        return "Non-linearly quantised moments cannot be filtered: read them at full resolution, or choose the read "
               "format float or theta16.";
    return nullptr;
}

bool needs_order(const Technique& technique) {
    return (technique.kernel != nullptr && technique.kernel->bits == 16) ||
           (technique.pixel_state != nullptr && technique.pixel_state->accumulation == Accumulation::ordered);
}

bool has_function(const Technique& technique) {
    return technique.kernel != nullptr ||
           (technique.pixel_state != nullptr && technique.pixel_state->has_depths());
}

float basis_parameter(const ResolvedParameters& parameters, const Technique& technique) {
    return technique.uses(ParameterId::tolerance) ? parameters.tolerance : parameters.theta;
}

ReconstructionSettings settings_of(const ResolvedParameters& parameters) {
    return {.overestimation = parameters.beta,
            .wrapping_zone_angle = parameters.theta,
            .tolerance = parameters.tolerance,
            .bias = parameters.alpha,
            .solver = parameters.textbook ? Solver::textbook : Solver::robust};
}

}  // namespace momentscope
