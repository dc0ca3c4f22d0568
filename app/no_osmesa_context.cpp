#include "app/osmesa_context.hpp"
#include "core/support/error.hpp"

namespace momentscope {

const bool HAS_OSMESA = false;

std::unique_ptr<GlContext> make_osmesa_context(glm::ivec2 /*size*/) {
    throw Error(
        "This program was built without OSMesa; build it with the CMake option MOMENTSCOPE_OSMESA=ON.");
}

}  // namespace momentscope
