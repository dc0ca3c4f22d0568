// oiio_codec.cpp -- the codec by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <new>
#include <utility>

#include "pictures/picture_codec.hpp"

namespace momentscope {

namespace {

constexpr int MAX_MIB = 2048;  // that a decoder may take for a picture as it is stored

OIIO::TypeDesc type_of(PictureNumbers numbers) {
    return numbers == PictureNumbers::floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
}

class OiioReader : public PictureReader {
public:
    explicit OiioReader(std::unique_ptr<OIIO::ImageInput> input) : input_(std::move(input)) {
        const OIIO::ImageSpec& spec = input_->spec();
        header_ = {.width = spec.width,
                   .height = spec.height,
                   .depth = spec.depth,
                   .channels = spec.channelnames,
                   .alpha_channel = spec.alpha_channel,
                   .holds_floats = spec.format.is_floating_point()};
        header_.channels.resize(static_cast<std::size_t>(spec.nchannels > 0 ? spec.nchannels : 0));
    }

    const PictureHeader& header() const override { return header_; }

    bool read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels) override {
        return input_->read_image(0, 0, first_channel, first_channel + channel_count, type_of(numbers),
                                  pixels);
    }

    std::string error() override { return input_->geterror(); }

private:
    std::unique_ptr<OIIO::ImageInput> input_;
    PictureHeader header_;
};

std::unique_ptr<PictureReader> open(const std::string& path, bool unassociated, std::string& reason) {
    OIIO::ImageSpec as_stored;
    if (unassociated) as_stored.attribute("oiio:UnassociatedAlpha", 1);
    // Some decoders take the memory while they open the file.
    OIIO::attribute("limits:imagesize_MB", MAX_MIB);
    try {
        if (auto input = OIIO::ImageInput::open(path, &as_stored))
            return std::make_unique<OiioReader>(std::move(input));
        reason = OIIO::geterror();
    } catch (const std::bad_alloc&) {
        OIIO::geterror();
    }
    return nullptr;
}

// In memory, since the library does not tell when a disk is full.
std::vector<unsigned char> encode(const char* kind, int width, int height, PictureNumbers numbers,
                                  const void* pixels, std::string& reason) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::string name = std::string("memory") + kind;
    const OIIO::ImageSpec spec(width, height, 4, type_of(numbers));
    const auto file = OIIO::ImageOutput::create(name, &memory);
    if (file && file->open(name, spec) && file->write_image(type_of(numbers), pixels) && file->close())
        return bytes;
    reason = file ? file->geterror() : OIIO::geterror();
    return {};
}

std::vector<float> magma(const std::vector<float>& numbers) {
    const auto count = static_cast<int>(numbers.size());
    OIIO::ImageBuf source(OIIO::ImageSpec(count, 1, 1, OIIO::TypeDesc::FLOAT));
    const OIIO::ROI all(0, count, 0, 1, 0, 1);
    source.set_pixels(all, OIIO::TypeDesc::FLOAT, numbers.data());
    const OIIO::ImageBuf colored = OIIO::ImageBufAlgo::color_map(source, 0, "magma");
    std::vector<float> srgb(3 * numbers.size());
    colored.get_pixels(OIIO::ROI(0, count, 0, 1, 0, 1, 0, 3), OIIO::TypeDesc::FLOAT, srgb.data());
    return srgb;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const PictureCodec* momentscope_picture_codec() {
    static constexpr PictureCodec CODEC = {.open = open, .encode = encode, .magma = magma};
    return &CODEC;
}

}  // namespace momentscope
