// oiio_codec.cpp -- the codec by OpenImageIO.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "pictures/picture_codec.hpp"

namespace momentscope {

namespace {

constexpr int MAX_MIB = 2048;  // that a decoder may take for a picture as it is stored

thread_local std::string last_reason;

OIIO::TypeDesc type_of(PictureNumbers numbers) {
    return numbers == PictureNumbers::floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
}

class OiioReader : public PictureReader {
public:
    explicit OiioReader(std::unique_ptr<OIIO::ImageInput> input) : input_(std::move(input)) {
        const OIIO::ImageSpec& spec = input_->spec();
        channels_ = spec.channelnames;
        channels_.resize(static_cast<std::size_t>(spec.nchannels > 0 ? spec.nchannels : 0));
        for (const std::string& channel : channels_) names_.push_back(channel.c_str());
        header_ = {.width = spec.width,
                   .height = spec.height,
                   .depth = spec.depth,
                   .channels = names_.data(),
                   .channel_count = names_.size(),
                   .alpha_channel = spec.alpha_channel,
                   .holds_floats = spec.format.is_floating_point()};
    }

    const PictureHeader& header() const override { return header_; }

    PictureOutcome read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels) override {
        try {
            if (input_->read_image(0, 0, first_channel, first_channel + channel_count, type_of(numbers),
                                   pixels))
                return PictureOutcome::complete;
        } catch (const std::bad_alloc&) {
            return PictureOutcome::no_memory;
        }
        last_reason = input_->geterror();
        return PictureOutcome::failed;
    }

private:
    std::unique_ptr<OIIO::ImageInput> input_;
    std::vector<std::string> channels_;
    std::vector<const char*> names_;
    PictureHeader header_;
};

struct OiioBytes : PictureBytes {
    std::vector<unsigned char> bytes;

    const char* data() const override { return reinterpret_cast<const char*>(bytes.data()); }
    std::size_t size() const override { return bytes.size(); }
};

PictureReader* open(const char* path, bool unassociated) {
    last_reason.clear();
    OIIO::ImageSpec as_stored;
    if (unassociated) as_stored.attribute("oiio:UnassociatedAlpha", 1);
    // Some decoders take the memory while they open the file.
    OIIO::attribute("limits:imagesize_MB", MAX_MIB);
    try {
        if (auto input = OIIO::ImageInput::open(path, &as_stored)) return new OiioReader(std::move(input));
        last_reason = OIIO::geterror();
    } catch (const std::bad_alloc&) {
        OIIO::geterror();
    }
    return nullptr;
}

// In memory, since the library does not tell when a disk is full.
PictureBytes* encode(const char* kind, int width, int height, PictureNumbers numbers, const void* pixels) {
    try {
        auto encoded = std::make_unique<OiioBytes>();
        OIIO::Filesystem::IOVecOutput memory(encoded->bytes);
        const std::string name = std::string("memory") + kind;
        const OIIO::ImageSpec spec(width, height, 4, type_of(numbers));
        const auto file = OIIO::ImageOutput::create(name, &memory);
        if (file && file->open(name, spec) && file->write_image(type_of(numbers), pixels) && file->close())
            return encoded.release();
        last_reason = file ? file->geterror() : OIIO::geterror();
    } catch (const std::bad_alloc&) {
        last_reason = "there is too little memory";
    }
    return nullptr;
}

const char* reason() {
    return last_reason.c_str();
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const PictureCodec* momentscope_picture_codec() {
    static constexpr PictureCodec CODEC = {.open = open, .encode = encode, .reason = reason};
    return &CODEC;
}

}  // namespace momentscope
