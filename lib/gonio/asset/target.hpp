// Targets: the programs that a measured light is delivered to, each with its own files, units and conventions.
#pragma once

#include <gonio/asset/measured_light.hpp>
#include <gonio/bake/bake.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

// A texture that a target reads beside its text: baked from the light's web, and stored by who writes the files.
struct AssetTexture {
    BakeOptions bake;
    bool flip_rows = false; // the last row first
};

// One file of an asset.
struct AssetFile {
    std::string name;  // in the target's folder
    std::string bytes; // where there is no texture
    std::optional<AssetTexture> texture;
};

struct Target {
    std::string_view name;    // "gltf"
    std::string_view summary; // for lists
    // How to use what is written, what was checked in the program itself and what could not be: a line each.
    std::string_view use, verified, unverified;
    std::vector<AssetFile> (*files)(const MeasuredLight& light);
};

// By name.
std::span<const Target> targets();

// Fails (usage) on an unknown name.
Result<const Target*> find_target(std::string_view name);

// The target's README: use, what was verified, what could not be.
std::string target_readme(const Target& target);

} // namespace gonio
