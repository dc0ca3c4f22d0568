// small_codec.cpp -- the codec of the browser edition: stb reads PNG and JPEG and writes PNG, TinyEXR writes
// EXR.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "pictures/picture_codec.hpp"

// Their code, once.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_FAILURE_USERMSG
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define TINYEXR_IMPLEMENTATION
#define TINYEXR_USE_MINIZ 0
#define TINYEXR_USE_THREAD 0
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#include <tinyexr.h>
#pragma clang diagnostic pop

namespace momentscope {

namespace {

std::string last_reason;

struct Free {
    void operator()(unsigned char* pixels) const { stbi_image_free(pixels); }
};
using Pixels = std::unique_ptr<unsigned char[], Free>;

/// A picture that was decoded as a whole.
class DecodedReader : public PictureReader {
public:
    DecodedReader(Pixels pixels, int width, int height, int channel_count) : pixels_(std::move(pixels)) {
        static constexpr const char* COLOR[] = {"R", "G", "B", "A"};
        static constexpr const char* GRAY[] = {"Y", "A"};
        header_ = {.width = width,
                   .height = height,
                   .depth = 1,
                   .channels = channel_count < 3 ? GRAY : COLOR,
                   .channel_count = static_cast<std::size_t>(channel_count),
                   .alpha_channel = channel_count % 2 == 0 ? channel_count - 1 : -1};
    }

    const PictureHeader& header() const override { return header_; }

    PictureOutcome read(int first_channel, int channel_count, PictureNumbers numbers, void* pixels) override {
        const auto count = static_cast<std::size_t>(header_.width) * static_cast<std::size_t>(header_.height);
        std::size_t next = 0;
        for (std::size_t i = 0; i < count; ++i)
            for (int c = first_channel; c < first_channel + channel_count; ++c, ++next) {
                const unsigned char value = pixels_[i * header_.channel_count + static_cast<std::size_t>(c)];
                if (numbers == PictureNumbers::floats)
                    static_cast<float*>(pixels)[next] = static_cast<float>(value) / 255;
                else
                    static_cast<unsigned char*>(pixels)[next] = value;
            }
        return PictureOutcome::complete;
    }

private:
    Pixels pixels_;
    PictureHeader header_;
};

struct EncodedBytes : PictureBytes {
    explicit EncodedBytes(std::vector<unsigned char> all) : bytes(std::move(all)) {}
    std::vector<unsigned char> bytes;

    const char* data() const override { return reinterpret_cast<const char*>(bytes.data()); }
    std::size_t size() const override { return bytes.size(); }
};

// Colours of these formats are not multiplied by alpha, so the second parameter changes nothing.
PictureReader* open(const char* path, bool) {
    last_reason.clear();
    int width = 0, height = 0, channels = 0;
    Pixels pixels(stbi_load(path, &width, &height, &channels, 0));
    if (pixels != nullptr) return new DecodedReader(std::move(pixels), width, height, channels);
    last_reason = stbi_failure_reason();
    return nullptr;
}

PictureBytes* encode_png(int width, int height, const void* pixels) {
    std::vector<unsigned char> bytes;
    const auto append = [](void* to, void* data, int size) {
        const auto* first = static_cast<const unsigned char*>(data);
        static_cast<std::vector<unsigned char>*>(to)->insert(
            static_cast<std::vector<unsigned char>*>(to)->end(), first, first + size);
    };
    if (stbi_write_png_to_func(append, &bytes, width, height, 4, pixels, 4 * width) != 0)
        return new EncodedBytes(std::move(bytes));
    last_reason = "the PNG could not be made";
    return nullptr;
}

// TinyEXR makes files only, which lie in memory here.
PictureBytes* encode_exr(int width, int height, const void* pixels) {
    constexpr const char* FILE_NAME = "/unfinished.exr";
    const char* error = nullptr;
    if (SaveEXR(static_cast<const float*>(pixels), width, height, 4, 0, FILE_NAME, &error) ==
        TINYEXR_SUCCESS) {
        std::ifstream file(FILE_NAME, std::ios::binary);
        std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
        std::remove(FILE_NAME);
        return new EncodedBytes(std::move(bytes));
    }
    last_reason = error != nullptr ? error : "the EXR could not be made";
    FreeEXRErrorMessage(error);
    return nullptr;
}

PictureBytes* encode(const char* kind, int width, int height, PictureNumbers numbers, const void* pixels) {
    return numbers == PictureNumbers::floats && std::string(kind) == ".exr"
               ? encode_exr(width, height, pixels)
               : encode_png(width, height, pixels);
}

const char* reason() {
    return last_reason.c_str();
}

}  // namespace

extern "C" const PictureCodec* momentscope_picture_codec() {
    static constexpr PictureCodec CODEC = {.open = open, .encode = encode, .reason = reason};
    return &CODEC;
}

}  // namespace momentscope
