// Types A and B: directions, evaluation, exact flux, and their integrals over (C, γ), against independent dense sums.
#include <gonio/bake/bake.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/rings.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/web_rows.hpp>

#include "../folders.hpp"
#include "webs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <span>

namespace gonio {
namespace {

using std::numbers::pi;
using test::steps;

constexpr double rad = pi / 180.0;

Web random_native(Photometry type, Symmetry stored, std::vector<double> h, std::vector<double> v, unsigned seed) {
    std::mt19937 generator(seed);
    std::vector<double> candela(h.size() * v.size());
    for (double& cd : candela)
        cd = 1000.0 * static_cast<double>(generator()) / 4294967296.0;
    return *Web::create(type, stored, std::move(h), std::move(v), std::move(candela));
}

std::vector<Web> some_webs() {
    std::vector<Web> webs;
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        webs.push_back(random_native(type, Symmetry::none, steps(-90, 90, 13), steps(-90, 90, 19), 1));
        webs.push_back(random_native(type, Symmetry::quadrant, {0, 3, 7, 20, 50, 90}, {0, 5, 11, 30, 90}, 2));
        webs.push_back(random_native(type, Symmetry::bilateral_90_270, {0, 10, 40}, {-60, -7, 0, 33, 60}, 3));
        webs.push_back(random_native(type, Symmetry::bilateral_0_180, {-20, -7, 0, 12}, {0, 8, 15}, 4));
    }
    webs.push_back(random_native(Photometry::a, Symmetry::none, steps(-180, 180, 25), steps(-90, 90, 13), 5));
    webs.push_back(random_native(Photometry::b, Symmetry::none, steps(-90, 90, 13), steps(-180, 180, 25), 6));
    return webs;
}

// The midpoint rule inside every native cell on both sides of each mirror, using only directions.
double flux_by_midpoints(const Web& web, int n) {
    const Web full = expanded(web);
    double sum = 0.0;
    const bool a = web.photometry() == Photometry::a;
    for (std::size_t i = 1; i < full.horizontal_deg().size(); ++i)
        for (std::size_t j = 1; j < full.vertical_deg().size(); ++j) {
            const double h0 = full.horizontal_deg()[i - 1];
            const double v0 = full.vertical_deg()[j - 1];
            const double dh = (full.horizontal_deg()[i] - h0) / n;
            const double dv = (full.vertical_deg()[j] - v0) / n;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    const double h = h0 + (x + 0.5) * dh;
                    const double v = v0 + (y + 0.5) * dv;
                    sum += web.candela(direction_of(web.photometry(), {h, v})) * std::cos((a ? v : h) * rad) * dh * dv *
                           rad * rad;
                }
        }
    return sum;
}

TEST(Goniometer, AimAndAxesAreWhereLm75PutsThem) {
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const glm::dvec3 aim = direction_of(type, {0, 0});
        EXPECT_EQ(aim, glm::dvec3(0, 0, -1));
        EXPECT_NEAR(glm::distance(direction_of(type, {90, 0}), glm::dvec3(1, 0, 0)), 0.0, 1e-15);
        EXPECT_NEAR(glm::distance(direction_of(type, {0, 90}), glm::dvec3(0, 1, 0)), 0.0, 1e-15);
    }
    // The difference between types: which angle runs along great circles.
    EXPECT_NEAR(direction_of(Photometry::a, {77, 30}).y, std::sin(30 * rad), 1e-15);
    EXPECT_NEAR(direction_of(Photometry::b, {30, 77}).x, std::sin(30 * rad), 1e-15);
    for (const Photometry type : {Photometry::a, Photometry::b, Photometry::c})
        for (double h = -80; h <= 80; h += 13)
            for (double v = -80; v <= 80; v += 11) {
                const GoniometerAngles at =
                    angles_of(type, 3.0 * direction_of(type, {h + 180.0 * (type == Photometry::c), std::abs(v)}));
                EXPECT_NEAR(at.horizontal_deg, h + 180.0 * (type == Photometry::c), 1e-12);
                EXPECT_NEAR(at.vertical_deg, std::abs(v), 1e-12);
            }
}

