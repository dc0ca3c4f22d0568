// picture_file.hpp -- opens pictures that cannot be trusted.
#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "core/caught_stderr.hpp"
#include "pictures/picture_codec.hpp"

namespace momentscope {

/// Of what a library says, as part of a sentence of ours.
std::string first_sentence(const std::string& text);

/// A picture file of which nothing but its header was read, and what the libraries say of it.
struct PictureFile {
    CaughtStderr caught;  // they may print by themselves
    std::filesystem::path path;
    std::string what;  // "picture"
    std::unique_ptr<PictureReader> reader;

    /// Throws Error that calls the file `what` unless it is an ordinary file that begins as a picture.
    /// Colours come not multiplied by alpha if `unassociated`.
    PictureFile(std::filesystem::path file, std::string kind, bool unassociated = false);

    const PictureHeader& header() const { return reader->header(); }

    /// Reads so many channels from the first on, row by row. Throws Error when the file ends before.
    void read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels);

    /// Throws Error unless the picture is flat and has from 1 to `most_side` pixels to each side, and at most
    /// `most_pixels`, and so many bytes for each of them are free.
    void require_size(int most_side, std::size_t most_pixels, std::size_t bytes_per_pixel) const;

private:
    std::string reason_of(const std::string& said) const;
};

}  // namespace momentscope
