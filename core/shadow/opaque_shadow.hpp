// opaque_shadow.hpp -- the registry of shadow maps for opaque casters.
#pragma once
#include <array>
#include <span>
#include <string_view>

namespace momentscope {

/// What a texel stores, or the mean of some; how many of the numbers are used is the row's.
using ShadowTexel = std::array<float, 4>;

/// One row: everything that is said about such a map anywhere.
struct OpaqueShadow {
    const char* id;
    const char* name;
    const char* math_file;  // shaders/shared/<math_file>.glsl
    int moment_count;       // MOMENT_COUNT of the math file; 0 where it has none
    int bits;               // of each stored number
    int numbers;            // of a texel
    const char* description;
    const char* source;

    /// What a texel stores for the depth of the nearest surface, in [-1, 1].
    ShadowTexel (*texel)(float depth);

    /// The share of a filter region in front of a receiver, in [0, 1]; of an unfiltered row, of one texel.
    float (*shadowed)(const ShadowTexel& texel, float depth);

    bool unfiltered;  // answers of texels are mixed, not texels
    float bias;       // alpha of its moments; 0 where it has none
    float theta;      // of the wrapping zone, in radians; 0 on the line

    int bits_per_texel() const { return bits * numbers; }
};

/// All rows, in the order in which they are listed.
std::span<const OpaqueShadow> opaque_shadows();

/// Throws Error that lists the ids.
const OpaqueShadow& require_opaque_shadow(std::string_view id);

}  // namespace momentscope
