#include "core/techniques/technique.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/support/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"
#include "core/techniques/pixel_state_techniques.hpp"

namespace momentscope {

namespace {

// Only the circle has a wrapping zone, only published algorithms have a textbook solver, and moments in 16
// bits cannot be blended. A technique with an estimation of its own reads no parameter of it.
std::vector<ParameterId> moment_parameters(const MomentKernel& kernel, const Basis& basis,
                                           const std::optional<Estimation>& own) {
    std::vector<ParameterId> ids;
    if (!own) ids.push_back(ParameterId::beta);
    if (basis.has_wrapping_zone()) ids.push_back(ParameterId::theta);
    if (basis.chooses_order) ids.push_back(ParameterId::tolerance);
    ids.insert(ids.end(), {ParameterId::alpha, ParameterId::preset});
    if (kernel.has_textbook && !own) ids.push_back(ParameterId::solver);
    // Moments in 16 bits have no stored factor: it would take more bits than 16-bit storage saves.
    if (kernel.bits == 32) ids.push_back(ParameterId::factorisation);
    if (kernel.bits == 32) ids.push_back(ParameterId::accumulation);
    if (!own)
        ids.insert(ids.end(), {ParameterId::estimate, ParameterId::ends, ParameterId::interval,
                               ParameterId::renormalize});
    return ids;
}

Technique moment_technique(const MomentKernel& kernel, const Basis& basis, int moment_count, const char* id,
                           const char* name, float recommended_bias, float robust_bias,
                           const char* description, const char* source,
                           const std::optional<Estimation>& own = {}) {
    return {.id = id,
            .name = name,
            .description = description,
            .source = source,
            .math = MomentMath{&kernel, &basis, moment_count, recommended_bias, robust_bias, own},
            .parameters = moment_parameters(kernel, basis, own),
            .geometry_passes = own && own->interval == MomentInterval::pixel ? 3 : 2,
            .order_dependent = kernel.bits == 16};
}

/// A technique with the moments of another row. rows: those of moment_techniques.def.
Technique interval_technique(MomentTechnique moments_of, MomentInterval interval,
                             const std::vector<Technique>& rows, const char* id, const char* name, float bias,
                             float robust_bias, const char* description, const char* source) {
    const MomentMath& math = rows[static_cast<std::size_t>(moments_of)].moments();
    return moment_technique(
        *math.kernel, *math.basis, math.moment_count, id, name, bias, robust_bias, description, source,
        Estimation{Estimate::expected, RayEnds::known, interval, Renormalization::uncertain});
}

/// Bits per pixel of the five numbers of each set: as summed in floats and, if they are converted, as read.
int moment_transparency_bits(const ParameterValues& values) {
    constexpr int READ_BITS[] = {0, 80, 96, 64};  // by ReadFormat; b_0 is a half float or a float
    const int sets = values.get<MomentSets>() == MomentSets::one ? 1 : 2;
    const int divisor = 1 << static_cast<int>(values.get<MomentResolution>());
    const int pixels = divisor * divisor;  // that share one texel
    return (sets * (160 + READ_BITS[static_cast<std::size_t>(values.get<ReadFormat>())]) + pixels - 1) /
           pixels;
}

int bits_of_layer(const ParameterValues& values) {
    const auto bits = values.get<LayerBits>();
    return bits == LayerBits::bits_16 ? 80 : bits == LayerBits::bits_8 ? 48 : 160;
}

/// others: parameters that its passes read and its math file does not.
Technique pixel_state_technique(const PixelStateMath& math, const char* id, const char* name,
                                std::vector<ParameterId> others, const char* description,
                                const char* source) {
    std::vector<ParameterId> parameters = std::move(others);
    for (const PixelStateSetting& setting : math.kernel->settings) parameters.push_back(setting.parameter);
    // In the order of the registry, but `renormalize` comes last.
    std::ranges::sort(parameters, {},
                      [](ParameterId one) { return std::pair(one == ParameterId::renormalize, one); });
    return {.id = id,
            .name = name,
            .description = description,
            .source = source,
            .math = math,
            .parameters = std::move(parameters),
            .geometry_passes = math.kernel->holds_colors ? 1 : 2,
            .order_dependent = math.kernel->accumulation == Accumulation::over ||
                               math.kernel->accumulation == Accumulation::ordered};
}

std::vector<Technique> make_rows() {
    std::vector<Technique> rows = {
#define MOMENT_TECHNIQUE(id, basis_id, count, bits, ...)                                                     \
    moment_technique(moment_kernel(MomentKernelTag<MomentTechnique::id>()), basis(BasisId::basis_id), count, \
                     __VA_ARGS__),
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    };
#define INTERVAL_TECHNIQUE(kernel, taken_in, ...) \
    rows.push_back(interval_technique(MomentTechnique::kernel, MomentInterval::taken_in, rows, __VA_ARGS__));
#include "core/techniques/interval_techniques.def"
#undef INTERVAL_TECHNIQUE
#define PARAMETERS(...) {__VA_ARGS__}
#define PIXEL_STATE_TECHNIQUE(id, file, key, name, others, floats_of, bits_of, description, source) \
    rows.push_back(pixel_state_technique(                                                           \
        {.kernel = &pixel_state_kernel(PixelStateKernelTag<PixelStateTechnique::id>()),             \
         .math_file = #file,                                                                        \
         .floats = []([[maybe_unused]] const ParameterValues& values) -> int { return floats_of; }, \
         .bits = []([[maybe_unused]] const ParameterValues& values) -> int {                        \
             [[maybe_unused]] const int floats = floats_of;                                         \
             return bits_of;                                                                        \
         }},                                                                                        \
        key, name, others, description, source));
#include "core/techniques/pixel_state_techniques.def"
#undef PIXEL_STATE_TECHNIQUE
#undef PARAMETERS
    rows.push_back(
        {.id = "sorted",
         .name = "sorted fragments",
         .description =
             "The ground truth: every fragment of every pixel is captured, sorted by depth and "
             "composited front to back. If fragments have the same depth, the one that was submitted last is in front.",
         .source = "Carpenter 1984; Yang et al. 2010",
         .math = GroundTruth{GroundTruth::Way::sorting}});
    rows.push_back(
        {.id = "peeling",
         .name = "depth peeling",
         .description =
             "A second ground truth, independent of the first: the depth test peels off one layer after "
             "another, and blending composites them from front to back. Each layer takes one geometry pass. If "
             "fragments have the same depth, only one of them survives.",
         .source = "Everitt 2001",
         .math = GroundTruth{GroundTruth::Way::peeling, 64},  // bits of two depth buffers
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
        if (row.has_moments()) rows.push_back(&row);
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

int stored_bits(const Technique& technique, const ParameterValues& values) {
    constexpr int END_BITS = 32;  // two ends of 16 bits
    if (technique.has_moments())
        return technique.moment_kernel().bits * (1 + technique.moment_kernel().moment_floats) +
               (resolve(values, technique).knows_ends() ? END_BITS : 0);
    if (technique.is_truth()) return technique.truth().bits;
    return technique.pixel_states().bits(values);
}

int bits_with_factor(const Technique& technique, const ParameterValues& values) {
    const int stored = stored_bits(technique, values);
    if (!technique.has_moments()) return stored;
    const ResolvedParameters parameters = resolve(values, technique);
    if (!parameters.factored_once) return stored;
    // The factor may replace the moments while alpha does not change; only the window keeps both.
    return std::max(stored, 32 * pixel_factor_floats(technique, parameters));
}

int pixel_factor_floats(const Technique& technique, const ResolvedParameters& parameters) {
    const MomentKernel& kernel = technique.moment_kernel();
    return 1 + kernel.factor_floats + (parameters.in_own_interval() ? kernel.inner_floats : 0) +
           (parameters.knows_ends() ? 2 : 0);
}

std::string bits_text(const Technique& technique, int bits) {
    if (bits > 0) return fmt::format("{}", bits);
    return technique.is_truth() ? "grows with the fragments" : "none";
}

bool needs_order(const Technique& technique) {
    if (technique.has_moments()) return technique.moment_kernel().bits == 16;
    return technique.has_pixel_states() &&
           technique.pixel_state_kernel().accumulation == Accumulation::ordered;
}

bool has_function(const Technique& technique) {
    return technique.has_moments() ||
           (technique.has_pixel_states() && technique.pixel_state_kernel().has_depths());
}

}  // namespace momentscope
