// What a GLDF says, in words and as JSON: what `gonio info` prints before its photometry.
#pragma once

#include <gonio/profile/gldf.hpp>

#include "json_text.hpp"

#include <string>

namespace gonio::cli {

// Lines in two columns, as those of a profile. Texts of the file have no control characters.
std::string gldf_text(const Gldf& gldf);

Json gldf_json(const Gldf& gldf);

} // namespace gonio::cli
