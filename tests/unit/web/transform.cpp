// Transforms: each result against the source web, compared by direction.
#include <gonio/web/combine.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

using test::random_web;
using test::steps;

std::vector<Web> every_kind() {
    return {random_web(Symmetry::axial, {0}, {0, 30, 90}, 1),
            random_web(Symmetry::quadrant, {0, 10, 50, 90}, {0, 30, 90}, 2),
            random_web(Symmetry::bilateral_0_180, {0, 10, 50, 180}, {0, 30, 90, 180}, 3),
            random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, {30, 60, 150}, 4),
            expanded(random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, {0, 60, 90}, 5)),
            random_web(Symmetry::none, {10, 50, 200, 370}, {0, 60, 90}, 6), // a turn later the first plane differs
            random_web(Symmetry::none, {20, 50, 200}, {0, 60, 90}, 7)};     // a gap
}

Web native(Photometry type, Symmetry stored, unsigned seed) {
    const std::vector<double> h =
        stored == Symmetry::none ? std::vector<double>{-50, -20, 0, 15, 70} : std::vector<double>{0, 10, 15, 40, 70};
    const std::vector<double> v =
        stored == Symmetry::none ? std::vector<double>{-60, -10, 5, 30, 80} : std::vector<double>{0, 3, 15, 30, 80};
    std::mt19937 generator(seed);
    std::vector<double> candela(25);
    for (double& cd : candela)
        cd = 1000.0 * static_cast<double>(generator()) / 4294967296.0;
    return *Web::create(type, stored, h, v, candela);
}

// Directions that avoid the edges of every table above.
template<class Check>
void over_directions(Check&& check) {
    for (double c = 0.37; c < 360.0; c += 7.3)
        for (double gamma = 0.71; gamma < 180.0; gamma += 5.9)
            check(c, gamma);
}

TEST(Rotated, MovesEveryDirectionByTheAngle) {
    for (const Web& web : every_kind())
        for (const double angle : {90.0, -90.0, 180.0, 33.0, 400.0, 0.0}) {
            const ResampledWeb turned = rotated(web, angle);
            EXPECT_EQ(turned.max_error.value, 0.0);
            EXPECT_NEAR(flux(turned.web).value, flux(web).value, 1e-11 * flux(web).value);
            over_directions([&](double c, double gamma) {
                EXPECT_NEAR(turned.web.candela(c + angle, gamma), web.candela(c, gamma), 1e-8)
                    << to_text(web.stored_symmetry()) << " by " << angle << " at " << c << ',' << gamma;
            });
        }
}

TEST(Rotated, QuarterTurnsKeepTheMirrors) {
    const std::vector<Web> webs = every_kind();
    EXPECT_EQ(rotated(webs[1], 90).web.stored_symmetry(), Symmetry::quadrant);
    EXPECT_EQ(rotated(webs[2], 90).web.stored_symmetry(), Symmetry::bilateral_90_270);
    EXPECT_EQ(rotated(webs[3], -90).web.stored_symmetry(), Symmetry::bilateral_0_180);
    EXPECT_EQ(rotated(webs[2], 90).web.planes_deg().size(), webs[2].planes_deg().size());
    EXPECT_LE(difference(rotated(rotated(webs[3], 90).web, -90).web, webs[3]).relative, 1e-12);
}

TEST(Rotated, AQuarterTurnOfTypeBIsTypeA) {
    for (const Photometry type : {Photometry::a, Photometry::b})
        for (const Symmetry stored : {Symmetry::none, Symmetry::quadrant})
            for (const double angle : {90.0, 180.0, 270.0}) {
                const Web web = native(type, stored, 5);
                const ResampledWeb turned = rotated(web, angle);
                EXPECT_EQ(turned.web.photometry() == type, angle == 180.0);
                EXPECT_EQ(turned.web.stored_symmetry(), stored);
                EXPECT_NEAR(flux(turned.web).value, flux(web).value, 1e-11 * flux(web).value);
                over_directions([&](double c, double gamma) {
                    EXPECT_NEAR(turned.web.candela(c + angle, gamma), web.candela(c, gamma), 1e-8);
                });
            }
    const Web web = native(Photometry::b, Symmetry::none, 5);
    const ResampledWeb odd = rotated(web, 20.0);
    EXPECT_EQ(odd.web.photometry(), Photometry::c);
    EXPECT_GT(odd.max_error.value, 0.0);
    EXPECT_NEAR(odd.flux_error.value, flux(odd.web).value - flux(web).value, 1e-9);
}

