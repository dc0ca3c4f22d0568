// picture_file.hpp -- opens picture files that may be broken or hostile.
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "core/support/caught_stderr.hpp"
#include "pictures/picture_codec.hpp"

namespace momentscope {

/// The first sentence of a message of a library, as part of a sentence of ours.
std::string first_sentence(const std::string& text);

/// A picture file that has been read up to the end of its header, and the messages of the libraries.
struct PictureFile {
    CaughtStderr caught;  // libraries may print messages
    std::filesystem::path path;
    std::string what;  // "picture"
    std::unique_ptr<PictureReader> reader;

    /// Throws Error, which calls the file `kind`, unless it is an ordinary file that begins like a picture.
    /// If `unassociated`, colours are not multiplied by alpha.
    PictureFile(std::filesystem::path file, std::string kind, bool unassociated = false);

    const PictureHeader& header() const { return reader->header(); }

    /// Reads `channel_count` channels from `first_channel` on, row by row. Throws Error if the file ends too
    /// early.
    void read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels);

    /// Throws Error unless the picture is flat, has 1 to `most_side` pixels along each side and at most
    /// `most_pixels` in total, and there are `bytes_per_pixel` bytes of free memory for each pixel.
    void require_size(int most_side, std::size_t most_pixels, std::size_t bytes_per_pixel) const;

private:
    std::string reason_of(const std::string& said) const;
};

}  // namespace momentscope
