#include "core/image/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/reachable.hpp"

namespace momentscope {

namespace {

constexpr int MOST_MIB = 2048;  // that a decoder may take for a picture as it is stored

}  // namespace

std::string first_sentence(const std::string& text) {
    return text.substr(0, std::min({text.find('\n'), text.find(". "), text.size()}));
}

PictureFile::PictureFile(std::filesystem::path file, std::string kind, const OIIO::ImageSpec* config)
    : path(std::move(file)), what(std::move(kind)) {
    require_reachable(path);
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code))
        throw Error(
            fmt::format("The {1} '{0}' is no ordinary file; give the path of one.", path.string(), what));
    // Some decoders take the memory while they open the file.
    OIIO::attribute("limits:imagesize_MB", MOST_MIB);
    try {
        input = OIIO::ImageInput::open(path.string(), config);
    } catch (const std::bad_alloc&) {
        OIIO::geterror();
    }
    if (!input)
        throw Error(fmt::format("'{}' is no {} that can be read ({}); give another one.", path.string(), what,
                                reason()));
}

std::string PictureFile::reason() const {
    std::string text = first_sentence(input ? input->geterror() : OIIO::geterror());
    if (text.empty()) text = first_sentence(caught.first_line());
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text.empty() ? "no reason given" : text;
}

void PictureFile::require_size(int most_side, std::size_t most_pixels, std::size_t bytes_per_pixel) const {
    const OIIO::ImageSpec& size = spec();
    const auto pixels = static_cast<std::size_t>(std::max(size.width, 0)) *
                        static_cast<std::size_t>(std::max(size.height, 0));
    if (pixels < 1 || std::max(size.width, size.height) > most_side || pixels > most_pixels ||
        size.depth > 1 || size.nchannels < 1)
        throw Error(fmt::format(
            "The {} '{}' has {}x{}{} pixels; up to {} to a side and {} million in all are "
            "read, so make it smaller.",
            what, path.string(), size.width, size.height,
            size.depth > 1 ? fmt::format("x{}", size.depth) : "", most_side, most_pixels / 1'000'000));
    require_memory(pixels * bytes_per_pixel,
                   fmt::format("The {} '{}' of {}x{} pixels", what, path.string(), size.width, size.height),
                   "make it smaller");
}

void PictureFile::read(int first_channel, int channel_count, OIIO::TypeDesc type, void* pixels) {
    try {
        if (input->read_image(0, 0, first_channel, first_channel + channel_count, type, pixels)) return;
    } catch (const std::bad_alloc&) {
        throw Error(fmt::format("The {} '{}' needs more memory than there is; make it smaller.", what,
                                path.string()));
    }
    throw Error(fmt::format("The {} '{}' ends before its pixels do ({}); write it again.", what,
                            path.string(), reason()));
}

}  // namespace momentscope
