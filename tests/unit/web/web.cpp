#include <gonio/base/frame.hpp>
#include <gonio/web/plane_rows.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

TEST(Web, HitsItsTableExactly) {
    for (const auto& gammas : {steps(0, 180, 37), std::vector<double>{0, 1, 2.5, 30, 90}}) {
        const Web web = random_web(Symmetry::none, steps(0, 360, 25), gammas, 1);
        for (std::size_t p = 0; p + 1 < web.planes_deg().size(); ++p)
            for (std::size_t g = 0; g < gammas.size(); ++g)
                EXPECT_EQ(web.candela(web.planes_deg()[p], gammas[g]), web.column(p)[g]);
    }
}

TEST(Web, IsLinearBetween) {
    const Web web = *Web::create(Symmetry::none, {0, 10, 360}, {0, 90}, {0, 100, 200, 300, 0, 100});
    EXPECT_DOUBLE_EQ(web.candela(0, 45), 50.0);
    EXPECT_DOUBLE_EQ(web.candela(5, 0), 100.0);
    EXPECT_DOUBLE_EQ(web.candela(5, 45), 150.0);
    EXPECT_DOUBLE_EQ(web.candela(365, 45), 150.0);
    EXPECT_DOUBLE_EQ(web.candela(-355, 45), 150.0);
}

TEST(Web, IsDarkOutsideItsAngles) {
    const Web web = *Web::create(Symmetry::axial, {0}, {10, 80}, {1, 2});
    EXPECT_EQ(web.candela(0, 9.999), 0.0);
    EXPECT_EQ(web.candela(0, 80.001), 0.0);
    EXPECT_EQ(web.candela(123, 80), 2.0);
    const Web sector = *Web::create(Symmetry::none, {0, 270}, {0, 90}, {1, 1, 1, 1});
    EXPECT_EQ(sector.candela(269, 45), 1.0);
    EXPECT_EQ(sector.candela(271, 45), 0.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(web.candela(nan, 45), 0.0);
    EXPECT_EQ(web.candela(0, nan), 0.0);
    EXPECT_EQ(sector.candela(nan, 45), 0.0);
}

TEST(Web, PlanesAtOnceAreTheSameToTheLastBit) {
    const std::vector<double> uneven{0, 1, 2.5, 30, 77.7, 90};
    const std::vector<Web> webs{random_web(Symmetry::none, steps(0, 360, 25), steps(0, 180, 37), 1),
                                random_web(Symmetry::none, {-10, 20, 111, 200}, uneven, 2),
                                random_web(Symmetry::axial, {0}, uneven, 3),
                                random_web(Symmetry::quadrant, steps(0, 90, 7), steps(0, 90, 10), 4),
                                random_web(Symmetry::bilateral_90_270, steps(90, 270, 9), {45}, 5),
                                random_web(Symmetry::bilateral_0_180, {0, 1e-3, 90, 180}, steps(10, 170, 13), 6)};
    for (const Web& web : webs) {
        std::vector<double> gammas = steps(-5, 185, 133);
        gammas.insert(gammas.end(), web.gammas_deg().begin(), web.gammas_deg().end());
        gammas.push_back(std::numeric_limits<double>::quiet_NaN());
        const web_detail::PlaneRows rows(web, gammas);
        std::vector<double> planes = steps(-400, 800, 301);
        planes.insert(planes.end(), web.planes_deg().begin(), web.planes_deg().end());
        planes.push_back(std::numeric_limits<double>::infinity());
        for (const double c : planes) {
            std::vector<double> found;
            rows.append(c, found);
            ASSERT_EQ(found.size(), gammas.size());
            for (std::size_t j = 0; j < gammas.size(); ++j)
                ASSERT_EQ(found[j], web.candela(c, gammas[j])) << c << " " << gammas[j];
        }
    }
}

// Each stored symmetry is the same light as its planes written out over the circle.
TEST(Web, SymmetriesEqualTheirExpansion) {
    struct Case {
        Symmetry stored;
        double first;
        double last;
    };
    for (const Case c : {Case{Symmetry::quadrant, 0, 90}, Case{Symmetry::bilateral_0_180, 0, 180},
                         Case{Symmetry::bilateral_90_270, 90, 270}}) {
        const Web web = random_web(c.stored, steps(c.first, c.last, 7), steps(0, 90, 10), 7);
        std::vector<double> planes = steps(0, 360, 25);
        std::vector<double> candela;
        for (const double plane : planes)
            for (const double gamma : web.gammas_deg()) {
                double folded = plane;
                if (c.stored == Symmetry::quadrant) {
                    folded = std::fmod(plane, 180.0);
                    if (folded > 90.0) folded = 180.0 - folded;
                } else if (c.stored == Symmetry::bilateral_0_180) {
                    if (folded > 180.0) folded = 360.0 - folded;
                } else {
                    if (folded < 90.0) folded = 180.0 - folded;
                    if (folded > 270.0) folded = 540.0 - folded;
                }
                const auto p = static_cast<std::size_t>(std::lround((folded - c.first) / (c.last - c.first) * 6.0));
                // Only stored planes are compared, on a grid of 15°.
                const double at_plane = c.first + static_cast<double>(p) * (c.last - c.first) / 6.0;
                const auto g = static_cast<std::size_t>(gamma / 10.0);
                candela.push_back(at_plane == folded ? web.column(p)[g] : web.candela(folded, gamma));
            }
        const Web full = *Web::create(Symmetry::none, planes, steps(0, 90, 10), candela);
        for (double at = -400.0; at < 800.0; at += 3.7)
            for (double gamma = 0.0; gamma <= 90.0; gamma += 1.3)
                EXPECT_NEAR(web.candela(at, gamma), full.candela(at, gamma), 1e-9) << to_text(c.stored) << at;
    }
}

TEST(Web, DirectionsAndAnglesAgree) {
    const Web web = random_web(Symmetry::none, steps(0, 360, 37), steps(0, 180, 37), 3);
    for (double c = 1.0; c < 360.0; c += 11.1)
        for (double gamma = 0.7; gamma < 180.0; gamma += 7.7)
            EXPECT_NEAR(web.candela(2.5 * direction_of({degrees(c), degrees(gamma)})), web.candela(c, gamma), 1e-9);
}

TEST(Web, RefusesWhatIsNoGrid) {
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {0, 0}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {10, 5}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {0, 181}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {-1, 90}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {}, {}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {}, {0}, {}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0, 90}, {0}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::quadrant, {0, 91}, {0}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::none, {0, 361}, {0}, {1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::none, {0, 360}, {0, 90}, {1, 1, 1}));
    EXPECT_FALSE(Web::create(Symmetry::axial, {0}, {0}, {std::numeric_limits<double>::infinity()}));
}

} // namespace
} // namespace gonio
