#include "glare_remarks.hpp"

#include <gonio/base/codes/result.hpp>

namespace gonio::cli {

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