TEST(Mirrored, SwapsTheSides) {
    for (const Web& web : every_kind()) {
        const Web over_c0 = mirrored(web, MirrorPlane::c0_180);
        const Web over_c90 = mirrored(web, MirrorPlane::c90_270);
        EXPECT_EQ(over_c0.stored_symmetry(), web.stored_symmetry());
        over_directions([&](double c, double gamma) {
            EXPECT_NEAR(over_c0.candela(-c, gamma), web.candela(c, gamma), 1e-8) << to_text(web.stored_symmetry());
            EXPECT_NEAR(over_c90.candela(180.0 - c, gamma), web.candela(c, gamma), 1e-8);
        });
    }
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const Web web = native(type, Symmetry::none, 6);
        const Web over_c0 = mirrored(web, MirrorPlane::c0_180);
        const Web over_c90 = mirrored(web, MirrorPlane::c90_270);
        over_directions([&](double c, double gamma) {
            EXPECT_NEAR(over_c0.candela(-c, gamma), web.candela(c, gamma), 1e-8);
            EXPECT_NEAR(over_c90.candela(180.0 - c, gamma), web.candela(c, gamma), 1e-8);
        });
    }
}

TEST(Tilted, LeansTheAxis) {
    // A narrow beam is tilted in the requested direction.
    const Web beam = *Web::create(Symmetry::axial, {0}, {0, 5, 20, 90}, {1000, 900, 0, 0});
    for (const double towards : {0.0, 90.0, 180.0, 217.0}) {
        const ResampledWeb leaned = tilted(beam, 25.0, towards, 0.02);
        const Peak top = peak(leaned.web);
        EXPECT_NEAR(top.gamma_deg, 25.0, 1.0);
        EXPECT_NEAR(std::remainder(top.c_deg - towards, 360.0), 0.0, 3.0);
        EXPECT_NEAR(flux(leaned.web).value, flux(beam).value, 0.01 * flux(beam).value);
        EXPECT_LE(leaned.max_error.value, 0.02 * 1000.0);
        EXPECT_NEAR(leaned.flux_error.value, flux(leaned.web).value - flux(beam).value, 1e-9);
    }
    EXPECT_EQ(tilted(beam, 25.0, 0.0).web.stored_symmetry(), Symmetry::bilateral_0_180);
    EXPECT_EQ(tilted(beam, 25.0, 90.0).web.stored_symmetry(), Symmetry::bilateral_90_270);
    EXPECT_EQ(tilted(beam, 25.0, 10.0).web.stored_symmetry(), Symmetry::none);
    EXPECT_EQ(tilted(beam, 0.0, 10.0).max_error.value, 0.0);
}

TEST(Tilted, IsARotationOfDirections) {
    // Smooth, so that the resampled web is close: I = 2 + x + 0.5 y of the unit direction.
    std::vector<double> candela;
    const std::vector<double> planes = steps(0, 360, 145);
    const std::vector<double> gammas = steps(0, 180, 73);
    for (const double c : planes)
        for (const double gamma : gammas) {
            const glm::dvec3 d = direction_of(Photometry::c, {c, gamma});
            candela.push_back(2.0 + d.x + 0.5 * d.y);
        }
    const Web web = *Web::create(Symmetry::none, planes, gammas, candela);
    const ResampledWeb leaned = tilted(web, 40.0, 30.0, 1e-4);
    // The vector (1, 0.5, 0) rotates with the web: nadir goes to C 30°, γ 40°.
    const double a = 40.0 * std::numbers::pi / 180.0;
    const glm::dvec3 u(std::cos(std::numbers::pi / 6.0), std::sin(std::numbers::pi / 6.0), 0.0);
    const glm::dvec3 w(-u.y, u.x, 0.0);
    const glm::dvec3 v(1.0, 0.5, 0.0);
    const glm::dvec3 turned =
        glm::dot(v, w) * w + glm::dot(v, u) * (std::cos(a) * u + glm::dvec3(0.0, 0.0, std::sin(a)));
    over_directions([&](double c, double gamma) {
        EXPECT_NEAR(leaned.web.candela(c, gamma), 2.0 + glm::dot(turned, direction_of(Photometry::c, {c, gamma})),
                    2e-3);
    });
}

