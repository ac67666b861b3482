// The formats of scenes whose lights gonio reads, and reading them.
//
// The content decides what a file is. Scenes are hostile input: a broken one fails with a code, the place and the
// reason; nothing is allocated for a number that a file announces, and trees are walked without recursion.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/interchange/found_light.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// What a scene does not say about itself.
struct SceneReadOptions {
    std::optional<Meters> unit; // length of the scene's unit; absent: as the file or its format says, else 1 m
    std::optional<char> up;     // 'y' or 'z': the axis that points up; absent: as the file or its format says
    std::optional<double> lumens_per_watt; // of formats that store watts; absent: as each format's reader says
    std::string variant = {}; // which of several that the file has: of GLDF a variant, of GDTF a mode; empty: the first
    std::optional<Radians> zoom = {}; // full beam angle of beams that zoom (GDTF); absent: as the file states
    // When, of values that change, in the file's time codes; absent: what the file says without a time, else the first.
    std::optional<double> time = {};
    // The bytes of another file that the scene names, relative to the scene. Fails (io). Empty: no file is read.
    std::function<Result<std::string>(const std::string& name)> read_beside = {};
};

// A format, as `gonio list scene-formats` shows it.
struct SceneFormat {
    std::string_view name;                                // "gltf"
    std::string_view summary;                             // for lists
    std::string_view endings;                             // of its files: ".gltf, .glb"
    bool (*is_content)(std::string_view bytes) = nullptr; // whether the bytes begin like such a file
    Result<FoundScene> (*read)(std::string_view bytes, const std::string& source,
                               const SceneReadOptions& options) = nullptr;
};

// By name.
std::span<const SceneFormat> scene_formats();

// Fails (usage) on an unknown name and suggests the nearest.
Result<const SceneFormat*> find_scene_format(std::string_view name);

// The format of the bytes. Fails (malformed or unsupported) if none is recognised, and names those that are.
Result<const SceneFormat*> scene_format_of(std::string_view bytes, const std::string& source);

// The lights of a scene; `format`: nullptr, recognised from the bytes. Profiles that lights name are not read. Fails
// as scene_format_of(), and (malformed or unsupported) with a code of the family SCN and the place.
Result<FoundScene> read_scene_lights(std::string_view bytes, const std::string& source,
                                     const SceneReadOptions& options = {}, const SceneFormat* format = nullptr);

// Reads the profiles of lights into their shapes, those inside the scene too, and gives lights with a profile_scale
// other than 1 their intensity. A profile that cannot be read is a remark of its light, which is then only listed.
void load_scene_profiles(FoundScene& scene, const SceneReadOptions& options);

} // namespace gonio
#pragma GCC visibility pop