TEST(NativeWeb, HitsItsTableByDirectionAndByAngle) {
    for (const Web& web : some_webs())
        for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
            for (std::size_t j = 0; j < web.vertical_deg().size(); ++j) {
                const double h = web.horizontal_deg()[i];
                const double v = web.vertical_deg()[j];
                EXPECT_EQ(web.candela_at(h, v), web.column(i)[j]);
                // Where longitudes meet or close, a direction has several coordinates.
                const double latitude = web.photometry() == Photometry::a ? v : h;
                const double longitude = web.photometry() == Photometry::a ? h : v;
                if (std::abs(latitude) == 90.0 || std::abs(longitude) == 180.0) continue;
                const glm::dvec3 direction = direction_of(web.photometry(), {h, v});
                EXPECT_NEAR(web.candela(2.0 * direction), web.column(i)[j], 1e-8) << h << ',' << v;
                const GoniometerAngles c = angles_of(Photometry::c, direction);
                EXPECT_NEAR(web.candela(c.horizontal_deg, c.vertical_deg), web.column(i)[j], 1e-8) << h << ',' << v;
            }
}

TEST(NativeWeb, MirrorsAreThoseOfTheDirections) {
    for (const Web& web : some_webs()) {
        const Symmetry s = web.stored_symmetry();
        for (double c = 3.0; c < 360.0; c += 17.0)
            for (double gamma = 2.0; gamma < 180.0; gamma += 9.0) {
                if (s == Symmetry::quadrant || s == Symmetry::bilateral_0_180) {
                    EXPECT_NEAR(web.candela(c, gamma), web.candela(360.0 - c, gamma), 1e-8);
                }
                if (s == Symmetry::quadrant || s == Symmetry::bilateral_90_270) {
                    EXPECT_NEAR(web.candela(c, gamma), web.candela(540.0 - c, gamma), 1e-8);
                }
                EXPECT_NEAR(web.candela(c, gamma), expanded(web).candela(c, gamma), 1e-8);
            }
    }
}

