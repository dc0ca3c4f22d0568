// parameter_choices.hpp -- an enum for every parameter that is chosen by name (parameter_choices.def).
#pragma once

namespace momentscope {

#define VALUE(enumerator, text) enumerator
#define CHOICE(type, parameter, ...) enum class type { __VA_ARGS__ };
#include "core/parameters/parameter_choices.def"
#undef CHOICE
#undef VALUE

}  // namespace momentscope
