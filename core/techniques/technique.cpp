#include "core/techniques/technique.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/techniques/moment_kernel.hpp"
#include "core/techniques/moment_techniques.hpp"

namespace momentscope {

namespace {

constexpr std::array POWER_PARAMETERS = {ParameterId::beta, ParameterId::alpha, ParameterId::renormalize};
constexpr std::array TRIGONOMETRIC_PARAMETERS = {ParameterId::beta, ParameterId::theta, ParameterId::alpha,
                                                 ParameterId::renormalize};

// The wrapping zone is a notion of bases on the circle alone.
std::span<const ParameterId> moment_parameters(std::string_view basis) {
    if (basis == "trigonometric") return TRIGONOMETRIC_PARAMETERS;
    return POWER_PARAMETERS;
}

Technique moment_technique(const MomentKernel& kernel, const char* basis, int moment_count, const char* id,
                           const char* name, float recommended_bias, bool has_bounds, const char* description,
                           const char* source) {
    return {.id = id,
            .name = name,
            .description = description,
            .source = source,
            .path = RenderPath::moments,
            .kernel = &kernel,
            .basis = basis,
            .moment_count = moment_count,
            .parameters = moment_parameters(basis),
            .recommended_bias = recommended_bias,
            .has_bounds = has_bounds,
            .bits_per_pixel = 32 * (1 + kernel.moment_floats),
            .geometry_passes = 2,
            .order_dependent = false};
}

std::vector<Technique> make_rows() {
    std::vector<Technique> rows = {
#define MOMENT_TECHNIQUE(id, basis, count, ...) \
    moment_technique(moment_kernel(MomentKernelTag<MomentTechnique::id>()), #basis, count, __VA_ARGS__),
#include "core/techniques/moment_techniques.def"
#undef MOMENT_TECHNIQUE
    };
    rows.push_back({.id = "sorted",
                    .name = "sorted fragments",
                    .description =
                        "The ground truth: every fragment of every pixel is captured, sorted by depth and "
                        "composited front to back. Fragments at the same depth keep their submission order.",
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
         .bits_per_pixel = 64,  // two depth buffers
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

ResolvedParameters resolve(const ParameterValues& values, const Technique& technique) {
    return {.beta = values[ParameterId::beta].value_or(0.0f),
            .theta = values[ParameterId::theta].value_or(0.0f),
            .alpha = values[ParameterId::alpha].value_or(technique.recommended_bias),
            .renormalize = values[ParameterId::renormalize].value_or(1.0f) >= 0.5f};
}

}  // namespace momentscope
