// picture_module.cpp -- the codec is a part of the program.
#include "core/image/picture_module.hpp"

extern "C" const momentscope::PictureCodec* momentscope_picture_codec();

namespace momentscope {

const PictureCodec& picture_codec() {
    return *momentscope_picture_codec();
}

}  // namespace momentscope
