// picture_module.hpp -- loads the module that reads and writes picture files.
#pragma once
#include "pictures/picture_codec.hpp"

namespace momentscope {

/// The module. It is loaded at the first call. Throws Error if it is not in the folder of the program, or
/// cannot be loaded.
const PictureCodec& picture_codec();

}  // namespace momentscope
