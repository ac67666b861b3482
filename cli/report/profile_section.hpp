// The part of a report about one profile: a row of the table of all, and a section that prints on a page of its own.
#pragma once

#include "../json_text.hpp"
#include "../options/profile_input.hpp"
#include "pictures.hpp"

#include <optional>
#include <string>

namespace gonio::cli {

struct ProfilePart {
    std::string row;
    std::string section;
    Json report;                      // of the profile, for --json
    std::optional<std::string> bytes; // of the file, if asked for and if it could be read
    bool has_picture = false;
};

struct ProfilePartOptions {
    ProfileInputOptions input;
    double mounting_height_m = 3.0;          // of isolux and cone
    const PreviewRequest* picture = nullptr; // nullptr: none
    ProfileStages* stages = nullptr;
    bool keeps_bytes = false;
};

// `number` from 1 names the section; `label` is the short name of the file. What there is to say about the profile goes
// to `diagnostics`. If it cannot be read the part says so, and `error` is why.
ProfilePart profile_part(const std::string& file, const std::string& label, std::size_t number,
                         const ProfilePartOptions& options, const Console& console, Diagnostics& diagnostics,
                         std::optional<Error>& error);

// The part of a profile that was not looked at.
ProfilePart failed_part(const std::string& file, const std::string& label, std::size_t number, const Error& error,
                        std::string_view bytes);

} // namespace gonio::cli
