// Engines by name: the texture that each one reads, with its frame, size and sampling rule.
//
// Collected from the engines' published sources and documentation; each rule names its source. An engine's texture is
// an ordinary one (gonio/bake/bake.hpp) made with these options, which its sidecar states.
#pragma once

#include <gonio/bake/bake.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How a program reads a texture, as `gonio list engines` shows it.
struct Engine {
    std::string_view name;    // "unity-spot"
    std::string_view summary; // for lists
    std::string_view rule;    // for the sidecar: how the engine reads the texture
    BakeOptions bake;         // everything except cone and threads
    int channels = 1;         // the same value in each
    std::string_view format;  // of the file: "exr", "png"
    // The engine's light space, for the sidecar: where the aim and C0 point.
    std::string_view aim;
    std::string_view c0;
    std::string_view handedness;
};

// All of them.
std::span<const Engine> engines();

// Fails (usage) on an unknown name.
Result<const Engine*> find_engine(std::string_view name);

} // namespace gonio
#pragma GCC visibility pop
