// Picture files in memory: an Image as the bytes of an EXR, PNG, TIFF, Radiance HDR or JPEG file, and back.
//
// Bytes, not files: the caller writes them with base/file.hpp, so that a full disk, a pipe or a limit behaves as for
// every other output. Values are stored as given, with no colour conversion and no change for alpha; the two integer
// kinds map [0, 1] to their full range, rounded and clipped. Equal input gives equal bytes: they do not depend on the
// clock, the host name or the thread count.
//
// PNG and OpenEXR are written by the module gonio-writers.so (see module.hpp), which opens in milliseconds. Everything
// else opens gonio-image.so and fails (unsupported) without it; its first call in a process takes about 0.3 s, most of
// it to load OpenImageIO. Safe to call from any thread.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio::media {

// The stored type of a pixel.
enum class Pixel { uint8, uint16, half, float32 };

std::string_view to_text(Pixel pixel); // "uint8", "uint16", "half", "float"

// What a format can store. Does not need the module.
struct ImageFormat {
    std::string_view name;                        // "exr"
    std::string_view title;                       // "OpenEXR"
    std::span<const std::string_view> extensions; // lower case, without the dot; the usual one first
    std::span<const Pixel> pixels;                // the first one is the default
    std::span<const int> channels;                // empty: any number
    bool attributes;                              // keeps every attribute, not only the few common ones
    std::string_view writer;                      // OpenImageIO's name for it
};

// Every format, in the order of the help texts.
std::span<const ImageFormat> image_formats();

// By name or extension ("exr", ".TIF") or by the end of a path ("out/lamp.png"); nullptr if there is none.
const ImageFormat* find_image_format(std::string_view name_or_path);

// By the first bytes of a file; nullptr if they do not match a format here.
const ImageFormat* sniff_image_format(std::string_view bytes);

// A name and a value that the file stores with its picture.
struct ImageAttribute {
    std::string name;
    std::variant<std::string, std::vector<float>, std::vector<int>> value;
};

// How a picture is written.
struct ImageWriteOptions {
    // The format's default unless set. Fails (unsupported) when the format does not have such pixels.
    std::optional<Pixel> pixel;
    // One for each channel; empty: Y, YA, RGB, RGBA for 1 to 4 channels and C0, C1, … for more.
    std::vector<std::string> channel_names;
    // "zip", "piz", "none", "dwaa:45", "jpeg:90" as in OpenImageIO; empty: the format's default.
    std::string compression;
    // Tags the file if the format supports it: "sRGB", "Linear" (with Rec.709 primaries); empty: no tag.
    std::string color_space;
    // OpenEXR stores all of them. Other formats store those that image_file.cpp lists
    // as common, ImageDescription among them.
    std::vector<ImageAttribute> attributes;
    // uint8 and uint16 only: dithers (dither.hpp) before it rounds.
    bool dither = false;
    // half only: stores ±65504 for larger values instead of failing.
    bool saturate = false;
    // OpenEXR without compression or with rle, zip, zips or piz: the threads that compress it; 0: all processors. The
    // bytes are the same.
    unsigned threads = 1;
};

// The bytes of a file of `format`. Fails (unsupported) when the format cannot store that many channels or such pixels,
// or when a value does not fit `half` (and saturate is false); (usage) on an empty image, a buffer that does not match
// the image's size, a number of names that is not the number of channels, or an unknown compression of OpenEXR.
Result<std::string> encode_image(const Image& image, const ImageFormat& format, const ImageWriteOptions& options = {});

// A picture as read.
struct DecodedImage {
    Image image;
    Pixel pixel = Pixel::float32; // as stored; other types (32-bit integers, double) count as float32
    std::vector<std::string> channel_names;
    std::vector<ImageAttribute> attributes;
};

// The largest image that decode_image accepts: width × height × channels.
inline constexpr std::size_t max_decoded_values = limit("decoded-values").value;

// The size of a picture in pixels.
struct PictureDimensions {
    int width = 0;
    int height = 0;
    int channels = 0;

    // As they are multiplied: no overflow.
    [[nodiscard]] double values() const { return static_cast<double>(width) * height * channels; }
};

// What a file announces, without its pixels. Fails (malformed) on bytes without a valid head of a format here.
Result<PictureDimensions> picture_dimensions(std::string_view bytes);

// Fails (malformed) on bytes that are not a complete file of a format here, and on more than `max_values` values. A
// JPEG with a truncated end may pass, filled up with grey.
Result<DecodedImage> decode_image(std::string_view bytes, std::size_t max_values = max_decoded_values);

} // namespace gonio::media
#pragma GCC visibility pop