TEST(NativeWeb, IsDarkOutsideItsTable) {
    const Web web = *Web::create(Photometry::b, Symmetry::none, {-10, 10}, {-20, 20}, {1, 1, 1, 1});
    EXPECT_EQ(web.candela(direction_of(Photometry::b, {9.999, 19.999})), 1.0);
    EXPECT_EQ(web.candela(direction_of(Photometry::b, {10.001, 0})), 0.0);
    EXPECT_EQ(web.candela(direction_of(Photometry::b, {0, 20.001})), 0.0);
    EXPECT_EQ(web.candela(0.0, 180.0), 0.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(web.candela(nan, 1.0), 0.0);
    EXPECT_EQ(web.candela(0.0, nan), 0.0);
    EXPECT_EQ(web.candela_at(nan, 0.0), 0.0);
    EXPECT_EQ(web.candela_at(0.0, nan), 0.0);
}

TEST(NativeWeb, RefusesWhatIsNoGrid) {
    const std::vector<double> four(4, 1.0);
    EXPECT_FALSE(Web::create(Photometry::b, Symmetry::none, {-91, 0}, {0, 1}, four));
    EXPECT_TRUE(Web::create(Photometry::b, Symmetry::none, {-90, 0}, {-180, 180}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::none, {-90, 0}, {-180, 180}, four));
    EXPECT_TRUE(Web::create(Photometry::a, Symmetry::none, {-180, 180}, {-90, 90}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::quadrant, {-1, 1}, {0, 1}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::bilateral_0_180, {0, 1}, {-1, 1}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::axial, {0, 1}, {0, 1}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::none, {1, 0}, {0, 1}, four));
    EXPECT_FALSE(Web::create(Photometry::a, Symmetry::none, {0, 1}, {0, 1}, {1, 1, 1}));
}

TEST(NativeFlux, OfAConstantIsItsSolidAngle) {
    // 1 cd over the forward half is 2π lm, over everything 4π, over |H| ≤ 30° of type B 4π·sin 30°/2.
    const std::vector<double> ones(4, 1.0);
    for (const Photometry type : {Photometry::a, Photometry::b})
        EXPECT_NEAR(flux(*Web::create(type, Symmetry::none, {-90, 90}, {-90, 90}, ones)).value, 2 * pi, 1e-13);
    EXPECT_NEAR(flux(*Web::create(Photometry::b, Symmetry::none, {-30, 30}, {-180, 180}, ones)).value, 2 * pi, 1e-13);
    EXPECT_NEAR(zonal_flux(*Web::create(Photometry::a, Symmetry::quadrant, {0, 180}, {0, 90}, ones)).value, 4 * pi,
                1e-13);
}

TEST(NativeFlux, AgreesWithQuadratureForEveryMirror) {
    for (const Web& web : some_webs()) {
        const double truth = flux_by_midpoints(web, 60);
        EXPECT_NEAR(flux(web).value, truth, 1e-4 * truth) << to_text(web.stored_symmetry());
        EXPECT_NEAR(flux(expanded(web)).value, flux(web).value, 1e-12 * truth);
        EXPECT_NEAR(flux(web.scaled(2.5)).value, 2.5 * flux(web).value, 1e-12 * truth);
    }
}

// The two integrals are independent: closed form over native cells, quadrature over rings of γ.
TEST(Rings, MeetTheExactFlux) {
    for (const Web& web : some_webs()) {
        const double exact = flux(web).value;
        EXPECT_NEAR(Rings(web).zone(0, 180), exact, 1e-6 * exact)
            << (web.photometry() == Photometry::a ? 'A' : 'B') << ' ' << to_text(web.stored_symmetry());
    }
    const Web c = test::random_web(Symmetry::bilateral_90_270, steps(90, 270, 13), steps(0, 180, 19), 7);
    EXPECT_NEAR(Rings(c).zone(0, 180), flux(c).value, 1e-9 * flux(c).value);
}

TEST(Rings, WeightsCutTheRings) {
    const Web web = some_webs()[0];
    Rings rings(web);
    rings.cut_at_gamma(33.0);
    const auto inside = [](const glm::dvec3& d) { return -d.z > std::cos(33.0 * rad) ? 1.0 : 0.0; };
    EXPECT_NEAR(rings.zone(0, 180, inside), rings.zone(0, 33), 1e-9 * rings.zone(0, 33));
    // A pyramid of constant intensity: 4 asin(sin a/2 sin b/2).
    const Web one = *Web::create(Photometry::b, Symmetry::none, {-90, 90}, {-90, 90}, {1, 1, 1, 1});
    Rings pyramid(one);
    pyramid.cut_at_pyramid(20, 35);
    const double slope_x = std::tan(20 * rad);
    const double slope_y = std::tan(35 * rad);
    const auto lit = [&](const glm::dvec3& d) {
        return std::abs(d.x) < -d.z * slope_x && std::abs(d.y) < -d.z * slope_y ? 1.0 : 0.0;
    };
    EXPECT_NEAR(pyramid.zone(0, 90, lit), 4 * std::asin(std::sin(20 * rad) * std::sin(35 * rad)), 1e-8);
}

TEST(NativeBake, HoldsTheFluxAtEverySize) {
    for (const Web& web : some_webs())
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 2}, {16, 8}, {128, 64}}) {
            BakeOptions options;
            options.width = width;
            options.height = height;
            const Texture texture = bake_texture(web, options).value();
            EXPECT_NEAR(texture.texture_flux.value, flux(web).value, 1e-7 * flux(web).value)
                << to_text(web.stored_symmetry()) << ' ' << width << 'x' << height;
        }
}

