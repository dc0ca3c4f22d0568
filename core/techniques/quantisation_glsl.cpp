#include "core/techniques/quantisation_glsl.hpp"

#include <fmt/format.h>

#include <cassert>

#include "core/techniques/quantisation.hpp"

namespace momentscope {

namespace {

template <std::size_t Count>
std::string declaration(const char* name, const std::array<float, Count>& values) {
    std::string list;
    for (const float value : values) list += fmt::format("{}{:.9e}", list.empty() ? "" : ", ", value);
    return fmt::format("const float {}[{}] = float[]({});\n", name, Count, list);
}

template <int M>
std::string declarations() {
    constexpr auto TRANSFORM = quantisation_transform<M>();
    return declaration("THETA_ODD", flat_floats(TRANSFORM.odd)) +
           declaration("THETA_EVEN", flat_floats(TRANSFORM.even)) +
           declaration("THETA_ODD_INVERSE", flat_floats(inverse(TRANSFORM.odd))) +
           declaration("THETA_EVEN_INVERSE", flat_floats(inverse(TRANSFORM.even))) +
           declaration("THETA_EVEN_OFFSET", floats(TRANSFORM.even_offset));
}

}  // namespace

std::string quantisation_glsl(int moment_count) {
    assert(moment_count == 4 || moment_count == 6 || moment_count == 8);
    if (moment_count == 4) return declarations<4>();
    return moment_count == 6 ? declarations<6>() : declarations<8>();
}

}  // namespace momentscope
