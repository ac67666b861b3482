// Reading photometric files: bytes → Profile. Of a GLDF (gonio/profile/gldf.hpp) one of its photometric files is read.
//
// Tolerant by default: anything that needs no guess is read, and a diagnostic reports what was unusual. `strict` turns
// the departures from the standard into errors. A count announced in a file is never allocated before that many values
// have been seen. Fails with `malformed`; every diagnostic has a code of gonio/base/codes/profile.hpp and carries file,
// line and column (whole-file remarks: line 0). Texts keep their bytes (text_encoding.hpp shows them); only UTF-16 is
// converted to UTF-8, and lines and columns then refer to the UTF-8 text.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// The formats that are read.
enum class ProfileFormat { ies, ldt, tm33 };

const char* to_text(ProfileFormat format); // "IES", "LDT", "TM-33": as in reports

// Whether the first 4096 bytes of a text are XML with the root element of TM-33. This distinguishes
// profiles from other XML files in a folder. In any encoding that read_profile accepts.
bool begins_as_tm33(std::string_view bytes);

// Returns the bytes of the file `name` in the folder of a profile.
using ReadBeside = std::function<Result<std::string>(const std::string& name)>;

// Which profile of a GLDF: a variant and an emitter, by identifier or name; the first where the text is empty.
struct GldfChoice {
    std::string variant;
    std::string emitter;
};

// How a profile is read.
struct ReadOptions {
    std::optional<ProfileFormat> format =
        {}; // default: recognised from the bytes; the name's extension decides if they are ambiguous
    bool strict = false;
    // Called for the factors of TILT=<name>, with plain names only: no separator, drive or "..". Empty: no other file
    // is read, and a profile that names one is read without its factors.
    ReadBeside read_beside = {};
    GldfChoice choice = {};
};

// Reads regular files and links to them in the folder of `path`, but does not follow a link that leads out of it. A
// name that does not exist is tried in lower and in upper case: many come from systems that ignore case.
ReadBeside reader_beside(const std::string& path);

// `source` names the bytes in diagnostics; its extension helps to recognise the format. Fails beyond profile-bytes.
Result<Profile> read_profile(std::string_view bytes, const std::string& source, const ReadOptions& options = {});

// How large such a file may be: archive-bytes for a name that ends in .gldf, else profile-bytes.
const Limit& limit_of_profile(std::string_view path);

// Reads the file at `path` first; fails with `io` if that fails or if the file exceeds limit_of_profile(). Without
// options.read_beside, files beside it are read as by reader_beside(path).
Result<Profile> read_profile_file(const std::string& path, const ReadOptions& options = {});

} // namespace gonio
#pragma GCC visibility pop
