// Limits: the greatest sizes, counts and depths, in one table. Files from others may be hostile: anything larger,
// deeper or more numerous is rejected before work is done, and the message names the limit.
//
// Code takes its numbers from here. `gonio list limits` prints the table, and LIMITS.md is printed from it. A name that
// is not in the table does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A row of the table.
struct Limit {
    std::string_view name;   // "profile-bytes"
    std::uint64_t value = 0; // the greatest value; bytes of files exceed a size_t of 32 bits
    std::string_view unit;   // "bytes", "pixels", "levels", …
    std::string_view says;   // what it limits
};

// Units of the table.
inline constexpr std::uint64_t kibibyte = std::uint64_t{1} << 10U;
inline constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

// The table.
inline constexpr std::array limits{
    // Files
    Limit{"profile-bytes", 16 * mebibyte, "bytes", "a photometric profile; the largest known has 1.24 MB"},
    Limit{"tilt-bytes", mebibyte, "bytes", "a file of TILT factors beside a profile"},
    Limit{"spectrum-bytes", 16 * mebibyte, "bytes", "a spectrum, CSV or TM-33"},
    Limit{"table-bytes", 256 * mebibyte, "bytes", "a CSV table: candela of make, points of probe"},
    Limit{"rig-bytes", 1024 * mebibyte, "bytes", "a rig; a million lights take about 150 MB"},
    Limit{"manifest-bytes", 128 * mebibyte, "bytes", "a manifest"},
    Limit{"record-bytes", 16 * mebibyte, "bytes", "a sidecar of bake, an asset record of import"},
    Limit{"output-bytes", 4096 * mebibyte, "bytes", "a file that gonio wrote and reads again: -u, manifests"},
    Limit{"list-bytes", 64 * mebibyte, "bytes", "a list of file names, @LIST"},
    Limit{"file-bytes", 256 * mebibyte, "bytes", "any other file, and stdin"},
    // Archives: GLDF, GDTF, USDZ
    Limit{"archive-bytes", 256 * mebibyte, "bytes", "a GLDF, as a file; scenes have the limit scene-bytes"},
    Limit{"archive-entries", 10000, "files", "an archive"},
    Limit{"archive-entry-bytes", 256 * mebibyte, "bytes", "one file of an archive, unpacked"},
    Limit{"archive-unpacked-bytes", 1024 * mebibyte, "bytes", "all files of an archive together, unpacked"},
    Limit{"archive-ratio", 200, "times", "how far a file of more than 1 MiB in an archive unpacks"},
    Limit{"archive-xml-bytes", 16 * mebibyte, "bytes", "product.xml of GLDF, description.xml of GDTF"},
    // JSON
    Limit{"json-depth", 64, "levels", "nested arrays and objects, except in a rig"},
    Limit{"json-keys", 1024, "keys", "one JSON object"},
    Limit{"json-values", std::size_t{1} << 23U, "values", "one JSON text, except a rig"},
    Limit{"xml-depth", 64, "levels", "nested elements; TM-33 has 8"},
    // Rigs
    Limit{"rig-depth", 16, "levels", "nested arrays and objects, in one light, group or other member of a rig"},
    Limit{"rig-values", std::size_t{1} << 16U, "values", "one light, group or other member of a rig"},
    Limit{"rig-lights", std::size_t{1} << 24U, "lights", "a rig"},
    Limit{"rig-array", std::size_t{1} << 18U, "lights", "what the arrays, lists of positions and groups of a rig make"},
    Limit{"rig-smooth", std::size_t{1} << 24U, "intensities", "the smooth tables of a rig, all together"},
    Limit{"stage-surfaces", 256, "surfaces", "a rig's stage"},
    Limit{"import-lights", 100000, "lights", "a rig that import writes for a target"},
    // Scenes of other programs
    Limit{"scene-bytes", 1024 * mebibyte, "bytes", "a scene of another program"},
    Limit{"scene-nodes", std::size_t{1} << 24U, "nodes", "such a scene"},
    Limit{"scene-depth", 256, "levels", "nested blocks of such a scene; the tree of glTF has no limit"},
    Limit{"scene-layers", 1000, "layers", "files of USD that one scene names"},
    Limit{"scene-lights", std::size_t{1} << 20U, "lights", "such a scene"},
    // Text
    Limit{"kind-bytes", 16 * kibibyte, "bytes", "the text of a shape, a material or another KIND:key=value,…"},
    Limit{"kind-keys", 64, "keys", "one such text"},
    // Pictures
    Limit{"picture-pixels", std::size_t{1} << 28U, "pixels", "a picture or texture, of every command that makes one"},
    Limit{"picture-side", 16384, "pixels", "the width or height of a picture"},
    Limit{"texture-side", 32768, "pixels", "the width or height of a texture of bake"},
    Limit{"auto-texture-side", 4096, "pixels", "the side of a texture that bake -s auto finds"},
    Limit{"layered-values", std::size_t{1} << 27U, "values", "width × height × channels of a picture in layers"},
    Limit{"decoded-values", std::size_t{1} << 28U, "values", "width × height × channels of a picture that is read"},
    Limit{"light-image-values", std::size_t{1} << 25U, "values",
          "width × height × channels of an image as a mask of a light: 3840x2160 with four channels"},
    Limit{"environment-bytes", 1024 * mebibyte, "bytes", "an image of the light from all around, as a file"},
    Limit{"environment-values", std::size_t{1} << 27U, "values",
          "width × height × channels of such an image: 8192x4096 with four channels"},
    // Counts
    Limit{"polygon-corners", 1024, "corners", "the area of a grid of probe"},
    Limit{"points", std::size_t{1} << 24U, "points", "one run of probe"},
    Limit{"sweep-values", 1024, "values", "one sweep of preview"},
    Limit{"sweep-pictures", 1024, "pictures", "the sweeps of preview together"},
    Limit{"compared-methods", 8, "methods", "a comparison of preview"},
    Limit{"cct-steps", 100000, "rows", "a table of cct"},
    Limit{"sheet-files", 4096, "files", "data sheets in one file; each takes some 200 kB of memory"},
};

// The row with that name.
consteval const Limit& limit(std::string_view name) {
    for (const Limit& known : limits)
        if (known.name == name) return known;
    throw "no such limit"; // not a constant expression
}

// "16 MiB", "67108864 pixels".
std::string amount_of(const Limit& limit);

// "16 MiB, the limit 'profile-bytes'": how messages name a limit.
std::string to_text(const Limit& limit);

// The hint that goes with it.
inline constexpr std::string_view limits_hint = "'gonio list limits' describes each limit";

} // namespace gonio
#pragma GCC visibility pop
