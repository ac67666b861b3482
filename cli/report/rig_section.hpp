// The part of a report about a rig: its picture, its lights, and the illuminance on the floor.
#pragma once

#include "../json_text.hpp"
#include "pictures.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

struct RigPart {
    std::string section;
    Json report; // of the rig, for --json
    std::optional<Error> error;
    Diagnostics diagnostics;
    std::vector<std::string> files; // that it names, and the rig itself
    bool has_picture = false;
    // For the interactive page: the rig's text, and the profiles that it names, by the names that it gives them.
    std::string text;
    std::vector<std::pair<std::string, std::string>> profiles;
};

struct RigPartOptions {
    bool has_picture = false;
    bool keeps_bytes = false;
};

// The rig of --rig, lit as `request` says. A rig that cannot be read has a part that says so, and `error`.
RigPart rig_part(const std::string& rig, const Arguments& arguments, const PreviewRequest& request,
                 const RigPartOptions& options, const Console& console);

} // namespace gonio::cli
