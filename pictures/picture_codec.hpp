// picture_codec.hpp -- what reads and writes picture files, as a module that is loaded when a picture needs
// it: OpenImageIO brings 260 libraries, which take a fifth of a second of CPU to load, and most commands need
// no picture.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace momentscope {

enum class PictureNumbers { bytes, floats };

struct PictureHeader {
    int width = 0, height = 0, depth = 0;
    std::vector<std::string> channels;  // their names
    int alpha_channel = -1;             // -1: there is none
    bool holds_floats = false;
};

/// A file of which the header was read.
class PictureReader {
public:
    PictureReader() = default;
    virtual ~PictureReader() = default;
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    virtual const PictureHeader& header() const = 0;

    /// Reads so many channels from the first on, row by row from the top. False when the file ends before;
    /// error() tells why. Throws std::bad_alloc.
    virtual bool read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels) = 0;
    virtual std::string error() = 0;
};

struct PictureCodec {
    /// Null and the reason when the file does not begin as a picture. Colours come as the file holds them:
    /// not multiplied by alpha if `unassociated`.
    std::unique_ptr<PictureReader> (*open)(const std::string& path, bool unassociated, std::string& reason);

    /// Four channels as the bytes of a file; `kind` is ".png" or ".exr". Empty, and the reason, on failure.
    std::vector<unsigned char> (*encode)(const char* kind, int width, int height, PictureNumbers numbers,
                                         const void* pixels, std::string& reason);

    /// The colour map magma: sRGB, three floats for each number, from 0 to 1; what is beyond has the
    /// brightest colour.
    std::vector<float> (*magma)(const std::vector<float>& numbers);
};

/// The only name that the module exports: a function that returns the codec.
constexpr const char* PICTURE_CODEC_NAME = "momentscope_picture_codec";
using PictureCodecFunction = const PictureCodec* (*)();

}  // namespace momentscope