TEST(Symmetrized, IsTheMeanOfTheImages) {
    for (const Web& web : every_kind())
        for (const Symmetry symmetry : {Symmetry::axial, Symmetry::quadrant, Symmetry::bilateral_0_180,
                                        Symmetry::bilateral_90_270, Symmetry::none}) {
            const Web even = *symmetrized(web, symmetry);
            // If a plane reappears a turn later with other values there is a jump, written as a ramp 0.0001° wide.
            const double bar =
                web.stored_symmetry() == Symmetry::none && web.planes_deg().front() != 0.0 ? 1e-8 : 1e-11;
            EXPECT_NEAR(flux(even).value, flux(web).value, bar * flux(web).value) << to_text(symmetry);
            over_directions([&](double c, double gamma) {
                const auto at = [&](double x) { return web.candela(x, gamma); };
                double mean = at(c);
                if (symmetry == Symmetry::bilateral_0_180) mean = 0.5 * (at(c) + at(-c));
                if (symmetry == Symmetry::bilateral_90_270) mean = 0.5 * (at(c) + at(180 - c));
                if (symmetry == Symmetry::quadrant) mean = 0.25 * (at(c) + at(-c) + at(180 - c) + at(180 + c));
                if (symmetry != Symmetry::axial) {
                    EXPECT_NEAR(even.candela(c, gamma), mean, 1e-8)
                        << to_text(web.stored_symmetry()) << to_text(symmetry);
                }
            });
        }
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const Web web = native(type, Symmetry::none, 7);
        EXPECT_FALSE(symmetrized(web, Symmetry::axial));
        const Web even = *symmetrized(web, Symmetry::bilateral_90_270);
        EXPECT_EQ(even.stored_symmetry(), Symmetry::bilateral_90_270);
    }
}

// Planes that end before the range of their symmetry, and tables of the other types that end on one side, leave parts
// dark (gonio/web/web.hpp): a dark part must not become lit, and a lit part must not become dark.
TEST(DarkSectors, StayDarkWhateverIsDoneToTheWeb) {
    // Angles that every operation rounds.
    const double third = 1.0 / 3.0;
    const std::vector<double> gammas{0, 30, 90, 120};
    const std::vector<Web> webs{
        random_web(Symmetry::quadrant, {0, 10, 45.0 + third}, gammas, 11),
        random_web(Symmetry::quadrant, {20.0 + third, 50, 90}, gammas, 12),
        random_web(Symmetry::bilateral_0_180, {0, 50, 120.0 + third}, gammas, 13),
        random_web(Symmetry::bilateral_0_180, {33.0 + third, 50, 60, 160.0 + third}, gammas, 14),
        random_web(Symmetry::bilateral_90_270, {90, 100, 180}, gammas, 15),
        random_web(Symmetry::bilateral_90_270, {120.0 + third, 270}, gammas, 16),
        random_web(Symmetry::none, {0, 50, 180}, gammas, 17),
        random_web(Symmetry::none, {20.0 + third, 50, 200.0 + third}, gammas, 18),
        random_web(Symmetry::none, {300, 310, 420.0 + third}, gammas, 19),
        random_web(Symmetry::quadrant, {0}, gammas, 20)}; // only a single plane: no light at all
    for (std::size_t i = 0; i < webs.size(); ++i) {
        const Web& web = webs[i];
        const double lm = flux(web).value;
        for (const MirrorPlane plane : {MirrorPlane::c0_180, MirrorPlane::c90_270}) {
            const Web image = mirrored(web, plane);
            EXPECT_NEAR(flux(image).value, lm, 1e-12 * lm) << i;
            over_directions([&](double c, double gamma) {
                EXPECT_NEAR(image.candela(plane == MirrorPlane::c0_180 ? -c : 180.0 - c, gamma), web.candela(c, gamma),
                            1e-8)
                    << i << " at " << c << ',' << gamma;
            });
        }
        for (const double angle : {90.0, 180.0, 270.0, 33.0, 0.1, -120.0 - third}) {
            const Web turned = rotated(web, angle).web;
            EXPECT_NEAR(flux(turned).value, lm, 1e-8 * lm) << i << " by " << angle;
            over_directions([&](double c, double gamma) {
                EXPECT_NEAR(turned.candela(c + angle, gamma), web.candela(c, gamma), 1e-8) << i << " by " << angle;
            });
        }
        for (const Symmetry symmetry : {Symmetry::axial, Symmetry::quadrant, Symmetry::bilateral_0_180,
                                        Symmetry::bilateral_90_270, Symmetry::none}) {
            const Web even = *symmetrized(web, symmetry);
            EXPECT_EQ(even.stored_symmetry(), symmetry == Symmetry::none ? web.stored_symmetry() : symmetry);
            EXPECT_NEAR(flux(even).value, lm, 1e-8 * lm) << i << ' ' << to_text(symmetry);
            if (symmetry == Symmetry::axial) continue;
            const bool over_c0 = symmetry == Symmetry::quadrant || symmetry == Symmetry::bilateral_0_180;
            const bool over_c90 = symmetry == Symmetry::quadrant || symmetry == Symmetry::bilateral_90_270;
            over_directions([&](double c, double gamma) {
                double sum = 0.0;
                for (const bool mirror_c0 : {false, over_c0})
                    for (const bool mirror_c90 : {false, over_c90}) {
                        const double at = mirror_c90 ? 180.0 - c : c;
                        sum += 0.25 * web.candela(mirror_c0 ? -at : at, gamma);
                    }
                EXPECT_NEAR(even.candela(c, gamma), sum, 1e-8) << i << ' ' << to_text(symmetry) << " at " << c;
            });
        }
    }
    std::mt19937 generator(20);
    for (const Photometry type : {Photometry::a, Photometry::b})
        for (const double first : {-20.0, 0.0, 10.0}) {
            std::vector<double> candela(9);
            for (double& cd : candela)
                cd = 1000.0 * static_cast<double>(generator()) / 4294967296.0;
            const Web web = *Web::create(type, Symmetry::none, {first, 15, 40}, {-30, 5, 60}, candela);
            const double lm = flux(web).value;
            for (const Symmetry symmetry :
                 {Symmetry::quadrant, Symmetry::bilateral_0_180, Symmetry::bilateral_90_270}) {
                const Web even = *symmetrized(web, symmetry);
                EXPECT_EQ(even.stored_symmetry(), symmetry);
                EXPECT_NEAR(flux(even).value, lm, 1e-8 * lm) << first << ' ' << to_text(symmetry);
            }
            EXPECT_NEAR(flux(mirrored(web, MirrorPlane::c90_270)).value, lm, 1e-12 * lm);
        }
}