TEST(NativeMetrics, PeakAndSpreadAreByDirection) {
    // A narrow bright spot at H = 20°, V = 0 of type B: towards C0, γ = 20°.
    const Web web = *Web::create(Photometry::b, Symmetry::none, {-90, 10, 20, 30, 90}, {-90, -10, 0, 10, 90},
                                 {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 100, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    const Peak top = peak(web);
    EXPECT_EQ(top.intensity.value, 100.0);
    EXPECT_NEAR(top.c_deg, 0.0, 1e-9);
    EXPECT_NEAR(top.gamma_deg, 20.0, 1e-9);
    // In C0–C180 the section is the line V = 0: half at 15° and 25°.
    EXPECT_NEAR(to_degrees(*spread_angle(web, 0, 0.5)), 10.0, 1e-6);
}

TEST(Native, RowsAtOnceAreTheSameToTheLastBit) {
    const std::vector<double> gammas = steps(0, 180, 73);
    for (const Web& web : some_webs()) {
        std::vector<double> vertical = steps(-100, 100, 81);
        vertical.insert(vertical.end(), web.vertical_deg().begin(), web.vertical_deg().end());
        std::vector<double> horizontal = steps(-100, 100, 41);
        horizontal.insert(horizontal.end(), web.horizontal_deg().begin(), web.horizontal_deg().end());
        const web_detail::PlaneRows planes(web, vertical);
        for (const double h : horizontal) {
            std::vector<double> found;
            planes.append(h, found);
            for (std::size_t j = 0; j < vertical.size(); ++j)
                ASSERT_EQ(found[j], web.candela_at(h, vertical[j])) << h << ' ' << vertical[j];
        }
        web_detail::WebRows rows(web, gammas);
        for (int c = -90; c <= 450; c += 15) {
            const std::span<const double> exact = rows.exact(c);
            for (std::size_t j = 0; j < gammas.size(); ++j)
                ASSERT_EQ(exact[j], web.candela(c, gammas[j])) << c << ' ' << gammas[j];
            const std::span<const double> quick = rows.quick(c);
            for (std::size_t j = 0; j < gammas.size(); ++j)
                ASSERT_NEAR(quick[j], web.candela(c, gammas[j]), rows.margin_cd()) << c << ' ' << gammas[j];
        }
    }
}

TEST(Resample, OfTypesAAndBStatesItsError) {
    const Web web = random_native(Photometry::b, Symmetry::bilateral_90_270, steps(0, 90, 10), steps(-90, 90, 19), 9);
    const ResampledWeb coarse = *resampled_to_c(web, even_angles(0, 360, 36), even_angles(0, 90, 9));
    const ResampledWeb fine = *resampled_to_c(web, even_angles(0, 360, 720), even_angles(0, 90, 180));
    EXPECT_EQ(fine.web.photometry(), Photometry::c);
    EXPECT_LT(fine.max_error.value, coarse.max_error.value);
    EXPECT_NEAR(fine.flux_error.value, flux(fine.web).value - flux(web).value, 1e-9);
    // No direction has a larger error than stated, except for a margin between the measured points.
    std::mt19937 generator(3);
    for (int i = 0; i < 20000; ++i) {
        const double c = 360.0 * static_cast<double>(generator()) / 4294967296.0;
        const double gamma = 90.0 * static_cast<double>(generator()) / 4294967296.0;
        EXPECT_LE(std::abs(fine.web.candela(c, gamma) - web.candela(c, gamma)), 1.1 * fine.max_error.value + 1e-9);
    }
    EXPECT_NEAR(std::abs(fine.web.candela(fine.max_error_c_deg, fine.max_error_gamma_deg) -
                         web.candela(fine.max_error_c_deg, fine.max_error_gamma_deg)),
                fine.max_error.value, 1e-9);
    const Web sampled = *sampled_on_grid(web, even_angles(0, 360, 720), even_angles(0, 90, 180));
    EXPECT_EQ(difference(sampled, fine.web).greatest.value, 0.0);
    const ResampledWeb chosen = *resampled_to_c(web, 0.05);
    EXPECT_EQ(chosen.web.stored_symmetry(), Symmetry::bilateral_90_270);
}

// Smooth, and dark where the tables end.
Web lobe(Photometry type, double end_deg) {
    const std::vector<double> angles = steps(-end_deg, end_deg, 37);
    std::vector<double> candela;
    for (const double h : angles)
        for (const double v : angles) {
            const double off = std::hypot((h - 12.0) / 20.0, (v + 5.0) / 35.0);
            const double end = std::cos(h / end_deg * pi / 2) * std::cos(v / end_deg * pi / 2);
            candela.push_back(std::max(0.0, 1000.0 * std::exp2(-off * off) * end));
        }
    return *Web::create(type, Symmetry::none, angles, angles, candela);
}

TEST(Resample, FollowsTheLightToTheTolerance) {
    for (const Photometry type : {Photometry::a, Photometry::b})
        for (const double tolerance : {0.02, 0.005, 0.002}) {
            const Web web = lobe(type, 90);
            const ResampledWeb c = *resampled_to_c(web, tolerance);
            EXPECT_LE(c.max_error.value, 1.25 * tolerance * peak(web).intensity.value) << tolerance;
            EXPECT_LE(c.web.planes_deg().size() * c.web.gammas_deg().size(), 65536U);
            // The principal planes contain the table's own angles, and therefore its values.
            for (const double h : web.horizontal_deg()) {
                const double at = c.web.candela(h < 0 ? 180.0 : 0.0, std::abs(h));
                EXPECT_NEAR(at, web.candela_at(h, 0.0), 1e-9) << h;
            }
        }
}

TEST(Resample, IsBoundedWhereTheTableEndsInTheBright) {
    const std::vector<double> angles = steps(-40, 40, 9);
    const Web web = *Web::create(Photometry::b, Symmetry::none, angles, angles, std::vector<double>(81, 100.0));
    const ResampledWeb c = *resampled_to_c(web);
    EXPECT_LE(c.web.planes_deg().size() * c.web.gammas_deg().size(), 65536U);
    EXPECT_GT(c.max_error.value, 10.0); // the error is reported, not hidden
    EXPECT_NEAR(c.flux_error.value, 0.0, 5e-3 * flux(web).value);
}

// All V meet at H = 90° of type B, and there the table has two values.
TEST(Resample, TellsAJumpOfTheTableFromItsOwnError) {
    const Web web = *Web::create(Photometry::b, Symmetry::none, {-90, 0, 90}, {-90, 0, 90},
                                 {100, 100, 100, 100, 100, 100, 40, 70, 100});
    const ResampledWeb c = *resampled_to_c(web);
    EXPECT_LE(c.max_error.value, 1.25 * resampling_tolerance * 100.0);
    EXPECT_GT(c.jump_error.value, 5.0);
    EXPECT_LE(c.jump_error.value, 60.0);
    EXPECT_LE(c.web.planes_deg().size() * c.web.gammas_deg().size(), 65536U);
}

TEST(NativeSymmetry, IsDetectedAndCompacted) {
    for (const Web& web : some_webs()) {
        EXPECT_EQ(detected_symmetry(web), web.stored_symmetry());
        const Web full = expanded(web);
        EXPECT_EQ(full.stored_symmetry(), Symmetry::none);
        EXPECT_EQ(detected_symmetry(full), web.stored_symmetry());
        const Web compact = compacted(full);
        EXPECT_EQ(compact.stored_symmetry(), web.stored_symmetry());
        EXPECT_EQ(compact.horizontal_deg().size(), web.horizontal_deg().size());
        EXPECT_EQ(compact.vertical_deg().size(), web.vertical_deg().size());
        for (double h = -179; h < 180; h += 7.3)
            for (double v = -179; v < 180; v += 6.1)
                EXPECT_NEAR(compact.candela_at(h, v), web.candela_at(h, v), 1e-9);
    }
}

Profile ies(Photometry type, std::vector<double> h, std::vector<double> v, std::vector<double> candela) {
    IesFile file;
    file.photometry = type;
    file.horizontal_deg = std::move(h);
    file.vertical_deg = std::move(v);
    file.candela = std::move(candela);
    return {"test.ies", file, {}};
}

TEST(NativeResolve, AnglesThatStartAtZeroStandForBothSides) {
    const std::vector<double> candela{1, 2, 3, 4, 5, 6, 7, 8, 9};
    for (const Photometry type : {Photometry::a, Photometry::b}) {
        const Web full = resolve_web(ies(type, {-90, 0, 90}, {-90, 0, 90}, candela))->web;
        EXPECT_EQ(full.photometry(), type);
        EXPECT_EQ(full.stored_symmetry(), Symmetry::none);
        EXPECT_EQ(full.candela(0, 0), 5.0); // [horizontal][vertical]
        EXPECT_NEAR(full.candela_at(-90, 0), 2.0, 1e-12);
        EXPECT_EQ(resolve_web(ies(type, {0, 45, 90}, {-90, 0, 90}, candela))->web.stored_symmetry(),
                  Symmetry::bilateral_90_270);
        EXPECT_EQ(resolve_web(ies(type, {-90, 0, 90}, {0, 45, 90}, candela))->web.stored_symmetry(),
                  Symmetry::bilateral_0_180);
        EXPECT_EQ(resolve_web(ies(type, {0, 45, 90}, {0, 45, 90}, candela))->web.stored_symmetry(), Symmetry::quadrant);
    }
    // Factors apply as for other types.
    Profile profile = ies(Photometry::b, {-90, 0, 90}, {-90, 0, 90}, candela);
    std::get<IesFile>(profile.file).candela_multiplier = 3.0;
    EXPECT_EQ(resolve_web(profile)->web.candela(0, 0), 15.0);
}

TEST(NativeResolve, OneAngleIsNoTable) {
    const auto resolved = resolve_web(ies(Photometry::a, {0}, {-90, 90}, {1, 1}));
    ASSERT_TRUE(resolved);
    ASSERT_EQ(resolved->diagnostics.size(), 1U);
    EXPECT_EQ(resolved->diagnostics[0].code, "WEB0107");
    EXPECT_EQ(flux(resolved->web).value, 0.0);
    EXPECT_FALSE(resolve_web(ies(Photometry::a, {-200, 0}, {-90, 90}, {1, 1, 1, 1})));
}

// Real files of type B: the texture's integral is the exact flux at any size.
TEST(NativeCorpus, RealTypeBFilesAreBaked) {
    namespace fs = std::filesystem;
    if (std::string(test::corpus_folder).empty() || !fs::is_directory(fs::path(test::corpus_folder) / "good"))
        GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    int found = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(test::corpus_folder) / "good")) {
        const Result<Profile> profile = read_profile_file(entry.path().string());
        const auto* const file = profile ? std::get_if<IesFile>(&profile->file) : nullptr;
        if (file == nullptr || file->photometry == Photometry::c) continue;
        ++found;
        const Result<ResolvedWeb> resolved = resolve_web(*profile);
        ASSERT_TRUE(resolved) << entry.path();
        const double exact = flux(resolved->web).value;
        BakeOptions options;
        options.width = 64;
        options.height = 32;
        EXPECT_NEAR(bake_texture(resolved->web, options)->texture_flux.value, exact, 1e-7 * exact) << entry.path();
        const ResampledWeb c = *resampled_to_c(resolved->web);
        EXPECT_LE(std::abs(c.flux_error.value), 0.01 * exact) << entry.path();
    }
    EXPECT_GT(found, 0);
}

} // namespace
} // namespace gonio
