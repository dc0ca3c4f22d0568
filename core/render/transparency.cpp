#include "core/render/transparency.hpp"

#include <fmt/format.h>

#include "core/render/low_resolution_passes.hpp"
#include "core/render/moment_passes.hpp"
#include "core/render/peeling_passes.hpp"
#include "core/render/sorted_passes.hpp"
#include "core/render/state_passes.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

std::unique_ptr<Transparency> make_transparency(const Technique& technique, glm::ivec2 size, GLuint depth,
                                                const Capabilities& gl) {
    if (technique.has_moments()) return std::make_unique<MomentPasses>(technique, size, depth, gl);
    if (technique.is_truth()) {
        const bool sorts = technique.truth().way == GroundTruth::Way::sorting;
        if (sorts && gl.storage) return std::make_unique<SortedPasses>(size, depth, gl);
        return std::make_unique<PeelingPasses>(size, depth, sorts ? Ties::kept : Ties::lost, gl);
    }
    if (technique.pixel_state_kernel().accumulate_second_pass != nullptr)
        return std::make_unique<LowResolutionPasses>(technique, size, depth, gl);
    return std::make_unique<StatePasses>(technique, size, depth, gl);
}

std::string why_unavailable(const Technique& technique, const Capabilities& gl) {
    if (needs_order(technique) && gl.ordered == OrderedAccess::none) return NO_ORDERED_ACCESS;
    if (technique.has_moments() && technique.moment_kernel().bits == 16 && !gl.unorm16)
        return "This GL cannot draw to 16-bit numbers, so moments of 16 bits cannot be stored.";
    if (technique.has_pixel_states() &&
        technique.pixel_state_kernel().accumulation == Accumulation::samples && !gl.storage)
        return "The shaders of this GL cannot change images, so the nearest of several depths cannot be kept.";
    return "";
}

std::string why_unavailable(const ResolvedParameters& parameters, const Capabilities& gl) {
    if (!parameters.ordered || gl.ordered != OrderedAccess::none) return "";
    return fmt::format("{} Choose blending as the accumulation.", NO_ORDERED_ACCESS);
}

std::string why_unavailable(const Configuration& configuration, const Capabilities& gl) {
    const Technique& technique = *configuration.technique;
    const std::string why = why_unavailable(technique, gl);
    if (!why.empty() || !technique.has_moments()) return why;
    return why_unavailable(resolve(configuration.values, technique), gl);
}

}  // namespace momentscope
