// The stage of a rig: a named one, or one with custom surfaces.
#pragma once

#include <gonio/base/file_scope.hpp>
#include <gonio/base/result.hpp>
#include <gonio/scene/detail/rig_stream.hpp>
#include <gonio/scene/stage.hpp>

#include <span>
#include <string>
#include <string_view>

namespace gonio::detail {

// What reading needs from the rig: its name in messages, the files that it may name, and where remarks go.
struct RigContext {
    const std::string& source;
    FileScope& files;
    Diagnostics& diagnostics;
};

// Reads what a surface emits, at `path` of the rig.
Result<SurfaceEmission> read_emission(const Json& json, const RigContext& rig, const std::string& path);

// Reads the value of the rig's key "stage". A stage with custom surfaces gets a
// camera that looks at its solids, or at its rectangles if it has no solids, from a position from which they are
// visible.
Result<Stage> read_rig_stage(const Json& json, const RigContext& rig);

// The keys of such a stage, of a surface, and of the primitive that a surface's key names; empty if there is none.
std::span<const std::string_view> rig_stage_keys();
std::span<const std::string_view> rig_surface_keys();
std::span<const std::string_view> rig_primitive_keys(std::string_view primitive);

} // namespace gonio::detail
