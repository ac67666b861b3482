#include "glare_rating.hpp"

#include <cstddef>
#include <numbers>

namespace gonio::cli {

GlareRating glare_rating(std::span<const Light> lights, const Receiver& eye, std::span<const double> visible,
                         double background_lx) {
    GlareRating rating;
    rating.background = Nits(background_lx / std::numbers::pi);
    double sum = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        std::optional<GlareShare> share = glare_share(lights[i], {eye.position, eye.normal});
        rating.has_point = rating.has_point || !share;
        rating.lights.push_back(share.value_or(GlareShare()));
        GlareShare& seen = rating.lights.back();
        seen.sum *= visible[i];
        sum += seen.sum;
        rating.has_too_large = rating.has_too_large || (seen.is_too_large && seen.sum > 0.0);
    }
    if (!rating.has_point && sum > 0.0 && background_lx > 0.0)
        rating.ugr = unified_glare_rating(sum, rating.background);
    return rating;
}

} // namespace gonio::cli
