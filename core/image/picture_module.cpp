#include "core/image/picture_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "core/support/error.hpp"

namespace momentscope {

namespace {

const PictureCodec& load_codec() {
    std::error_code code;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", code);
    const std::filesystem::path module = program.parent_path() / "momentscope_pictures.so";
    void* const handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);  // loaded until the process ends
    void* const function = handle != nullptr ? ::dlsym(handle, PICTURE_CODEC_NAME) : nullptr;
    if (function == nullptr)
        throw Error(fmt::format(
            "Pictures cannot be read or written, because a part of the program cannot be loaded ({}); "
            "build it again.",
            ::dlerror()));
    return *reinterpret_cast<PictureCodecFunction>(function)();
}

}  // namespace

const PictureCodec& picture_codec() {
    static const PictureCodec& codec = load_codec();
    return codec;
}

}  // namespace momentscope
