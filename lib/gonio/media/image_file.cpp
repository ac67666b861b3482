#include <gonio/base/nearest.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/detail/png_container.hpp>
#include <gonio/media/dither.hpp>
#include <gonio/media/image_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <type_traits>

namespace gonio::media {

namespace {

constexpr float largest_half = 65504.0F;
// From this value on, rounding gives infinity instead of 65504.
constexpr float half_overflow = 65520.0F;

constexpr std::array<std::string_view, 1> exr_extensions{"exr"};
constexpr std::array<std::string_view, 1> png_extensions{"png"};
constexpr std::array<std::string_view, 2> tiff_extensions{"tif", "tiff"};
constexpr std::array<std::string_view, 1> hdr_extensions{"hdr"};
constexpr std::array<std::string_view, 2> jpeg_extensions{"jpg", "jpeg"};

constexpr std::array exr_pixels{Pixel::half, Pixel::float32};
constexpr std::array png_pixels{Pixel::uint8, Pixel::uint16};
constexpr std::array tiff_pixels{Pixel::float32, Pixel::uint16, Pixel::uint8};
constexpr std::array hdr_pixels{Pixel::float32};
constexpr std::array jpeg_pixels{Pixel::uint8};

constexpr std::array png_channels{1, 2, 3, 4};
constexpr std::array rgb_only{3};
constexpr std::array jpeg_channels{1, 3};

constexpr std::array<ImageFormat, 5> formats{{
    {"exr", "OpenEXR", exr_extensions, exr_pixels, {}, true, "openexr"},
    {"png", "PNG", png_extensions, png_pixels, png_channels, false, "png"},
    {"tiff", "TIFF", tiff_extensions, tiff_pixels, {}, false, "tiff"},
    {"hdr", "Radiance HDR", hdr_extensions, hdr_pixels, rgb_only, false, "hdr"},
    {"jpeg", "JPEG", jpeg_extensions, jpeg_pixels, jpeg_channels, false, "jpeg"},
}};

constexpr std::array<std::string_view, 10> exr_compressions{"none",  "rle", "zip",  "zips", "piz",
                                                            "pxr24", "b44", "b44a", "dwaa", "dwab"};
constexpr std::array<std::string_view, 4> tiff_compressions{"none", "lzw", "zip", "packbits"};

// The attributes that are passed to a format that cannot store every attribute.
constexpr std::array<std::string_view, 5> common_attributes{"ImageDescription", "Software", "Copyright", "Artist",
                                                            "DateTime"};

std::int32_t kind_of(Pixel pixel) {
    switch (pixel) {
    case Pixel::uint8:
        return abi::pixel_uint8;
    case Pixel::uint16:
        return abi::pixel_uint16;
    case Pixel::half:
        return abi::pixel_half;
    case Pixel::float32:
        break;
    }
    return abi::pixel_float;
}

Pixel pixel_of(std::int32_t kind) {
    switch (kind) {
    case abi::pixel_uint8:
        return Pixel::uint8;
    case abi::pixel_uint16:
        return Pixel::uint16;
    case abi::pixel_half:
        return Pixel::half;
    default:
        return Pixel::float32;
    }
}

std::vector<std::string> default_channel_names(int channels) {
    switch (channels) {
    case 1:
        return {"Y"};
    case 2:
        return {"Y", "A"};
    case 3:
        return {"R", "G", "B"};
    case 4:
        return {"R", "G", "B", "A"};
    default: {
        std::vector<std::string> names;
        names.reserve(static_cast<std::size_t>(channels));
        for (int c = 0; c < channels; ++c)
            names.push_back(fmt::format("C{}", c));
        return names;
    }
    }
}

Result<void> check_compression(const ImageFormat& format, const std::string& compression) {
    std::span<const std::string_view> known;
    if (format.name == "exr") known = exr_compressions;
    if (format.name == "tiff") known = tiff_compressions;
    const std::string name = compression.substr(0, compression.find(':'));
    if (known.empty() || compression.empty() || std::find(known.begin(), known.end(), name) != known.end()) return {};
    const std::string_view near = nearest(name, known);
    return fail("USE0103", fmt::format("{} has no compression '{}'", format.title, name),
                near.empty() ? fmt::format("there are: {}", fmt::join(known, ", "))
                             : fmt::format("did you mean '{}'?", near));
}

Result<void> check_request(const Image& image, const ImageFormat& format, const ImageWriteOptions& options,
                           Pixel pixel) {
    if (image.width <= 0 || image.height <= 0 || image.channels <= 0)
        return fail("USE0106", fmt::format("a picture of {}x{} pixels and {} channels cannot be written", image.width,
                                           image.height, image.channels));
    if (image.pixels.size() != image.index(0, image.height))
        return fail(Failure::internal, "the picture's buffer is not of the picture's size");
    if (!format.channels.empty() &&
        std::find(format.channels.begin(), format.channels.end(), image.channels) == format.channels.end())
        return fail(
            Failure::unsupported,
            fmt::format("{} holds {} channels, not {}", format.title, fmt::join(format.channels, ", "), image.channels),
            "OpenEXR and TIFF hold any number of channels");
    if (std::find(format.pixels.begin(), format.pixels.end(), pixel) == format.pixels.end()) {
        std::vector<std::string_view> names;
        for (const Pixel p : format.pixels)
            names.push_back(to_text(p));
        return fail(Failure::unsupported, fmt::format("{} cannot store {} pixels", format.title, to_text(pixel)),
                    fmt::format("it has: {}", fmt::join(names, ", ")));
    }
    if (!options.channel_names.empty() && options.channel_names.size() != static_cast<std::size_t>(image.channels))
        return fail("USE0107", fmt::format("{} names for {} channels", options.channel_names.size(), image.channels));
    return check_compression(format, options.compression);
}

// Values that `half` cannot store: an error, or the nearest value that it can store. `kept` owns the changed copy.
Result<const float*> fit_half(const Image& image, bool saturate, std::vector<float>& kept) {
    const auto too_large = [](float value) { return std::isfinite(value) && std::abs(value) >= half_overflow; };
    const auto found = std::find_if(image.pixels.begin(), image.pixels.end(), too_large);
    if (found == image.pixels.end()) return image.pixels.data();
    if (!saturate)
        return fail(
            Failure::unsupported,
            fmt::format("the value {} does not fit 16-bit floats, which end at 65504", static_cast<double>(*found)),
            "write 32-bit floats, or a smaller exposure");
    kept = image.pixels;
    for (float& value : kept)
        if (too_large(value)) value = std::copysign(largest_half, value);
    return kept.data();
}

abi::Attribute to_abi(const ImageAttribute& attribute) {
    abi::Attribute result{attribute.name.c_str(), abi::attribute_text, 0, nullptr, nullptr, nullptr};
    if (const auto* const text = std::get_if<std::string>(&attribute.value)) {
        result.text = text->c_str();
    } else if (const auto* const floats = std::get_if<std::vector<float>>(&attribute.value)) {
        result.kind = abi::attribute_floats;
        result.count = floats->size();
        result.floats = floats->data();
    } else if (const auto* const ints = std::get_if<std::vector<int>>(&attribute.value)) {
        static_assert(std::is_same_v<int, std::int32_t>);
        result.kind = abi::attribute_ints;
        result.count = ints->size();
        result.ints = ints->data();
    }
    return result;
}

// The caller's attributes come after ours, so that they take precedence.
std::vector<ImageAttribute> all_attributes(const ImageFormat& format, const ImageWriteOptions& options) {
    std::vector<ImageAttribute> all;
    all.push_back({"Software", std::string("gonio ") + version});
    // OpenImageIO would write the current time.
    if (format.name == "exr" || format.name == "tiff") all.push_back({"DateTime", "1970:01:01 00:00:00"});
    if (!options.compression.empty()) all.push_back({"compression", options.compression});
    if (!options.color_space.empty()) all.push_back({"oiio:ColorSpace", options.color_space});
    for (const ImageAttribute& attribute : options.attributes)
        if (format.attributes ||
            std::find(common_attributes.begin(), common_attributes.end(), attribute.name) != common_attributes.end())
            all.push_back(attribute);
    return all;
}

// The module that writes the format: that of PNG and OpenEXR, where it is there and has the compression.
Result<const abi::ImageModule*> writer_of(const ImageFormat& format, const ImageWriteOptions& options) {
    constexpr std::array<std::string_view, 6> quick_compressions{"", "none", "rle", "zip", "zips", "piz"};
    const bool is_quick =
        format.name == "png" || (format.name == "exr" && std::find(quick_compressions.begin(), quick_compressions.end(),
                                                                   options.compression) != quick_compressions.end());
    if (is_quick)
        if (Result<const abi::ImageModule*> module = detail::writers_module()) return module;
    return detail::image_module();
}

ImageAttribute from_abi(const abi::Attribute& attribute) {
    ImageAttribute result{attribute.name, {}};
    if (attribute.kind == abi::attribute_floats)
        result.value = std::vector<float>(attribute.floats, attribute.floats + attribute.count);
    else if (attribute.kind == abi::attribute_ints)
        result.value = std::vector<int>(attribute.ints, attribute.ints + attribute.count);
    else
        result.value = std::string(attribute.text);
    return result;
}

// parallel_for() for a module. What ends it early is kept for the caller of the module.
struct LentLoop {
    unsigned threads = 1;
    std::exception_ptr failure;

