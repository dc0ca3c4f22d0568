// picture_codec.hpp -- what reads and writes picture files, as a module that is loaded when a picture needs
// it: OpenImageIO brings 260 libraries, which take a fifth of a second of CPU to load, and most commands need
// no picture. Only plain types pass between the two, because the module uses the standard library that
// OpenImageIO was built with, which may be another one than that of the program.
#pragma once
#include <cstddef>

namespace momentscope {

enum class PictureNumbers { bytes, floats };

struct PictureHeader {
    int width = 0, height = 0, depth = 0;
    const char* const* channels = nullptr;  // their names
    std::size_t channel_count = 0;
    int alpha_channel = -1;  // -1: there is none
    bool holds_floats = false;
};

enum class PictureOutcome { complete, failed, no_memory };

/// A file of which the header was read.
class PictureReader {
public:
    PictureReader() = default;
    virtual ~PictureReader() = default;
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    /// Valid as long as the reader.
    virtual const PictureHeader& header() const = 0;

    /// Reads so many channels from the first on, row by row from the top.
    virtual PictureOutcome read(int first_channel, int channel_count, PictureNumbers numbers,
                                void* pixels) = 0;
};

/// The bytes of a picture file.
class PictureBytes {
public:
    PictureBytes() = default;
    virtual ~PictureBytes() = default;
    PictureBytes(const PictureBytes&) = delete;
    PictureBytes& operator=(const PictureBytes&) = delete;

    virtual const char* data() const = 0;
    virtual std::size_t size() const = 0;
};

struct PictureCodec {
    /// A new reader. Null when the file does not begin as a picture. Colours come as the file holds them: not
    /// multiplied by alpha if `unassociated`.
    PictureReader* (*open)(const char* path, bool unassociated);

    /// Four channels as the new bytes of a file; `kind` is ".png" or ".exr". Null on failure.
    PictureBytes* (*encode)(const char* kind, int width, int height, PictureNumbers numbers,
                            const void* pixels);

    /// Why the last call in this thread failed. Valid until the next call.
    const char* (*reason)();
};

/// The only name that the module exports: a function that returns the codec.
constexpr const char* PICTURE_CODEC_NAME = "momentscope_picture_codec";
using PictureCodecFunction = const PictureCodec* (*)();

}  // namespace momentscope
