#include "core/render/transparency.hpp"

#include "core/render/low_resolution_passes.hpp"
#include "core/render/moment_passes.hpp"
#include "core/render/peeling_passes.hpp"
#include "core/render/sorted_passes.hpp"
#include "core/render/state_passes.hpp"
#include "core/techniques/moment_kernel.hpp"

namespace momentscope {

std::unique_ptr<Transparency> make_transparency(const Technique& technique, glm::ivec2 size, GLuint depth,
                                                OrderedAccess access) {
    if (technique.has_moments()) return std::make_unique<MomentPasses>(technique, size, depth, access);
    if (technique.is_truth()) {
        if (technique.truth().way == GroundTruth::Way::sorting)
            return std::make_unique<SortedPasses>(size, depth);
        return std::make_unique<PeelingPasses>(size, depth);
    }
    if (technique.pixel_state_kernel().accumulate_second_pass != nullptr)
        return std::make_unique<LowResolutionPasses>(technique, size, depth, access);
    return std::make_unique<StatePasses>(technique, size, depth, access);
}

std::string why_unavailable(const Technique& technique, OrderedAccess access) {
    return needs_order(technique) && access == OrderedAccess::none ? NO_ORDERED_ACCESS : "";
}

}  // namespace momentscope
