// Writing photometric files: the content of a Profile → bytes. Numbers are written as the shortest text that reads back
// as the same double, without an exponent from 1e-30 to 1e15. Lines end in CR LF as LM-63 and EULUMDAT require. A file
// that was read and then written reads back as the same file, field by field. Numbers must be finite, texts must not
// contain line ends (except the '\n' before the lines of [MORE]), and counts must agree with the lists: nothing is
// checked here.
#pragma once

#include <gonio/profile/profile.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// In the layout that common loaders read: ten numbers on one line, three on the next, each angle list and each plane
// beginning a line, single spaces. Lists are broken at `longest_line` characters, line end included; 0: at 132 for
// editions up to 1995, at 256 for later ones. An empty version_line becomes the standard one of `version`; 1986 has
// none.
std::string write_ies(const IesFile& file, std::size_t longest_line = 0);

// The bytes of a EULUMDAT file.
std::string write_ldt(const LdtFile& file);

// XML in UTF-8, indented. Elements that gonio has no field for stay where they were, new ones go to the schema's place;
// a document with unchanged fields reads back as the same file.
std::string write_tm33(const Tm33File& file);

// The bytes of a profile of any format.
std::string write_profile(const Profile& profile);

// LM-63 with TILT=INCLUDE and the factors that were read from another file, for where that file does not go; nothing if
// the profile needs none.
std::optional<std::string> write_with_tilt_factors(const Profile& profile);

// The ending of a file of the profile's format: "ies", "ldt", "xml".
std::string_view profile_ending(const Profile& profile);

} // namespace gonio
#pragma GCC visibility pop
