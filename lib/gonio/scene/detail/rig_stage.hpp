// The stage of a rig: by name, or of surfaces of one's own.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/detail/rig_stream.hpp>
#include <gonio/scene/stage.hpp>

#include <span>
#include <string>
#include <string_view>

namespace gonio::detail {

// From the value of the rig's key "stage"; `source` names the rig in messages. A stage of surfaces has a camera that
// looks at its solids, or at its panels where it has no solids, from a place from where they can be seen.
Result<Stage> read_rig_stage(const RigJson& json, const std::string& source);

// The keys of such a stage, of a surface, and of the primitive that a surface names by its key; empty for none.
std::span<const std::string_view> rig_stage_keys();
std::span<const std::string_view> rig_surface_keys();
std::span<const std::string_view> rig_primitive_keys(std::string_view primitive);

} // namespace gonio::detail
