// tone_map.hpp -- the curve between linear colours and those of a screen.
#pragma once
#include "core/parameter_choices.hpp"

namespace momentscope {

/// A channel >= 0 as shaders/shared/tone_map.glsl maps it; still linear, and not cut at 1.
float tone_mapped(float linear, ToneMap curve);

}  // namespace momentscope
