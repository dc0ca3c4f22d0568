#include "app/osmesa_context.hpp"
#include "core/support/error.hpp"

namespace momentscope {

const char* const INSTEAD_OF_A_WINDOW = "start the program on a desktop with OpenGL 4.5.";

std::unique_ptr<GlContext> make_osmesa_context(glm::ivec2 /*size*/) {
    throw Error(
        "Pictures cannot be drawn without a window, because this program was built without OSMesa; build it with the "
        "CMake option MOMENTSCOPE_OSMESA=ON.");
}

}  // namespace momentscope
