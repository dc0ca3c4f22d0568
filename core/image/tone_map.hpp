// tone_map.hpp -- the tone map from linear colours to those of a screen.
#pragma once
#include "core/parameters/parameter_choices.hpp"

namespace momentscope {

/// Maps a channel >= 0 as shaders/shared/tone_map.glsl does. The result is still linear, and not clamped to
/// 1.
float tone_mapped(float linear, ToneMap curve);

}  // namespace momentscope
