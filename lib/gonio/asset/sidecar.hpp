// The sidecar of a texture: a JSON object of schema gonio.texture/1 that says what its texels mean
// (texture.schema.json describes it).
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

// What a texture's files are, beyond its texels.
struct TextureFile {
    std::string pixel = "float";         // what the picture file stores of a channel
    int channels = 1;                    // the same value in each
    const Engine* engine = nullptr;      // whose texture it is; nullptr: nobody's
    std::vector<std::string> face_files; // layout cube: the names of the six, +X −X +Y −Y +Z −Z
    std::string recipe;                  // the options it was made with, to tell whether it is up to date
    std::vector<FileRecord> files = {};  // the picture, or the six, as they were written
};

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles.
std::string texture_sidecar(const Texture& texture, const TextureSource& source, const TextureFile& file);

// The sidecar's fields one by one, those of objects behind their name and a dot: "frame.aim".
struct SidecarField {
    std::string name;
    std::variant<std::string, double> value;
};
std::vector<SidecarField> sidecar_fields(std::string_view sidecar);

// What a sidecar says that a texture was made from and into; nothing when it is not a sidecar, or of a gonio that did
// not record its files.
struct TextureRecord {
    std::string source_sha256;
    std::string recipe;
    std::vector<FileRecord> files;
};
std::optional<TextureRecord> read_sidecar(std::string_view json);

} // namespace gonio
