#include <gonio/web/integrate.hpp>
#include <gonio/web/smooth.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gonio {
namespace {

Web made(Symmetry stored, std::vector<double> planes, std::vector<double> gammas, std::vector<double> candela,
         Photometry photometry = Photometry::c) {
    return Web::create(photometry, stored, std::move(planes), std::move(gammas), std::move(candela)).value();
}

// Random values on a grid, the same in all planes on the axis, and in C 0 and 360.
Web random_web(Symmetry stored, std::vector<double> planes, std::vector<double> gammas, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0.0, 1000.0);
    std::vector<double> candela(planes.size() * gammas.size());
    for (double& value : candela)
        value = any(random) < 200.0 ? 0.0 : any(random);
    for (std::size_t i = 0; i < planes.size(); ++i)
        for (std::size_t k = 0; k < gammas.size(); ++k) {
            double& value = candela[i * gammas.size() + k];
            if (gammas[k] == 0.0 || gammas[k] == 180.0) value = candela[k];
            if (i + 1 == planes.size() && planes[i] == 360.0) value = candela[k];
        }
    return made(stored, std::move(planes), std::move(gammas), std::move(candela));
}

std::vector<Web> random_webs() {
    std::vector<Web> webs;
    for (unsigned seed = 1; seed <= 8; ++seed) {
        webs.push_back(random_web(Symmetry::axial, {0}, {0, 5, 15, 40, 90}, seed));
        webs.push_back(random_web(Symmetry::quadrant, {0, 30, 45, 90}, {0, 10, 20, 90, 180}, seed));
        webs.push_back(random_web(Symmetry::bilateral_0_180, {0, 45, 90, 135, 180}, {0, 30, 60, 90}, seed));
        webs.push_back(random_web(Symmetry::bilateral_90_270, {90, 180, 270}, {0, 30, 60, 90}, seed));
        webs.push_back(random_web(Symmetry::none, {0, 60, 90, 200, 360}, {0, 30, 31, 60, 180}, seed));
        webs.push_back(random_web(Symmetry::none, {10, 60, 90}, {20, 30, 60}, seed)); // dark around
    }
    return webs;
}

TEST(Smooth, KeepsEveryValueOfTheTable) {
    for (const Web& web : random_webs()) {
        const Web smooth = smoothed(web, 1.0).value();
        const auto index_of = [](std::span<const double> angles, double angle) {
            return static_cast<std::size_t>(std::find(angles.begin(), angles.end(), angle) - angles.begin());
        };
        for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
            for (std::size_t k = 0; k < web.vertical_deg().size(); ++k) {
                const std::size_t c = index_of(smooth.horizontal_deg(), web.horizontal_deg()[i]);
                const std::size_t gamma = index_of(smooth.vertical_deg(), web.vertical_deg()[k]);
                ASSERT_LT(c, smooth.horizontal_deg().size());
                ASSERT_LT(gamma, smooth.vertical_deg().size());
                EXPECT_EQ(smooth.column(c)[gamma], web.column(i)[k]) << i << " " << k;
            }
        EXPECT_EQ(smooth.stored_symmetry(), web.stored_symmetry());
        EXPECT_EQ(smooth.horizontal_deg().front(), web.horizontal_deg().front());
        EXPECT_EQ(smooth.vertical_deg().back(), web.vertical_deg().back());
    }
}

// Every intensity lies between the four corners of its cell.
TEST(Smooth, NeverOvershoots) {
    for (const Web& web : random_webs()) {
        const Web smooth = smoothed(web, 1.0).value();
        const auto cell_of = [](std::span<const double> angles, double angle) {
            std::size_t cell = 0;
            while (cell + 2 < angles.size() && angle >= angles[cell + 1])
                ++cell;
            return cell;
        };
        for (std::size_t i = 0; i < smooth.horizontal_deg().size(); ++i)
            for (std::size_t k = 0; k < smooth.vertical_deg().size(); ++k) {
                const std::size_t c = cell_of(web.horizontal_deg(), smooth.horizontal_deg()[i]);
                const std::size_t g = cell_of(web.vertical_deg(), smooth.vertical_deg()[k]);
                const std::size_t next = std::min(c + 1, web.horizontal_deg().size() - 1);
                const double corners[] = {web.column(c)[g], web.column(c)[g + 1], web.column(next)[g],
                                          web.column(next)[g + 1]};
                const double value = smooth.column(i)[k];
                EXPECT_GE(value, *std::min_element(corners, corners + 4));
                EXPECT_LE(value, *std::max_element(corners, corners + 4));
            }
    }
}

