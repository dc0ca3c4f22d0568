#include "core/image/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/image/picture_module.hpp"
#include "core/support/error.hpp"
#include "core/support/memory.hpp"
#include "core/support/reachable.hpp"

namespace momentscope {

std::string first_sentence(const std::string& text) {
    return text.substr(0, std::min({text.find('\n'), text.find(". "), text.size()}));
}

PictureFile::PictureFile(std::filesystem::path file, std::string kind, bool unassociated)
    : path(std::move(file)), what(std::move(kind)) {
    require_reachable(path);
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code))
        throw Error(
            fmt::format("The {1} '{0}' is not an ordinary file; give the path of one.", path.string(), what));
    reader.reset(picture_codec().open(path.c_str(), unassociated));
    if (!reader)
        throw Error(fmt::format("The {} '{}' cannot be read ({}); give another one.", what, path.string(),
                                reason_of(picture_codec().reason())));
}

std::string PictureFile::reason_of(const std::string& said) const {
    std::string text = first_sentence(said);
    if (text.empty()) text = first_sentence(caught.first_line());
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text.empty() ? "no reason given" : text;
}

void PictureFile::require_size(int most_side, std::size_t most_pixels, std::size_t bytes_per_pixel) const {
    const PictureHeader& size = header();
    const auto pixels = static_cast<std::size_t>(std::max(size.width, 0)) *
                        static_cast<std::size_t>(std::max(size.height, 0));
    if (pixels < 1 || std::max(size.width, size.height) > most_side || pixels > most_pixels ||
        size.depth > 1 || size.channel_count == 0)
        throw Error(fmt::format(
            "The {} '{}' has {}x{}{} pixels, but at most {} to a side and {} million in all are "
            "read; make it smaller.",
            what, path.string(), size.width, size.height,
            size.depth > 1 ? fmt::format("x{}", size.depth) : "", most_side, most_pixels / 1'000'000));
    require_memory(pixels * bytes_per_pixel,
                   fmt::format("The {} '{}' of {}x{} pixels", what, path.string(), size.width, size.height),
                   "make it smaller");
}

void PictureFile::read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels) {
    const PictureOutcome outcome = reader->read(first_channel, channel_count, numbers, pixels);
    if (outcome == PictureOutcome::no_memory)
        throw Error(fmt::format("The {} '{}' needs more memory than there is; make it smaller.", what,
                                path.string()));
    if (outcome == PictureOutcome::failed)
        throw Error(fmt::format("The {} '{}' ends before its last pixel ({}); write it again.", what,
                                path.string(), reason_of(picture_codec().reason())));
}

}  // namespace momentscope
