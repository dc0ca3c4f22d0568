// ray_presets.hpp -- view rays to start an experiment from.
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

/// All presets; ids are unique.
std::span<const RayPreset> ray_presets();

}  // namespace momentscope
