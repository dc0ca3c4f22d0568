// opaque_shadow.hpp -- the registry of shadow maps for opaque casters.
#pragma once
#include <array>
#include <span>
#include <string_view>

namespace momentscope {

/// The numbers that a texel stores, or their mean over several texels. The row says how many are used.
using ShadowTexel = std::array<float, 4>;

/// One row of the registry: everything that the program says about such a map.
struct OpaqueShadow {
    const char* id;
    const char* name;
    const char* math_file;  // shaders/shared/<math_file>.glsl
    int moment_count;       // MOMENT_COUNT of the math file; 0 if it has none
    int bits;               // per stored number
    int numbers;            // stored per texel
    const char* description;
    const char* source;

    /// What a texel stores for the depth of the nearest surface, in [-1, 1].
    ShadowTexel (*texel)(float depth);

    /// The share of a filter region in front of a receiver, in [0, 1]. For an unfiltered row: of one texel.
    float (*shadowed)(const ShadowTexel& texel, float depth);

    bool unfiltered;  // the results of texels are averaged, not the texels
    float bias;       // alpha of its moments; 0 if it has none
    float theta;      // of the wrapping zone, in radians; 0 on the line

    int bits_per_texel() const { return bits * numbers; }
};

/// All rows, in the order of listings.
std::span<const OpaqueShadow> opaque_shadows();

/// The row with this id. Throws Error, with a list of all ids, if there is none.
const OpaqueShadow& require_opaque_shadow(std::string_view id);

}  // namespace momentscope
