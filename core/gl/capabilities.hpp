// capabilities.hpp -- what the current GL can do beyond what every supported GL can. Techniques and passes
// ask for a capability, never for a version.
#pragma once
#include <cstddef>

#include "core/gl/dialect.hpp"

namespace momentscope {

/// How the fragments of a pixel can read, change and write it one after another, in submission order.
enum class OrderedAccess { none, interlock, framebuffer_fetch };

struct Capabilities {
    ShaderLanguage language;
    OrderedAccess ordered = OrderedAccess::none;  // interlock, if there are both
    bool storage = false;                         // shaders write buffers and images, with atomic operations
    bool unorm16 = false;                         // renders to 16-bit numbers in [0, 1]
    bool blending_per_target = false;             // an equation of its own for each colour target
    bool timer_queries = false;
    bool answers_at_once = false;   // queries can be read while the frame is drawn, which browsers refuse
    bool primitive_ids = false;     // fragment shaders know the number of their triangle
    int color_targets = 4;          // of one pass
    std::size_t storage_bytes = 0;  // of one buffer that shaders may write
};

/// The dialect of the current context.
Dialect current_dialect();

/// The capabilities of the current context. Draws a few texels to see what the driver does with rounding.
/// Throws Error, with what to do, if the context cannot draw pictures at all.
Capabilities capabilities();

}  // namespace momentscope
