// The image module of WebAssembly: PNG, by libpng, and OpenEXR, which is only written. Its contract is in
// detail/image_abi.hpp.
//
// libpng reports a failure by a function that must not return: it throws, and the frames of libpng are unwound as those
// of any other code.
#include <gonio/media/detail/image_abi.hpp>
#include <gonio/media/image/exr_writer.hpp>
#include <gonio/media/image/png_writer.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <png.h>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace gonio::media::abi;

// Runs `work` and turns its exceptions into a status.
template<class Work>
int guarded(char* message, Status refused, Work work) noexcept {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        std::snprintf(message, message_bytes, "out of memory");
        return out_of_memory;
    } catch (const std::exception& error) {
        std::snprintf(message, message_bytes, "%s", error.what());
        return refused;
    } catch (...) {
        std::snprintf(message, message_bytes, "unknown exception");
        return internal;
    }
}

[[noreturn]] void raise(png_structp /*png*/, png_const_charp text) {
    throw std::runtime_error(text);
}

void ignore(png_structp /*png*/, png_const_charp /*text*/) {}

int refuse(char* message) {
    std::snprintf(message, message_bytes, "of picture formats, WebAssembly writes PNG and OpenEXR and reads PNG");
    return unsupported;
}

struct Reader {
    Reader() : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, raise, ignore)) {
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) throw std::bad_alloc();
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }

    png_structp png = nullptr;
    png_infop info = nullptr;
};

int encode(const EncodeRequest* request, EncodeReply* reply) noexcept {
    return guarded(reply->message, unsupported, [&]() -> int {
        auto bytes = std::make_unique<std::vector<unsigned char>>();
        if (std::string_view(request->format) == "openexr")
            *bytes = gonio::media::detail::exr_bytes(*request);
        else if (std::string_view(request->format) == "png")
            *bytes = gonio::media::detail::png_bytes(*request);
        else
            return refuse(reply->message);
        reply->bytes = bytes->data();
        reply->size = bytes->size();
        reply->owner = bytes.release();
        return done;
    });
}
void release_encoded(void* owner) noexcept {
    delete static_cast<std::vector<unsigned char>*>(owner);
}

struct Decoded {
    std::vector<float> pixels;
    std::vector<const char*> channel_names;
};

struct Source {
    const unsigned char* at;
    std::size_t left;
};

void read_bytes(png_structp png, png_bytep to, std::size_t size) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (size > source.left) png_error(png, "the file is cut off");
    std::memcpy(to, source.at, size);
    source.at += size;
    source.left -= size;
}

int decode(const DecodeRequest* request, DecodeReply* reply) noexcept {
    return guarded(reply->message, malformed, [&]() -> int {
        if (std::string_view(request->format) != "png") return refuse(reply->message);
        const Reader reader;
        Source source{request->bytes, request->size};
        png_set_read_fn(reader.png, &source, read_bytes);
        png_read_info(reader.png, reader.info);
        png_set_expand(reader.png); // palettes, fewer than 8 bits, transparent colours
        const int passes = png_set_interlace_handling(reader.png);
        png_read_update_info(reader.png, reader.info);
        const std::size_t width = png_get_image_width(reader.png, reader.info);
        const std::size_t height = png_get_image_height(reader.png, reader.info);
        const std::size_t channels = png_get_channels(reader.png, reader.info);
        reply->width = static_cast<std::int32_t>(width);
        reply->height = static_cast<std::int32_t>(height);
        reply->channels = static_cast<std::int32_t>(channels);
        const double values = static_cast<double>(width) * static_cast<double>(height) * static_cast<double>(channels);
        if (values > static_cast<double>(request->max_values)) throw std::runtime_error("the picture is too large");
        const bool wide = png_get_bit_depth(reader.png, reader.info) == 16;
        const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
        std::vector<png_byte> bytes(row_bytes * height);
        for (int pass = 0; pass < passes; ++pass) // an interlaced picture comes in several passes over all rows
            for (std::size_t y = 0; y < height; ++y)
                png_read_row(reader.png, bytes.data() + y * row_bytes, nullptr);
        png_read_end(reader.png, nullptr);
        auto decoded = std::make_unique<Decoded>();
        decoded->pixels.resize(width * height * channels);
        for (std::size_t i = 0; i < decoded->pixels.size(); ++i)
            decoded->pixels[i] = wide ? static_cast<float>(bytes[2 * i] * 256U + bytes[2 * i + 1]) / 65535.0F
                                      : static_cast<float>(bytes[i]) / 255.0F;
        constexpr const char* names[][4] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
        decoded->channel_names.assign(names[channels - 1], names[channels - 1] + channels);
        reply->pixel = wide ? pixel_uint16 : pixel_uint8;
        reply->pixels = decoded->pixels.data();
        reply->channel_names = decoded->channel_names.data();
        reply->attributes = nullptr;
        reply->attribute_count = 0;
        reply->owner = decoded.release();
        return done;
    });
}

void release_decoded(void* owner) noexcept {
    delete static_cast<Decoded*>(owner);
}

constexpr ImageModule table{image_version, encode, release_encoded, decode, release_decoded};

} // namespace

extern "C" const void* gonio_image_module();

const void* gonio_image_module() {
    return &table;
}
