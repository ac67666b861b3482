// The sidecar of a texture: a JSON object of schema gonio.texture/1 that states the meaning of its texels (described by
// texture.schema.json).
#pragma once

#include <gonio/asset/file_record.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/bake/texture.hpp>
#include <gonio/base/result.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio {

struct TextureSource {
    std::string file;   // as the user named it
    std::string sha256; // of its bytes
};

// Properties of a texture's files, beyond its texels.
struct TextureFile {
    std::string pixel = "float";         // what the picture file stores per channel
    int channels = 1;                    // the same value in each
    const Engine* engine = nullptr;      // the engine that the texture is for; nullptr: none
    std::vector<std::string> face_files; // layout cube: the names of the six, +X −X +Y −Y +Z −Z
    std::string recipe;                  // the options that the texture was made with, to tell whether it is up to date
    std::vector<FileRecord> files = {};  // the picture, or the six, as they were written
};

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles.
std::string texture_sidecar(const Texture& texture, const TextureSource& source, const TextureFile& file);

// The sidecar's fields one by one; members of an object are named with its name and a dot: "frame.aim".
struct SidecarField {
    std::string name;
    std::variant<std::string, double> value;
};
std::vector<SidecarField> sidecar_fields(std::string_view sidecar);

// What a texture was made from and which files it became, as its sidecar records it; nothing if the text is not a
// sidecar, or was written by a version of gonio that did not record its files.
struct TextureRecord {
    std::string source_sha256;
    std::string recipe;
    std::vector<FileRecord> files;
};
std::optional<TextureRecord> read_sidecar(std::string_view json);

} // namespace gonio
