#include "core/shadow/opaque_shadow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/shadow/opaque_kernel.hpp"
#include "core/support/error.hpp"

namespace momentscope {

namespace {

OpaqueShadow make_row(const OpaqueKernel& kernel, const char* file, int moment_count, int bits,
                      const char* id, const char* name, int numbers, const char* description,
                      const char* source) {
    return {id,
            name,
            file,
            moment_count,
            bits,
            numbers,
            description,
            source,
            kernel.texel,
            kernel.shadowed,
            kernel.unfiltered,
            kernel.bias,
            kernel.theta};
}

}  // namespace

std::span<const OpaqueShadow> opaque_shadows() {
    static const std::array ROWS = {
#define OPAQUE_SHADOW(id, file, count, bits, ...) \
    make_row(opaque_kernel<OpaqueShadowId::id>(), #file, count, bits, __VA_ARGS__),
#include "core/shadow/opaque_shadows.def"
#undef OPAQUE_SHADOW
    };
    return ROWS;
}

const OpaqueShadow& require_opaque_shadow(std::string_view id) {
    const auto rows = opaque_shadows();
    const auto row =
        std::ranges::find(rows, id, [](const OpaqueShadow& r) { return std::string_view(r.id); });
    if (row != rows.end()) return *row;
    std::string ids;
    for (const OpaqueShadow& r : rows) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", r.id);
    throw Error(fmt::format("There is no shadow map '{}' for opaque casters; use one of {}.", id, ids));
}

}  // namespace momentscope
