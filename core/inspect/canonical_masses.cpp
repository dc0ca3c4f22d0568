#include "core/inspect/canonical_masses.hpp"

#include "core/inspect/canonical_masses.inl"

namespace momentscope {

template class CanonicalMassesOf<reference::Extended>;

}  // namespace momentscope
