// Masked lights: their flux against sums over the cells of the mask, and what masks must not change.
#include <gonio/light/lobe.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "quadrature.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;

constexpr double rad = pi / 180.0;

const char* const masked_shapes[] = {"point",
                                     "spot:outer=40deg,inner=25deg",
                                     "spot:outer=25.0001deg,inner=25deg",
                                     "spot:outer=90deg,falloff=hard",
                                     "spot:outer=80deg,falloff=smoothstep-cos",
                                     "spot:outer=90deg,inner=3deg,falloff=linear-angle",
                                     "spot:outer=1e-4deg,falloff=smoothstep-angle",
                                     "frustum:h=60deg,v=40deg",
                                     "frustum:h=1e-4deg,v=2e-4deg",
                                     "frustum:h=179deg,v=0.001deg",
                                     "frustum:h=0.5deg,v=179.99deg",
                                     "frustum:h=179.9deg,v=179.9deg"};

Web constant(Symmetry stored, std::vector<double> planes, std::vector<double> gammas, double cd) {
    std::vector<double> candela(planes.size() * gammas.size(), cd);
    return *Web::create(stored, std::move(planes), std::move(gammas), std::move(candela));
}

double flux_of(const char* text, const Web& mask) {
    return masked_solid_angle(test::shape(text), mask).value;
}

double unmasked(const char* text) {
    return test::convert(test::shape(text), "1cd", "lm");
}

TEST(MaskedFlux, AConstantMaskChangesNothing) {
    const Web masks[] = {constant(Symmetry::axial, {0}, {0, 180}, 3.0),
                         constant(Symmetry::axial, {0}, test::steps(0, 180, 73), 250.0),
                         constant(Symmetry::quadrant, test::steps(0, 90, 7), test::steps(0, 180, 19), 0.25),
                         constant(Symmetry::bilateral_0_180, test::steps(0, 180, 4), {0, 7, 90, 180}, 1.0),
                         constant(Symmetry::bilateral_90_270, test::steps(90, 270, 5), {0, 180}, 1e6),
                         constant(Symmetry::none, {-17, 40, 101, 222, 343}, {0, 1, 60, 180}, 9.0)};
    for (const Web& mask : masks)
        for (const char* text : masked_shapes)
            EXPECT_NEAR(flux_of(text, mask), unmasked(text), 2e-11 * unmasked(text))
                << text << ", " << to_text(mask.stored_symmetry());
}

// Shapes with a size, weighted by their projected area: the cells are one degree, so the error is a few 1e-8 near a
// tube's ends.
TEST(MaskedFlux, AConstantMaskOnAShapeWithASizeChangesNothing) {
    const Web masks[] = {constant(Symmetry::axial, {0}, {0, 180}, 3.0),
                         constant(Symmetry::none, {-17, 40, 101, 222, 343}, {0, 1, 60, 180}, 9.0)};
    for (const Web& mask : masks)
        for (const char* text :
             {"sphere:r=10cm", "disk:r=10cm", "disk:r=10cm,two-sided", "ellipse:w=60cm,h=10cm", "rect:w=60cm,h=30cm",
              "rect:w=60cm,h=30cm,two-sided", "tube:r=1cm,l=1m", "tube:r=1m,l=1cm", "cylinder:r=10cm,l=30cm"})
            EXPECT_NEAR(flux_of(text, mask), unmasked(text), 1e-7 * unmasked(text)) << text;
}

// m = cos γ below the horizontal: ∬ cos²γ dω = 2π/3 for a disk; the web is linear between its many angles.
TEST(MaskedFlux, ADiskBehindACosineInClosedForm) {
    std::vector<double> gammas = test::steps(0, 180, 721);
    std::vector<double> candela;
    for (const double gamma : gammas)
        candela.push_back(std::max(std::cos(gamma * rad), 0.0));
    const Web mask = *Web::create(Symmetry::axial, {0}, gammas, candela);
    EXPECT_NEAR(flux_of("disk:r=10cm", mask), 2.0 * pi / 3.0, 1e-5);
    EXPECT_NEAR(flux_of("rect:w=1m,h=2m,two-sided", mask), 2.0 * pi / 3.0, 1e-5);
}

