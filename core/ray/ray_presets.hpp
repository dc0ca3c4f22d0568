// ray_presets.hpp -- ready-made view rays for experiments.
#pragma once
#include <span>

#include "core/ray/view_ray.hpp"

namespace momentscope {

struct RayPreset {
    const char* id;
    const char* name;
    const char* help;
    ViewRay (*make)();
};

/// All presets. Their ids are unique.
std::span<const RayPreset> ray_presets();

}  // namespace momentscope
