// UGR of eyes at the probed points that look along the points' normals.
#pragma once

#include <gonio/figures/glare.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>

#include <optional>
#include <span>
#include <vector>

namespace gonio::cli {

struct GlareRating {
    std::optional<double> ugr; // empty: nothing glares, or a light without a size lies ahead
    Nits background;
    std::vector<GlareShare> lights; // times what the stage leaves of each
    bool has_point = false;         // a light without a size
    bool has_too_large = false;     // above 0.1 sr
};

// `visible` has the share of each light that reaches the eye, `background_lx` what arrives there from all else.
GlareRating glare_rating(std::span<const Light> lights, const Receiver& eye, std::span<const double> visible,
                         double background_lx);

} // namespace gonio::cli