TEST(MaskedFlux, AMaskOfHalfTheCircleHalves) {
    for (const double first : {0.0, 33.0, -90.0}) {
        const Web mask = constant(Symmetry::none, {first, first + 180.0}, {0, 180}, 7.0);
        for (const char* text : masked_shapes)
            EXPECT_NEAR(flux_of(text, mask), 0.5 * unmasked(text), 2e-11 * unmasked(text)) << text << " " << first;
    }
    // With a given flux, the light that passes is twice as bright; so is the illuminance on the axis.
    const Web mask = constant(Symmetry::none, {0, 180}, {0, 180}, 7.0);
    const Shape open = test::shape("spot:outer=40deg");
    EXPECT_NEAR(test::convert(test::masked(open, mask), "800lm", "cd"), 2.0 * test::convert(open, "800lm", "cd"), 1e-9);
    EXPECT_NEAR(test::convert(test::masked(open, mask), "800lm", "lx@2m"), 2.0 * test::convert(open, "800lm", "lx@2m"),
                1e-9);
}

// A mask linear in γ from 1 to 0 at 90°: ∫ (1 − 2γ/π) sinγ by hand.
TEST(MaskedFlux, ALinearMaskInClosedForm) {
    const Web mask = *Web::create(Symmetry::axial, {0}, {0, 90}, {10.0, 0.0});
    const double b = 50.0 * rad;
    const double by_hand = 2.0 * pi * ((1.0 - std::cos(b)) - 2.0 / pi * (std::sin(b) - b * std::cos(b)));
    EXPECT_NEAR(flux_of("spot:outer=50deg,falloff=hard", mask), by_hand, 1e-14);
    EXPECT_NEAR(flux_of("point", mask), 2.0 * pi * (1.0 - 2.0 / pi), 1e-14);
}

// The same interpolant on a finer grid, by adding angles between those of the web.
Web refined(const Web& web) {
    const auto finer = [](std::span<const double> angles) {
        std::vector<double> all;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            all.push_back(angles[i]);
            if (i + 1 == angles.size()) break;
            for (const double share : {0.31, 0.77})
                all.push_back(angles[i] + share * (angles[i + 1] - angles[i]));
        }
        return all;
    };
    const std::vector<double> planes = finer(web.planes_deg());
    const std::vector<double> gammas = finer(web.gammas_deg());
    std::vector<double> candela;
    for (const double c : planes)
        for (const double gamma : gammas)
            candela.push_back(web.candela(c, gamma));
    return *Web::create(web.stored_symmetry(), planes, gammas, candela);
}

// The plane at 360° is the plane at 0°.
Web closed_random_web(unsigned seed) {
    const std::vector<double> gammas = test::steps(0, 180, 13);
    const Web open = test::random_web(Symmetry::none, test::steps(0, 330, 12), gammas, seed);
    std::vector<double> candela;
    for (std::size_t plane = 0; plane <= 12; ++plane)
        candela.insert(candela.end(), open.column(plane % 12).begin(), open.column(plane % 12).end());
    return *Web::create(Symmetry::none, test::steps(0, 360, 13), gammas, std::move(candela));
}

std::vector<Web> random_masks() {
    std::vector<Web> masks;
    masks.push_back(test::random_web(Symmetry::axial, {0}, test::steps(0, 90, 7), 1));
    masks.push_back(test::random_web(Symmetry::quadrant, test::steps(0, 90, 4), test::steps(0, 180, 10), 2));
    masks.push_back(test::random_web(Symmetry::bilateral_0_180, test::steps(0, 180, 5), test::steps(0, 60, 5), 3));
    masks.push_back(test::random_web(Symmetry::bilateral_90_270, test::steps(90, 270, 5), {3, 11, 41, 77}, 4));
    masks.push_back(closed_random_web(5));
    masks.push_back(test::random_web(Symmetry::none, {10, 50, 130}, test::steps(0, 90, 4), 6));
    return masks;
}

TEST(MaskedFlux, DoesNotDependOnHowTheMaskIsCut) {
    for (const Web& mask : random_masks())
        for (const char* text : masked_shapes) {
            const Web finer = refined(mask);
            const double value = masked_solid_angle(test::shape(text), mask).value * peak(mask).intensity.value;
            EXPECT_NEAR(masked_solid_angle(test::shape(text), finer).value * peak(finer).intensity.value, value,
                        1e-11 * value)
                << text << ", " << to_text(mask.stored_symmetry());
        }
}

