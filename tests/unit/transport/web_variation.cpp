// The bounds of how much a web changes, against the web in double along random arcs.
#include <gonio/transport/web_variation.hpp>
#include <gonio/web/web.hpp>

#include "../preview/numbers.hpp"
#include "../web/webs.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using detail::WebVariation;
using test::Numbers;
using test::steps;

Web web_of(Photometry type, Symmetry symmetry, const std::vector<double>& horizontal,
           const std::vector<double>& vertical, bool is_dark_at_the_ends) {
    Numbers numbers(static_cast<unsigned>(horizontal.size() + 7 * vertical.size()));
    const bool is_transposed = type == Photometry::b;
    std::vector<double> candela;
    for (std::size_t h = 0; h < horizontal.size(); ++h)
        for (std::size_t v = 0; v < vertical.size(); ++v) {
            double cd = numbers.between(100.0, 1000.0);
            // One value at a pole.
            const double latitude = is_transposed ? horizontal[h] : vertical[v];
            if (type == Photometry::c ? latitude == 0.0 || latitude == 180.0 : std::abs(latitude) == 90.0) cd = 500.0;
            if (type == Photometry::c && symmetry == Symmetry::none && h + 1 == horizontal.size()) cd = candela[v];
            const std::size_t longitude = is_transposed ? v : h;
            const std::size_t count = is_transposed ? vertical.size() : horizontal.size();
            if (is_dark_at_the_ends && (longitude == 0 || longitude + 1 == count)) cd = 0.0;
            candela.push_back(cd);
        }
    return Web::create(type, symmetry, horizontal, vertical, candela).value();
}

std::vector<std::pair<std::string, Web>> webs() {
    constexpr auto c = Photometry::c;
    return {{"axial", web_of(c, Symmetry::axial, {0.0}, steps(0, 180, 19), false)},
            {"quadrant", web_of(c, Symmetry::quadrant, steps(0, 90, 10), steps(0, 180, 25), false)},
            {"bilateral-0-180", web_of(c, Symmetry::bilateral_0_180, {0, 10, 35, 90, 180}, steps(0, 180, 19), false)},
            {"bilateral-90-270", web_of(c, Symmetry::bilateral_90_270, steps(90, 270, 19), steps(0, 180, 37), false)},
            {"none", web_of(c, Symmetry::none, steps(0, 360, 25), steps(0, 180, 19), false)},
            {"type B", web_of(Photometry::b, Symmetry::none, steps(-90, 90, 19), steps(-90, 90, 19), true)},
            {"type A", web_of(Photometry::a, Symmetry::none, steps(-70, 80, 16), steps(-90, 90, 19), true)}};
}

TEST(WebVariation, BoundsTheWebAlongArcs) {
    for (const auto& [name, web] : webs()) {
        const WebVariation variation(web);
        ASSERT_TRUE(variation.is_bounded()) << name;
        Numbers numbers(2);
        double steepest = 0.0; // over the bound
        double sharpest = 0.0;
        std::size_t bent = 0;
        for (int trial = 0; trial < 200000; ++trial) {
            const glm::dvec3 at = numbers.direction();
            const glm::dvec3 any = numbers.direction();
            const glm::dvec3 along = glm::normalize(any - glm::dot(any, at) * at);
            const WebVariation::Bounds& bounds = variation.at(glm::dot(at, variation.axis()));
            const double arc = WebVariation::reach_rad * std::exp(numbers.between(-5.0, 0.0));
            const auto cd = [&, &of = web](double rad) {
                return of.candela(std::cos(rad) * at + std::sin(rad) * along);
            };
            const double change = std::abs(cd(arc) - cd(0.0));
            ASSERT_LE(change, bounds.slope * arc * (1.0 + 1e-6) + 1e-6) << name << " at " << trial;
            steepest = std::max(steepest, change / (bounds.slope * arc));
            if (!(arc < bounds.bend_rad)) continue;
            ++bent;
            const double bend = std::abs(cd(arc) + cd(-arc) - 2.0 * cd(0.0));
            const double most = arc * bounds.kink + arc * arc * bounds.curve;
            ASSERT_LE(bend, most * (1.0 + 1e-6) + 1e-6) << name << " at " << trial;
            sharpest = std::max(sharpest, bend / most);
        }
        // Not much wider than needed where the web changes most.
        EXPECT_GT(steepest, 0.5) << name;
        EXPECT_GT(sharpest, 0.3) << name;
        EXPECT_GT(bent, 100000U) << name;
    }
}

TEST(WebVariation, HasNoBoundWhereAWebJumps) {
    const Web cut = web_of(Photometry::c, Symmetry::axial, {0.0}, steps(0, 60, 7), false);
    const WebVariation variation(cut);
    EXPECT_TRUE(std::isinf(variation.at(0.5).slope));            // 60°
    EXPECT_TRUE(std::isfinite(variation.at(0.8).slope));         // 37°
    EXPECT_EQ(variation.at(std::cos(2.0)).slope, 0.0);           // dark
    EXPECT_EQ(variation.at(1.0).bend_rad, 0.0) << "at the pole"; // lines of C meet
    EXPECT_FALSE(WebVariation(web_of(Photometry::b, Symmetry::none, steps(-90, 90, 19), steps(-80, 80, 17), false))
                     .is_bounded());
    EXPECT_FALSE(
        WebVariation(web_of(Photometry::c, Symmetry::quadrant, steps(0, 80, 9), steps(0, 90, 10), false)).is_bounded());
}

} // namespace
} // namespace gonio
