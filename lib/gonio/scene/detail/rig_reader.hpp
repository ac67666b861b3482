// The two ways in which read_rig() reads a rig. They give the same rig.
#pragma once

#include <gonio/scene/rig.hpp>

namespace gonio::detail {

// Every light by a tree of its values; a failure has the place of the mistake.
Result<Rig> read_rig_by_values(std::string_view text, const std::string& source, const std::string& folder,
                               const RigReadOptions& options = {});

// Lights that are written plainly without such trees, on several threads (rig_plain.hpp), the others as above. A
// failure says only that the rig must be read by its values.
Result<Rig> read_rig_plainly(std::string_view text, const std::string& source, const std::string& folder,
                             const RigReadOptions& options = {});

} // namespace gonio::detail
