// Reading photometric files: bytes → Profile.
//
// Tolerant by default: what can be understood without a guess is read and a diagnostic says what was odd. `strict`
// turns the departures from the standard into errors. A count that a file announces is never allocated before that
// many values have been seen. Fails with `malformed`; every diagnostic has a code of gonio/base/codes/profile.hpp and
// carries file, line and column (whole-file remarks: line 0). Texts keep their bytes (text_encoding.hpp shows them);
// only UTF-16 is converted, and its lines and columns are those of the UTF-8 it became.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace gonio {

enum class ProfileFormat { ies, ldt, tm33 };

const char* to_text(ProfileFormat format); // "IES", "LDT", "TM-33": as in reports

// Whether a text is XML whose outermost element is TM-33's, as its first bytes tell (4096 are looked at): what tells
// profiles from the other XML files in a folder. In any encoding that read_profile takes.
bool begins_as_tm33(std::string_view bytes);

// Gives the bytes of the file `name` that stands beside a profile.
using ReadBeside = std::function<Result<std::string>(const std::string& name)>;

struct ReadOptions {
    std::optional<ProfileFormat> format =
        {}; // default: recognised from the bytes, the name's extension deciding a draw
    bool strict = false;
    // Asked for the factors of TILT=<name>, with plain names only: nothing that has a separator, a drive or "..".
    // Empty: no other file is read, and a profile that names one is read without its factors.
    ReadBeside read_beside = {};
};

// Reads regular files and links to such in the folder that holds `path`, and nothing that a link leads out of it. A
// name that is not there is tried in small and in capital letters: many were written where case made no difference.
ReadBeside reader_beside(const std::string& path);

// `source` names the bytes in diagnostics, and its extension helps to recognise the format.
Result<Profile> read_profile(std::string_view bytes, const std::string& source, const ReadOptions& options = {});

// Reads the file at `path` first; fails with `io` when that fails and beyond the limit profile-bytes. Without
// options.read_beside, files beside it are read as by reader_beside(path).
Result<Profile> read_profile_file(const std::string& path, const ReadOptions& options = {});

} // namespace gonio
