// The sidecar of a texture: a JSON object of schema gonio.texture/1 that says what its texels mean.
#pragma once

#include <gonio/bake/texture.hpp>

#include <string>
#include <string_view>

namespace gonio {

struct TextureSource {
    std::string file;   // as the user named it
    std::string sha256; // of its bytes
};

// `pixel` names what the picture file stores ("float"). Keys in a fixed order, two spaces of indentation, a newline at
// the end; numbers read back as the same doubles.
std::string texture_sidecar(const Texture& texture, const TextureSource& source, std::string_view pixel);

} // namespace gonio
