// What is unusual about ratings of glare.
#pragma once

#include <gonio/base/diagnostics.hpp>

namespace gonio::cli {

// `lacks_rating`: some eye has no UGR; `has_too_large`: a luminaire fills more than 0.1 sr of some eye's view.
void add_glare_remarks(bool lacks_rating, bool has_too_large, Diagnostics& diagnostics);

} // namespace gonio::cli