    static bool run(void* loop, std::size_t count, void (*work)(void*, std::size_t), void* data) noexcept {
        auto& self = *static_cast<LentLoop*>(loop);
        try {
            parallel_for(count, self.threads, [&](std::size_t i) { work(data, i); });
            return true;
        } catch (...) {
            self.failure = std::current_exception();
            return false;
        }
    }
};

} // namespace

std::string_view to_text(Pixel pixel) {
    switch (pixel) {
    case Pixel::uint8:
        return "uint8";
    case Pixel::uint16:
        return "uint16";
    case Pixel::half:
        return "half";
    case Pixel::float32:
        break;
    }
    return "float";
}

std::span<const ImageFormat> image_formats() {
    return formats;
}

const ImageFormat* find_image_format(std::string_view name_or_path) {
    const std::size_t dot = name_or_path.find_last_of("./");
    const std::string name = to_lower(dot == std::string_view::npos ? name_or_path : name_or_path.substr(dot + 1));
    if (dot != std::string_view::npos && name_or_path[dot] == '/') return nullptr;
    for (const ImageFormat& format : formats)
        if (format.name == name ||
            std::find(format.extensions.begin(), format.extensions.end(), name) != format.extensions.end())
            return &format;
    return nullptr;
}

const ImageFormat* sniff_image_format(std::string_view bytes) {
    using namespace std::string_view_literals;
    struct Magic {
        std::string_view bytes;
        std::size_t format; // index into formats
    };
    static constexpr std::array<Magic, 8> magics{{{"\x76\x2f\x31\x01"sv, 0},
                                                  {"\x89PNG\r\n\x1a\n"sv, 1},
                                                  {"II*\0"sv, 2},
                                                  {"MM\0*"sv, 2},
                                                  {"II+\0"sv, 2},
                                                  {"#?RADIANCE"sv, 3},
                                                  {"#?RGBE"sv, 3},
                                                  {"\xff\xd8\xff"sv, 4}}};
    for (const Magic& magic : magics)
        if (bytes.starts_with(magic.bytes)) return &formats.at(magic.format);
    return nullptr;
}

Result<std::string> encode_image(const Image& image, const ImageFormat& format, const ImageWriteOptions& options) {
    const Pixel pixel = options.pixel.value_or(format.pixels.front());
    if (Result<void> checked = check_request(image, format, options, pixel); !checked) return pass_on(checked);
    std::vector<float> kept;
    const float* pixels = image.pixels.data();
    if (pixel == Pixel::half) {
        Result<const float*> fitted = fit_half(image, options.saturate, kept);
        if (!fitted) return pass_on(fitted);
        pixels = *fitted;
    } else if (options.dither && (pixel == Pixel::uint8 || pixel == Pixel::uint16)) {
        kept = dithered(image, pixel == Pixel::uint8 ? 255 : 65535);
        pixels = kept.data();
    }
    Result<const abi::ImageModule*> module = writer_of(format, options);
    if (!module) return pass_on(module);

    const std::vector<std::string> names =
        options.channel_names.empty() ? default_channel_names(image.channels) : options.channel_names;
    std::vector<const char*> name_pointers;
    name_pointers.reserve(names.size());
    for (const std::string& name : names)
        name_pointers.push_back(name.c_str());
    const std::vector<ImageAttribute> attributes = all_attributes(format, options);
    std::vector<abi::Attribute> attribute_table;
    attribute_table.reserve(attributes.size());
    for (const ImageAttribute& attribute : attributes)
        attribute_table.push_back(to_abi(attribute));

    const std::string writer(format.writer);
    LentLoop loop{options.threads, {}};
    const abi::EncodeRequest request{
        writer.c_str(), image.width,          image.height,           image.channels,         pixels,
        kind_of(pixel), name_pointers.data(), attribute_table.data(), attribute_table.size(), {&loop, LentLoop::run}};
    abi::EncodeReply reply{};
    const int status = (*module)->encode(&request, &reply);
    if (loop.failure) std::rethrow_exception(loop.failure);
    if (status != 0)
        return fail(detail::cause_of(status),
                    fmt::format("the picture cannot be written as {}: {}", format.title, reply.message));
    std::string bytes(reinterpret_cast<const char*>(reply.bytes), reply.size);
    (*module)->release_encoded(reply.owner);
    return bytes;
}

namespace {

// The reader of the bytes, and the module that has it.
struct Reader {
    const ImageFormat* format;
    const abi::ImageModule* module;
    std::string name;
};

Result<Reader> reader_of(std::string_view bytes) {
    const ImageFormat* const format = sniff_image_format(bytes);
    if (format == nullptr)
        return fail(Failure::malformed, "this is not a picture in a known format",
                    "there are: OpenEXR, PNG, TIFF, Radiance HDR, JPEG");
    if (format->name == "png" && !detail::is_whole_png(bytes))
        return fail(Failure::malformed, "the PNG picture cannot be read: it is cut off or damaged");
    Result<const abi::ImageModule*> module = detail::image_module();
    if (!module) return pass_on(module);
    return Reader{format, *module, std::string(format->writer)};
}

abi::DecodeRequest request_of(const Reader& reader, std::string_view bytes, std::size_t max_values) {
    return {reader.name.c_str(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), max_values};
}

Unexpected not_read(const Reader& reader, int status, const abi::DecodeReply& reply) {
    return fail(detail::cause_of(status),
                fmt::format("the {} picture cannot be read: {}", reader.format->title, reply.message));
}

} // namespace

Result<PictureDimensions> picture_dimensions(std::string_view bytes) {
    Result<Reader> reader = reader_of(bytes);
    if (!reader) return pass_on(reader);
    const abi::DecodeRequest request = request_of(*reader, bytes, 0);
    abi::DecodeReply reply{};
    const int status = reader->module->decode(&request, &reply);
    if (status == 0) reader->module->release_decoded(reply.owner);
    if (reply.width <= 0 || reply.height <= 0 || reply.channels <= 0) return not_read(*reader, status, reply);
    return PictureDimensions{reply.width, reply.height, reply.channels};
}

Result<DecodedImage> decode_image(std::string_view bytes, std::size_t max_values) {
    Result<Reader> reader = reader_of(bytes);
    if (!reader) return pass_on(reader);
    const abi::DecodeRequest request = request_of(*reader, bytes, max_values);
    abi::DecodeReply reply{};
    if (const int status = reader->module->decode(&request, &reply); status != 0)
        return not_read(*reader, status, reply);
    DecodedImage result;
    result.image = Image(reply.width, reply.height, reply.channels);
    std::copy_n(reply.pixels, result.image.pixels.size(), result.image.pixels.begin());
    result.pixel = pixel_of(reply.pixel);
    result.channel_names.assign(reply.channel_names, reply.channel_names + reply.channels);
    for (std::size_t i = 0; i < reply.attribute_count; ++i)
        result.attributes.push_back(from_abi(reply.attributes[i]));
    reader->module->release_decoded(reply.owner);
    return result;
}

} // namespace gonio::media
