// The contract between the core and gonio-image.so: plain types, one table of functions, no exceptions.
//
// A function returns a Status (module_abi.hpp). Everything that a reply points to belongs to its `owner` and lives
// until release(owner). Change `image_version` whenever anything here or there changes.
#pragma once

#include <gonio/media/detail/module_abi.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::media::abi {

inline constexpr std::uint32_t image_version = 4;

enum PixelKind : std::int32_t { pixel_uint8 = 0, pixel_uint16 = 1, pixel_half = 2, pixel_float = 3 };
enum AttributeKind : std::int32_t { attribute_text = 0, attribute_floats = 1, attribute_ints = 2 };

struct Attribute {
    const char* name;
    std::int32_t kind;        // AttributeKind
    std::size_t count;        // of numbers
    const char* text;         // attribute_text
    const float* floats;      // attribute_floats
    const std::int32_t* ints; // attribute_ints
};

// A loop over pieces of work on several threads, which the module is lent. run() calls work(data, i) for each i below
// `count`, in any order; work must not throw. False if it ended before all was done; then the request fails.
struct ParallelLoop {
    void* loop;
    bool (*run)(void* loop, std::size_t count, void (*work)(void* data, std::size_t i), void* data);
};

struct EncodeRequest {
    const char* format; // OpenImageIO's name for the writer: "openexr"
    std::int32_t width;
    std::int32_t height;
    std::int32_t channels;
    const float* pixels;              // width × height × channels
    std::int32_t pixel;               // PixelKind
    const char* const* channel_names; // `channels` of them
    const Attribute* attributes;
    std::size_t attribute_count;
    ParallelLoop parallel;
};

struct EncodeReply {
    const unsigned char* bytes;
    std::size_t size;
    void* owner;
    char message[message_bytes];
};

struct DecodeRequest {
    const char* format;
    const unsigned char* bytes;
    std::size_t size;
    std::size_t max_values; // upper limit of width × height × channels; beyond it only these three are in the reply
};

struct DecodeReply {
    std::int32_t width;
    std::int32_t height;
    std::int32_t channels;
    std::int32_t pixel; // PixelKind, as stored
    const float* pixels;
    const char* const* channel_names;
    const Attribute* attributes;
    std::size_t attribute_count;
    void* owner;
    char message[message_bytes];
};

struct ImageModule {
    std::uint32_t version; // image_version; always the first member
    int (*encode)(const EncodeRequest* request, EncodeReply* reply);
    void (*release_encoded)(void* owner);
    int (*decode)(const DecodeRequest* request, DecodeReply* reply);
    void (*release_decoded)(void* owner);
};

} // namespace gonio::media::abi
