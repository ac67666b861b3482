// Ratings of glare in words, and what is unusual about them.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/figures/glare.hpp>

#include <string>

namespace gonio::cli {

// "17.2", "below 10", "none"
std::string ugr_text(const GlareRating& rating);

// `lacks_rating`: some eye has no UGR; `has_too_large`: a luminaire fills more than 0.1 sr of some eye's view.
void add_glare_remarks(bool lacks_rating, bool has_too_large, Diagnostics& diagnostics);

} // namespace gonio::cli
