// Writing a luminaire that a command has made as a profile.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/web/luminaire.hpp>
#include <gonio/web/to_profile.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../json_text.hpp"
#include "output.hpp"

#include <array>
#include <string>

namespace gonio::cli {

inline constexpr std::array profile_output_options{
    Option{"-o,--output", "FILE", "the profile to write; '-' is stdout (with --to)"},
    Option{"--to", "FORMAT", "format of the profile, if the name does not show it", "formats"},
    Option{"--dialect", "NAME", "IES dialect: lm-63-1995, lm-63-2002, lm-63-2019, portable (lm-63-2002)", "dialects"},
    durable_option,
};

inline constexpr OptionGroup profile_output_group{"output", profile_output_options};

// The target given by --to, --dialect or the output's name. Fails (usage) if none of them gives a target, and if they
// disagree.
Result<ProfileTarget> profile_target(const Arguments& arguments, const std::string& output);

struct ProfileOutput {
    std::string file;
    ProfileTarget target = ProfileTarget::lm63_2002;
};

// Fails (usage) without -o, on an unknown format or dialect, and if neither --to nor the name gives the format.
Result<ProfileOutput> profile_output(const Arguments& arguments);

// The written profile, as it reads back.
struct WrittenProfile {
    double flux_lm = 0.0;
    double peak_cd = 0.0;
    double max_error_cd = 0.0; // of the bytes, against the luminaire
    Diagnostics diagnostics;   // anything the format cannot store
};

// Writes the luminaire. Fails (io) if the file cannot be written, as to_profile() does, and (internal) if the bytes
// cannot be read again.
Result<WrittenProfile> write_luminaire(const Luminaire& luminaire, const ProfileOutput& output);

} // namespace gonio::cli
