#include <gonio/media/image/png_writer.hpp>
#include <gonio/media/image/zlib_stream.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <png.h>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

// The bytes of a row less what a filter of PNG expects from the byte of the pixel to the left, the one above and the
// one above that ("Portable Network Graphics", 9.2).
struct RowFilter {
    using Row = std::vector<png_byte>;

    const Row& row;
    const Row& above;
    std::size_t pixel; // bytes

    template<class Expected>
    void apply(Row& to, const Expected& expected) const {
        for (std::size_t i = 0; i < std::min(pixel, row.size()); ++i)
            to[i] = static_cast<png_byte>(row[i] - expected(0, above[i], 0));
        for (std::size_t i = pixel; i < row.size(); ++i)
            to[i] = static_cast<png_byte>(row[i] - expected(row[i - pixel], above[i], above[i - pixel]));
    }
    void apply(std::size_t filter, Row& to) const {
        switch (filter) {
        case 0:
            return apply(to, [](int, int, int) { return 0; });
        case 1:
            return apply(to, [](int left, int, int) { return left; });
        case 2:
            return apply(to, [](int, int up, int) { return up; });
        case 3:
            return apply(to, [](int left, int up, int) { return (left + up) / 2; });
        default: // Paeth's: the one nearest to left + up - corner
            return apply(to, [](int left, int up, int corner) {
                const int from_left = std::abs(up - corner);
                const int from_up = std::abs(left - corner);
                const int from_corner = std::abs(left + up - 2 * corner);
                const int other = from_up <= from_corner ? up : corner;
                return from_left <= from_up && from_left <= from_corner ? left : other;
            });
        }
    }
};

// The sum of the sizes of differences, which are bytes with a sign.
std::uint32_t size_of_differences(const std::vector<png_byte>& differences) {
    std::uint32_t sum = 0;
    for (const png_byte each : differences)
        sum += each < 128 ? each : 256U - each;
    return sum;
}

// All rows, each with the number of its filter before it: of the five that whose differences are the smallest.
std::vector<unsigned char> filtered_rows(const EncodeRequest& request, bool wide) {
    const auto channels = static_cast<std::size_t>(request.channels);
    const auto height = static_cast<std::size_t>(request.height);
    const std::size_t values = static_cast<std::size_t>(request.width) * channels;
    const std::size_t size = values * (wide ? 2 : 1);
    std::vector<png_byte> row(size);
    std::vector<png_byte> above(size); // zeros above the first row
    std::array<std::vector<png_byte>, 5> candidates;
    candidates.fill(row);
    std::vector<unsigned char> all;
    all.reserve((size + 1) * height);
    for (std::size_t y = 0; y < height; ++y) {
        store(request.pixels + y * values, values, wide, row);
        const RowFilter filter{row, above, channels * (wide ? 2 : 1)};
        std::size_t best = 0;
        std::uint32_t least = UINT32_MAX;
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            filter.apply(k, candidates[k]);
            const std::uint32_t sum = size_of_differences(candidates[k]);
            if (sum >= least) continue;
            least = sum;
            best = k;
        }
        all.push_back(static_cast<unsigned char>(best));
        all.insert(all.end(), candidates[best].begin(), candidates[best].end());
        std::swap(row, above);
    }
    return all;
}

// libpng's own rows go through zlib.
void write_pixels(const Writer& writer, std::span<const unsigned char> stream) {
    constexpr std::size_t most = 1U << 20U; // of a chunk
    for (std::size_t at = 0; at < stream.size(); at += most) {
        const auto chunk = stream.subspan(at, std::min(most, stream.size() - at));
        png_write_chunk(writer.png, reinterpret_cast<png_const_bytep>("IDAT"), chunk.data(), chunk.size());
    }
    png_write_chunk(writer.png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
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
    constexpr int level = 4; // 6 makes previews 5 to 8 % smaller and takes twice as long
    write_pixels(writer, zlib_stream(filtered_rows(request, wide), level));
    return bytes;
}

} // namespace gonio::media::detail
