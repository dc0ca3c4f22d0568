// error_causes.hpp -- the names of the causes of an error, as the verdict says them and lessons ask for them.
#pragma once
#include <array>
#include <string_view>

namespace momentscope::cause {

inline constexpr const char* SAME_DEPTH = "surfaces at the same depth";
inline constexpr const char* MOMENT_COUNT = "the moment count";  // the numbers follow
inline constexpr const char* WRAPPING_ZONE = "the wrapping zone";
inline constexpr const char* OVERESTIMATION = "the overestimation weight";
inline constexpr const char* SELF_OCCLUSION = "self-occlusion";
inline constexpr const char* BIAS = "the moment bias";
inline constexpr const char* DRIFT = "16-bit drift of the moments";
inline constexpr const char* TEXTBOOK = "the textbook solver";
inline constexpr const char* ROUNDING = "rounding of floats";
inline constexpr const char* METHOD = "the method's own approximation";
inline constexpr const char* FEW_BITS = "rounding to few bits";
inline constexpr const char* LOW_RESOLUTION = "the low resolution of the moments";
inline constexpr const char* ORDER = "the order of submission";
inline constexpr const char* RENORMALISATION = "renormalisation";

inline constexpr std::array<std::string_view, 14> ALL = {
    SAME_DEPTH, MOMENT_COUNT, WRAPPING_ZONE, OVERESTIMATION, SELF_OCCLUSION, BIAS,  DRIFT,
    TEXTBOOK,   ROUNDING,     METHOD,        FEW_BITS,       LOW_RESOLUTION, ORDER, RENORMALISATION};

}  // namespace momentscope::cause
