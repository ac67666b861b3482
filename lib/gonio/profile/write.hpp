// Writing photometric files: what a Profile holds → bytes. Numbers are written as the shortest text that reads back
// as the same double, lines end in CR LF as LM-63 and EULUMDAT ask.
#pragma once

#include <gonio/profile/profile.hpp>

#include <string>

namespace gonio {

// In the layout that the common loaders read: ten numbers on one line, three on the next, each angle list and each
// plane beginning a line, single spaces.
std::string write_ies(const IesFile& file);

std::string write_ldt(const LdtFile& file);

} // namespace gonio