// A wide lobe in steps of 10°: the smooth curve is closer to it than the facets, by a factor of 8 or more.
TEST(Smooth, IsCloserToASmoothLight) {
    const auto lobe = [](double gamma_deg) {
        return 1000.0 * std::pow(std::cos(0.5 * gamma_deg * std::numbers::pi / 180.0), 4.0);
    };
    std::vector<double> gammas;
    std::vector<double> candela;
    for (int gamma = 0; gamma <= 180; gamma += 10) {
        gammas.push_back(gamma);
        candela.push_back(lobe(gamma));
    }
    const Web web = made(Symmetry::axial, {0}, gammas, candela);
    const Web smooth = smoothed(web, 0.5).value();
    double facets = 0.0;
    double curve = 0.0;
    for (double gamma = 0.0; gamma <= 180.0; gamma += 0.5) {
        facets = std::max(facets, std::abs(web.candela(0.0, gamma) - lobe(gamma)));
        curve = std::max(curve, std::abs(smooth.candela(0.0, gamma) - lobe(gamma)));
    }
    EXPECT_LT(curve, facets / 8.0) << facets << " " << curve;
}

// No bend where the line goes on: on the axis, in mirrors, over C 0.
TEST(Smooth, GoesOnThroughTheAxisMirrorsAndTheFullTurn) {
    std::vector<double> planes;
    std::vector<double> candela;
    for (int c = 0; c <= 360; c += 30) {
        planes.push_back(c);
        for (int gamma = 0; gamma <= 90; gamma += 15) {
            const double turn = c % 360 * std::numbers::pi / 180.0;
            const double tilt = gamma * std::numbers::pi / 180.0;
            candela.push_back(500.0 + 300.0 * std::sin(tilt) * std::cos(turn - 0.3) + 100.0 * std::cos(tilt));
        }
    }
    const Web smooth = smoothed(made(Symmetry::none, planes, {0, 15, 30, 45, 60, 75, 90}, candela), 1.0).value();
    const auto bend = [](double before, double at, double behind) { return std::abs(before - 2.0 * at + behind); };
    for (const double c : {0.0, 30.0, 120.0}) {
        const double on_axis = smooth.candela(c, 0.0);
        EXPECT_LT(bend(smooth.candela(c + 180.0, 1.0), on_axis, smooth.candela(c, 1.0)), 0.3) << c;
    }
    for (const double gamma : {15.0, 40.0, 90.0})
        EXPECT_LT(bend(smooth.candela(359.0, gamma), smooth.candela(0.0, gamma), smooth.candela(1.0, gamma)), 0.3)
            << gamma;
    // The greatest bend of the facets is some 10 cd.
    const Web quadrant = smoothed(made(Symmetry::quadrant, {0, 45, 90}, {0, 90}, {9, 100, 9, 40, 9, 0}), 1.0).value();
    EXPECT_LT(bend(quadrant.candela(-1.0, 90.0), quadrant.candela(0.0, 90.0), quadrant.candela(1.0, 90.0)), 0.2);
}

TEST(Smooth, RefusesStepsThatAreTooShortOrMakeTooMuch) {
    const Web web = random_webs().front();
    for (const double step : {0.0, -1.0, 0.04, 91.0, std::nan("")})
        EXPECT_FALSE(smoothed(web, step)) << step;
    const Web wide = made(Symmetry::none, {0, 180, 360}, {0, 180}, {1, 2, 1, 2, 1, 2});
    EXPECT_FALSE(smoothed(wide, 0.05)); // 7201 by 3601
    EXPECT_TRUE(smoothed(wide, 0.5));
}

TEST(Smooth, WebsOfTypesAAndBAreSmoothInTheirOwnAngles) {
    const Web web = made(Symmetry::quadrant, {0, 20, 40}, {0, 20, 40}, {100, 60, 0, 50, 30, 0, 0, 0, 0}, Photometry::b);
    const Web smooth = smoothed(web, 1.0).value();
    EXPECT_EQ(smooth.photometry(), Photometry::b);
    EXPECT_EQ(smooth.candela_at(20.0, 20.0), 30.0);
    EXPECT_LT(std::abs(smooth.candela_at(0.0, 1.0) - 100.0), 0.5); // level in the mirror, where the line falls by 2
}

} // namespace
} // namespace gonio