TEST(Cropped, EndsTheTable) {
    const Web web = random_web(Symmetry::quadrant, {0, 10, 50, 90}, {0, 30, 90, 120}, 2);
    const Web cut = *cropped(web, 12.0, 90.0);
    EXPECT_EQ(cut.gammas_deg().front(), 12.0);
    EXPECT_EQ(cut.gammas_deg().back(), 90.0);
    over_directions([&](double c, double gamma) {
        EXPECT_NEAR(cut.candela(c, gamma), gamma < 12.0 || gamma > 90.0 ? 0.0 : web.candela(c, gamma), 1e-9);
    });
    EXPECT_FALSE(cropped(web, 130.0, 150.0));
    EXPECT_FALSE(cropped(web, 50.0, 20.0));
    EXPECT_FALSE(cropped(native(Photometry::a, Symmetry::none, 1), 0.0, 20.0));
}

TEST(ScaledTo, HasTheFlux) {
    const Web web = native(Photometry::b, Symmetry::quadrant, 3);
    EXPECT_NEAR(flux(*scaled_to(web, Lumens(1234.0))).value, 1234.0, 1e-9);
    EXPECT_FALSE(scaled_to(web, Lumens(0.0)));
    EXPECT_FALSE(scaled_to(*Web::create(Symmetry::axial, {0}, {0, 90}, {0, 0}), Lumens(1.0)));
    EXPECT_FALSE(scaled_to(web, Lumens(1e40)));
}

TEST(Combined, IsTheSumOfEveryDirection) {
    const std::vector<Web> webs = every_kind();
    for (std::size_t i = 0; i < webs.size(); ++i)
        for (std::size_t j = 0; j < webs.size(); ++j) {
            const std::vector<WeightedWeb> parts{{&webs[i], 2.0}, {&webs[j], 0.5}};
            const CombinedWeb sum = *combined(parts);
            const double total = 2.0 * flux(webs[i]).value + 0.5 * flux(webs[j]).value;
            EXPECT_EQ(sum.max_error_cd, 0.0);
            EXPECT_NEAR(flux(sum.web).value, total, 1e-5 * total) << i << ' ' << j;
            over_directions([&](double c, double gamma) {
                EXPECT_NEAR(sum.web.candela(c, gamma),
                            2.0 * webs[i].candela(c, gamma) + 0.5 * webs[j].candela(c, gamma), 1e-6)
                    << i << ' ' << j << " at " << c << ',' << gamma;
            });
        }
    const Web b = native(Photometry::b, Symmetry::quadrant, 3);
    const Web other = native(Photometry::b, Symmetry::none, 4);
    const CombinedWeb sum = *combined(std::vector<WeightedWeb>{{&b, 1.0}, {&other, 1.0}});
    EXPECT_EQ(sum.web.photometry(), Photometry::b);
    over_directions([&](double c, double gamma) {
        EXPECT_NEAR(sum.web.candela(c, gamma), b.candela(c, gamma) + other.candela(c, gamma), 1e-6);
    });
    const CombinedWeb mixed = *combined(std::vector<WeightedWeb>{{&b, 1.0}, {&webs[0], 1.0}});
    EXPECT_EQ(mixed.web.photometry(), Photometry::c);
    EXPECT_GT(mixed.max_error_cd, 0.0);
    EXPECT_FALSE(combined({}));
}

} // namespace
} // namespace gonio
