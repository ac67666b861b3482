#include <gonio/media/image/png_writer.hpp>

#include <algorithm>
#include <cmath>
#include <new>
#include <png.h>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gonio::media::detail {

namespace {

using namespace abi;

[[noreturn]] void raise(png_structp /*png*/, png_const_charp text) {
    throw std::runtime_error(text);
}

void ignore(png_structp /*png*/, png_const_charp /*text*/) {}

struct Writer {
    Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, raise, ignore)) {
        if (png != nullptr) info = png_create_info_struct(png);
        if (info == nullptr) throw std::bad_alloc();
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }

    png_structp png = nullptr;
    png_infop info = nullptr;
};

constexpr int color_type_of(std::int32_t channels) {
    constexpr int types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                             PNG_COLOR_TYPE_RGB_ALPHA};
    return types[channels - 1];
}

// "Description" is the PNG's word for ImageDescription.
const char* keyword_of(std::string_view attribute) {
    if (attribute == "ImageDescription") return "Description";
    if (attribute == "Artist") return "Author";
    if (attribute == "Software") return "Software";
    if (attribute == "Copyright") return "Copyright";
    return nullptr;
}

void set_attributes(const Writer& writer, const EncodeRequest& request) {
    std::vector<std::string> texts; // libpng takes char*, which it copies
    texts.reserve(2 * request.attribute_count);
    for (std::size_t i = 0; i < request.attribute_count; ++i) {
        const Attribute& attribute = request.attributes[i];
        if (attribute.kind != attribute_text) continue;
        if (std::string_view(attribute.name) == "oiio:ColorSpace") {
            if (std::string_view(attribute.text) == "sRGB")
                png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_ABSOLUTE);
            else
                png_set_gAMA(writer.png, writer.info, 1.0);
            continue;
        }
        const char* const keyword = keyword_of(attribute.name);
        if (keyword == nullptr) continue;
        png_text text{};
        text.compression = PNG_TEXT_COMPRESSION_NONE;
        text.key = texts.emplace_back(keyword).data();
        text.text = texts.emplace_back(attribute.text).data();
        text.text_length = texts.back().size();
        png_set_text(writer.png, writer.info, &text, 1);
    }
}

// Rounded to the nearest, clipped; NaN is 0. Of 16 bits the high byte first.
void store(const float* from, std::size_t count, bool wide, std::vector<png_byte>& row) {
    const float greatest = wide ? 65535.0F : 255.0F;
    for (std::size_t i = 0; i < count; ++i) {
        const float clipped = from[i] > 0.0F ? std::min(from[i], 1.0F) : 0.0F;
        const auto number = static_cast<unsigned>(std::floor(clipped * greatest + 0.5F));
        if (wide) {
            row[2 * i] = static_cast<png_byte>(number >> 8U);
            row[2 * i + 1] = static_cast<png_byte>(number & 255U);
        } else {
            row[i] = static_cast<png_byte>(number);
        }
    }
}

} // namespace

std::vector<unsigned char> png_bytes(const EncodeRequest& request) {
    std::vector<unsigned char> bytes;
    const Writer writer;
    png_set_write_fn(
        writer.png, &bytes,
        [](png_structp png, png_bytep data, std::size_t size) {
            auto& to = *static_cast<std::vector<unsigned char>*>(png_get_io_ptr(png));
            to.insert(to.end(), data, data + size);
        },
        [](png_structp) {});
    const bool wide = request.pixel == pixel_uint16;
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(request.width),
                 static_cast<png_uint_32>(request.height), wide ? 16 : 8, color_type_of(request.channels),
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    set_attributes(writer, request);
    png_write_info(writer.png, writer.info);
    const std::size_t values = static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.channels);
    std::vector<png_byte> row(values * (wide ? 2 : 1));
    for (std::int32_t y = 0; y < request.height; ++y) {
        store(request.pixels + static_cast<std::size_t>(y) * values, values, wide, row);
        png_write_row(writer.png, row.data());
    }
    png_write_end(writer.png, nullptr);
    return bytes;
}

} // namespace gonio::media::detail
