// The contract between the core and gonio-color.so: plain types, one table of functions, no exceptions.
//
// A function that can fail returns a Status (module_abi.hpp). Text that a function returns lives as long as its
// configuration. Change `color_version` whenever anything here or there changes.
#pragma once

#include <gonio/media/detail/module_abi.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::media::abi {

inline constexpr std::uint32_t color_version = 3;

struct ColorConfig;    // opaque
struct ColorProcessor; // opaque; does not need its configuration to stay open

// The purpose of a colour space.
enum SpaceKind : std::int32_t { space_unknown = 0, space_scene = 1, space_display = 2, space_data = 3 };

struct ColorModule {
    std::uint32_t version; // color_version; always the first member

    // `path` null or empty: the built-in configuration.
    int (*open_config)(const char* path, ColorConfig** config, char* message);
    void (*close_config)(ColorConfig* config);

    // Names by index in the configuration's order; null past the end.
    const char* (*display_at)(const ColorConfig* config, std::size_t index);
    const char* (*view_at)(const ColorConfig* config, const char* display, std::size_t index);
    const char* (*space_at)(const ColorConfig* config, std::size_t index);
    const char* (*default_display)(const ColorConfig* config);
    const char* (*default_view)(const ColorConfig* config, const char* display);
    // The colour space for a name, alias or role; null when there is none.
    const char* (*find_space)(const ColorConfig* config, const char* name);

    std::int32_t (*space_kind)(const ColorConfig* config, const char* name); // SpaceKind

    // The transform of RGB as rows of a matrix, in double, if it is a matrix and nothing else; `is_matrix` tells
    // whether.
    int (*space_matrix)(const ColorConfig* config, const char* source, const char* target, double matrix[9],
                        std::int32_t* is_matrix, char* message);

    int (*display_processor)(const ColorConfig* config, const char* source, const char* display, const char* view,
                             ColorProcessor** processor, char* message);
    int (*space_processor)(const ColorConfig* config, const char* source, const char* target,
                           ColorProcessor** processor, char* message);
    // Packed pixels of 3 or 4 channels, in place. Several threads may call this at once with one processor.
    int (*apply)(const ColorProcessor* processor, float* pixels, std::size_t pixel_count, std::int32_t channels,
                 char* message);
    void (*close_processor)(ColorProcessor* processor);
};

} // namespace gonio::media::abi
