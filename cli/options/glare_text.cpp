#include "glare_text.hpp"

#include <gonio/base/codes/result.hpp>

#include <fmt/format.h>

namespace gonio::cli {

std::string ugr_text(const GlareRating& rating) {
    if (!rating.ugr) return "none";
    return *rating.ugr < 10.0 ? std::string("below 10") : fmt::format("{:.1f}", *rating.ugr);
}

void add_glare_remarks(bool lacks_rating, bool has_too_large, Diagnostics& diagnostics) {
    if (has_too_large)
        diagnostics.push_back(result_diagnostic("RES0601", "a luminaire fills more than 0.1 sr of an observer's view",
                                                "take its UGR as a rough figure"));
    if (lacks_rating)
        diagnostics.push_back(
            result_diagnostic("RES0602", "some observers have no UGR",
                              "a light has no size or states no luminous opening, or none shines to the eye"));
}

} // namespace gonio::cli
