#include "core/techniques/basis.hpp"

#include <cstddef>

namespace momentscope {

namespace {

constexpr Basis BASES[] = {
#define BASIS(id, family, domain, length, chooses_order) \
    {BasisId::id, #id, BasisFamily::family, BasisDomain::domain, length, chooses_order},
#include "core/techniques/bases.def"
#undef BASIS
};

}  // namespace

const Basis& basis(BasisId id) {
    return BASES[static_cast<std::size_t>(id)];
}

const char* family_name(BasisFamily family) {
    switch (family) {
        case BasisFamily::power:
            return "power";
        case BasisFamily::chebyshev:
            return "Chebyshev";
        case BasisFamily::trigonometric:
            break;
    }
    return "trigonometric";
}

}  // namespace momentscope
