#include <gonio/web/integrate.hpp>
#include <gonio/web/symmetry.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

// A web of each symmetry, written out in full planes, is recognised.
TEST(Symmetry, IsDetectedFromTheNumbers) {
    struct Case {
        Symmetry stored;
        std::vector<double> planes;
    };
    for (const Case& c :
         {Case{Symmetry::axial, {0}}, Case{Symmetry::quadrant, steps(0, 90, 7)},
          Case{Symmetry::bilateral_0_180, steps(0, 180, 13)}, Case{Symmetry::bilateral_90_270, steps(90, 270, 13)},
          Case{Symmetry::none, steps(0, 345, 24)}}) {
        const Web web = random_web(c.stored, c.planes, steps(0, 90, 10), 21);
        std::vector<double> planes = steps(0, 360, 25);
        std::vector<double> candela;
        for (const double plane : planes)
            for (const double gamma : web.gammas_deg())
                candela.push_back(web.candela(plane == 360.0 ? 0.0 : plane, gamma));
        const Web full = *Web::create(Symmetry::none, planes, steps(0, 90, 10), candela);
        EXPECT_EQ(detected_symmetry(full), c.stored) << to_text(c.stored);
        EXPECT_EQ(detected_symmetry(web), c.stored) << to_text(c.stored);
    }
}

TEST(Symmetry, OfUnevenPlanesIsThatOfTheInterpolant) {
    // 10° has no mirror plane at 350°, but lies on the line between its neighbours' mirror images.
    const Web mirrored = *Web::create(Symmetry::none, {0, 10, 180, 360}, {0, 90}, {0, 0, 10, 10, 180, 180, 0, 0});
    EXPECT_EQ(detected_symmetry(mirrored), Symmetry::bilateral_0_180);
    const Web bent = *Web::create(Symmetry::none, {0, 10, 180, 360}, {0, 90}, {0, 0, 50, 50, 180, 180, 0, 0});
    EXPECT_EQ(detected_symmetry(bent), Symmetry::none);
}

TEST(Symmetry, CompactedIsTheSmallestThatIsTheSameLight) {
    for (const Web& web :
         {random_web(Symmetry::axial, {0}, {0, 30, 90}, 1), random_web(Symmetry::quadrant, {0, 10, 50, 90}, {0, 90}, 2),
          random_web(Symmetry::bilateral_0_180, {0, 10, 50, 180}, {0, 30, 90}, 3),
          random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, {0, 30, 90}, 4)}) {
        const Web full = expanded(web);
        ASSERT_EQ(full.stored_symmetry(), Symmetry::none);
        EXPECT_EQ(full.planes_deg().front(), 0.0);
        EXPECT_EQ(full.planes_deg().back(), 360.0);
        EXPECT_NEAR(flux(full).value, flux(web).value, 1e-12 * flux(web).value);
        const Web compact = compacted(full);
        EXPECT_EQ(compact.stored_symmetry(), web.stored_symmetry());
        EXPECT_EQ(compact.planes_deg().size(), web.planes_deg().size()) << to_text(web.stored_symmetry());
        for (double c = 0.5; c < 360.0; c += 3.7)
            for (double gamma = 0.0; gamma <= 90.0; gamma += 4.5) {
                EXPECT_NEAR(full.candela(c, gamma), web.candela(c, gamma), 1e-9);
                EXPECT_NEAR(compact.candela(c, gamma), web.candela(c, gamma), 1e-9);
            }
    }
}

TEST(Symmetry, CompactedKeepsABendThatOnlyItsMirrorImageShows) {
    // Bends at 10° and at 300°: each half alone is missing one of them.
    const Web lean = *Web::create(Symmetry::none, {0, 10, 60, 180, 300, 350, 360}, {0, 90},
                                  {0, 0, 20, 20, 30, 30, 100, 100, 30, 30, 20, 20, 0, 0});
    const Web compact = compacted(lean);
    EXPECT_EQ(compact.stored_symmetry(), Symmetry::bilateral_0_180);
    for (double c = 0.5; c < 360.0; c += 3.7)
        EXPECT_NEAR(compact.candela(c, 45), lean.candela(c, 45), 1e-9) << c;
}

TEST(Symmetry, ToleranceIsOfThePeak) {
    Web full = expanded(random_web(Symmetry::bilateral_0_180, steps(0, 180, 7), {0, 30, 90}, 3));
    std::vector<double> candela;
    for (std::size_t i = 0; i < full.planes_deg().size(); ++i)
        candela.insert(candela.end(), full.column(i).begin(), full.column(i).end());
    candela[4] += 0.5; // of about 1000
    const Web off =
        *Web::create(Symmetry::none, {full.planes_deg().begin(), full.planes_deg().end()}, {0, 30, 90}, candela);
    EXPECT_EQ(compacted(off).stored_symmetry(), Symmetry::none);
    EXPECT_EQ(compacted(off, 0.01).stored_symmetry(), Symmetry::bilateral_0_180);
}

TEST(Symmetry, AJumpOrAGapIsNoMirror) {
    // First and last plane differ; otherwise the web would be axial.
    const Web jump = *Web::create(Symmetry::none, {0, 90, 180, 270, 360}, {0, 90}, {5, 5, 5, 5, 5, 5, 5, 5, 9, 9});
    EXPECT_EQ(detected_symmetry(jump), Symmetry::none);
    const Web sector = *Web::create(Symmetry::none, {45, 135}, {0, 90}, {5, 5, 5, 5});
    EXPECT_EQ(compacted(sector).stored_symmetry(), Symmetry::none);
    EXPECT_EQ(compacted(sector).candela(200, 45), 0.0);
}

} // namespace
} // namespace gonio
