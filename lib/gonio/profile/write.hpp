// Writing photometric files: what a Profile holds → bytes. Numbers are written as the shortest text that reads back
// as the same double, without an exponent from 1e-9 to 1e15; lines end in CR LF as LM-63 and EULUMDAT ask. What was
// read and is written reads back as the same file, field by field. Numbers must be finite, texts hold no line ends (but
// the '\n' before the lines of [MORE]), and counts agree with the lists: nothing is checked here.
#pragma once

#include <gonio/profile/profile.hpp>

#include <string>

namespace gonio {

// In the layout that the common loaders read: ten numbers on one line, three on the next, each angle list and each
// plane beginning a line, single spaces. Lists are broken at 132 characters up to 1995, at 256 since. An empty
// version_line becomes the standard one of `version`; 1986 has none.
std::string write_ies(const IesFile& file);

std::string write_ldt(const LdtFile& file);

} // namespace gonio
