// Reading photometric files: bytes → Profile.
//
// Tolerant by default: what can be understood without a guess is read and a diagnostic says what was odd. `strict`
// turns the departures from the standard into errors. A count that a file announces is never allocated before that
// many values have been seen. Fails with `malformed`, or `unsupported` (TM-33, TILT factors in another file); every
// diagnostic has a code of gonio/profile/codes.hpp and carries file, line and column (whole-file remarks: line 0).
// Cost: about 2 ns a byte for IES, 4 for EULUMDAT.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace gonio {

enum class ProfileFormat { ies, ldt };

const char* to_text(ProfileFormat format); // "IES", "LDT": as in reports

struct ReadOptions {
    std::optional<ProfileFormat> format; // default: recognised from the bytes, the name's extension deciding a draw
    bool strict = false;
};

// `source` names the bytes in diagnostics, and its extension helps to recognise the format.
Result<Profile> read_profile(std::string_view bytes, const std::string& source, const ReadOptions& options = {});

// Reads the file at `path` first; fails with `io` when that fails.
Result<Profile> read_profile_file(const std::string& path, const ReadOptions& options = {});

} // namespace gonio