// Sum over rings and azimuths of lobe × web, using the public evaluation of the web, split at every angle of the web
// and of a spot; a pyramid is split at every quarter of a degree and at its corners.
double by_cells(const Shape& shape, const Web& mask) {
    std::vector<double> azimuths = test::steps(0, 360, 1441);
    if (const auto* frustum = std::get_if<FrustumShape>(&shape)) {
        const double corner =
            std::atan2(std::tan(0.5 * frustum->vertical.value), std::tan(0.5 * frustum->horizontal.value)) / rad;
        for (const double c : {corner, 180 - corner, 180 + corner, 360 - corner})
            azimuths.push_back(c);
        std::sort(azimuths.begin(), azimuths.end());
    }
    static const test::GaussRule<double> rule(4);
    double sum = 0.0;
    for (std::size_t i = 1; i < azimuths.size(); ++i)
        for (std::size_t k = 0; k < rule.at.size(); ++k) {
            const double half = 0.5 * (azimuths[i] - azimuths[i - 1]);
            const double c = azimuths[i - 1] + half * (1.0 + rule.at[k]);
            std::vector<double> cuts(mask.gammas_deg().begin(), mask.gammas_deg().end());
            double last = 180.0;
            if (const auto* spot = std::get_if<SpotShape>(&shape)) {
                cuts.push_back(to_degrees(spot->inner));
                last = to_degrees(spot->outer);
            } else if (const auto* frustum = std::get_if<FrustumShape>(&shape)) {
                last = std::min(std::atan(std::tan(0.5 * frustum->horizontal.value) / std::abs(std::cos(c * rad))),
                                std::atan(std::tan(0.5 * frustum->vertical.value) / std::abs(std::sin(c * rad)))) /
                       rad;
            }
            cuts.push_back(last);
            std::sort(cuts.begin(), cuts.end());
            double column = 0.0;
            for (std::size_t j = 1; j < cuts.size() && cuts[j] <= last; ++j) {
                const double h = 0.5 * (cuts[j] - cuts[j - 1]);
                static const test::GaussRule<double> along(10);
                for (std::size_t n = 0; n < along.at.size(); ++n) {
                    const double gamma = cuts[j - 1] + h * (1.0 + along.at[n]);
                    const auto* spot = std::get_if<SpotShape>(&shape);
                    column += h * rad * along.weight[n] * mask.candela(c, gamma) * std::sin(gamma * rad) *
                              (spot != nullptr ? lobe(*spot, degrees(gamma)) : 1.0);
                }
            }
            sum += half * rad * rule.weight[k] * column;
        }
    return sum / peak(mask).intensity.value;
}

TEST(MaskedFlux, IsTheSumOverTheCells) {
    for (const Web& mask : random_masks())
        for (const char* text : {"spot:outer=40deg,inner=25deg", "spot:outer=80deg,falloff=smoothstep-angle",
                                 "frustum:h=60deg,v=40deg", "frustum:h=100deg,v=150deg"}) {
            const Shape shape = test::shape(text);
            const double truth = by_cells(shape, mask);
            // If a pyramid's edge crosses the web's γ inside a degree, the sum above is only good to about 1e-7.
            const double bar = std::holds_alternative<FrustumShape>(shape) ? 2e-7 : 1e-11;
            EXPECT_NEAR(masked_solid_angle(shape, mask).value, truth, bar * truth)
                << text << ", " << to_text(mask.stored_symmetry());
        }
}

TEST(MaskedFlux, CandelaAndLuxAreThoseThatPass) {
    // Brightest at 45°, half as bright on the axis.
    const Web mask = *Web::create(Symmetry::axial, {0}, {0, 45, 90}, {50.0, 100.0, 0.0});
    const Shape shape = test::masked(test::shape("point"), mask);
    EXPECT_NEAR(test::convert(shape, "100cd", "lm"), 2.0 * flux(mask).value, 1e-10);
    EXPECT_NEAR(test::convert(shape, "100cd", "lx@2m"), 25.0, 1e-13);
    // Dark on the axis: candela or lux cannot set it, lumens can.
    const Web ring = *Web::create(Symmetry::axial, {0}, {0, 45, 90}, {0.0, 100.0, 0.0});
    const Shape masked = test::masked(test::shape("point"), ring);
    EXPECT_NE(test::refusal(masked, "100cd", "lm"), "");
    EXPECT_NE(test::refusal(masked, "100lx@1m", "lm"), "");
    EXPECT_EQ(test::convert(masked, "100lm", "cd"), 0.0);
    // Dark everywhere inside the lobe, or dark everywhere.
    const Web outside = *Web::create(Symmetry::axial, {0}, {60, 90}, {1.0, 1.0});
    EXPECT_NE(test::refusal(test::masked(test::shape("spot:outer=40deg"), outside), "1lm", "cd"), "");
    EXPECT_NE(test::refusal(test::masked(test::shape("frustum:h=40deg,v=40deg"), outside), "1lm", "cd"), "");
    const Web dark = *Web::create(Symmetry::axial, {0}, {0, 90}, {0.0, 0.0});
    EXPECT_NE(test::refusal(test::masked(test::shape("point"), dark), "1lm", "cd"), "");
}

} // namespace
} // namespace gonio
