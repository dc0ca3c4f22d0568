// basis.hpp -- the registry of bases. A basis is a set of functions of depth; a moment is the sum of
// absorbance times such a function.
#pragma once
namespace momentscope {

enum class BasisId {
#define BASIS(id, ...) id,
#include "core/techniques/bases.def"
#undef BASIS
};

enum class BasisFamily { power, chebyshev, trigonometric };
enum class BasisDomain { line, circle };

/// One row of bases.def, which explains the columns.
struct Basis {
    BasisId id;
    const char* key;  // shaders/shared/<key>_moments.glsl
    BasisFamily family;
    BasisDomain domain;
    float length;        // of the depth range in the variable of the polynomials: 2 if that is depth itself
    bool chooses_order;  // each fragment uses as few moments as the parameter `tolerance` allows

    bool on_circle() const { return domain == BasisDomain::circle; }
    bool has_bounds() const { return domain == BasisDomain::line; }
    bool has_wrapping_zone() const { return on_circle(); }

    /// The change of depth when the variable of the polynomials changes by 1. Not meaningful on the circle.
    float depth_per_unit() const { return 2 / length; }
};

const Basis& basis(BasisId id);

/// "power", "Chebyshev" or "trigonometric".
const char* family_name(BasisFamily family);

}  // namespace momentscope
