// Input profiles: files, standard input, lists of files; and how to read them.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/resolve.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "smooth_step.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

inline constexpr std::array profile_input_options{
    Option{"--from", "FORMAT", "read as ies, ldt, tm33 or gldf instead of recognising the format", "formats"},
    Option{"--lamp-set", "N", "EULUMDAT: use this one of the alternative lamp sets (1)"},
    Option{"--tilt", "DEG", "IES with TILT factors: mounting tilt of the lamp, for example 30deg (0deg)"},
    Option{"--azimuth", "TRADITION",
           "azimuth convention, ies or eulumdat: rotates files of the other one by 90° (as written)"},
    Option{"--variant", "NAME", "GLDF: the photometry of this variant, by identifier or name (the first)"},
    Option{"--emitter", "NAME", "GLDF: the photometry of this emitter, by identifier or name (the first)"},
    smooth_option,
    Option{"--as-candela", "", "take the numbers of a radiometric profile (mW/sr) as candela"},
    Option{"--strict", "", "refuse files that depart from the standard"},
};

inline constexpr OptionGroup profile_input_group{"input", profile_input_options};

// The endings of profiles in a folder; other XML files have the third, too.
inline constexpr std::array<std::string_view, 5> profile_extensions{"ies", "ldt", "xml", "tm33", "gldf"};

struct ProfileInputOptions {
    ReadOptions read;
    ResolveOptions resolve;
    std::optional<double> smooth_deg; // the step
    bool photometric = false;         // refuse radiometric profiles (UNS0104), unless --as-candela
};

Result<ProfileInputOptions> profile_input(const Arguments& arguments);

// The options that differ from the defaults, for a recipe: " strict lamp-set=2 tilt=30deg"; else empty.
std::string recipe_of(const ProfileInputOptions& options);

// The positional words with every @LIST replaced by the file names in it, one per line, and every folder by the
// profiles below it, sorted by name; XML files in a folder that are not TM-33 are left out. Fails (io) if a list or a
// folder cannot be read and (usage) if there is no word at all, or no profile in a folder.
Result<std::vector<std::string>> input_files(const Arguments& arguments);

// A file with its bytes, as read and as resolved; "-" is stdin.
struct LoadedProfile {
    std::string bytes;
    Profile profile;
    Web web;
    Diagnostics diagnostics; // of reading, resolving and smoothing
};

// What a luminaire is called: its name, or else its catalogue number; empty if the file has neither.
std::string_view luminaire_name(const ProfileHeader& header);

Result<LoadedProfile> load(const std::string& file, const ProfileInputOptions& options);

// The same for a file's bytes that were read already.
Result<LoadedProfile> load_bytes(std::string bytes, const std::string& file, const ProfileInputOptions& options);

} // namespace gonio::cli
