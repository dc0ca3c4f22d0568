#include "core/render/view.hpp"

#include <algorithm>

namespace momentscope {

Stage first_stale_stage(const View& before, const View& after) {
    if (before.technique == nullptr || before.size != after.size || !(before.camera == after.camera))
        return Stage::opaque;
    if (before.technique != after.technique) return Stage::moments;
    Stage first = Stage::nothing;
    for (const ParameterId id : after.technique->parameters)
        if (before.parameters[id] != after.parameters[id]) first = std::min(first, parameter(id).invalidates);
    // A second set of moments, and formats that hold biased moments, are made in the first passes.
    if (after.technique->uses(ParameterId::moment_passes))
        for (const ParameterId id : {ParameterId::beta, ParameterId::alpha})
            if (before.parameters[id] != after.parameters[id]) first = std::min(first, Stage::moments);
    for (const ParameterId id : PICTURE_PARAMETERS)
        if (before.parameters[id] != after.parameters[id]) first = std::min(first, parameter(id).invalidates);
    return first;
}

ToneMap tone_map_of(const ParameterValues& values) {
    return static_cast<ToneMap>(static_cast<int>(values[ParameterId::tone_map].value_or(0.0f)));
}

}  // namespace momentscope
