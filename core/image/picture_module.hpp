// picture_module.hpp -- loads what reads and writes picture files.
#pragma once
#include "pictures/picture_codec.hpp"

namespace momentscope {

/// Loaded at the first call. Throws Error when the module is not beside the program, or cannot be loaded.
const PictureCodec& picture_codec();

}  // namespace momentscope
