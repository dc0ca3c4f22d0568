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
    for (const ParameterId id : SCENE_PARAMETERS)
        if (before.parameters[id] != after.parameters[id]) first = std::min(first, parameter(id).invalidates);
    return first;
}

}  // namespace momentscope
