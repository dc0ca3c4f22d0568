#include "core/image/tone_map.hpp"

#include "core/support/glsl.hpp"

namespace momentscope {

namespace glsl::tone {
#include "shaders/shared/tone_map.glsl"
}  // namespace glsl::tone

float tone_mapped(float linear, ToneMap curve) {
    return glsl::tone::tone_mapped(linear, static_cast<int>(curve));
}

}  // namespace momentscope
