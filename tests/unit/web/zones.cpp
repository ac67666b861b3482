#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/rings.hpp>
#include <gonio/web/spacing.hpp>
#include <gonio/web/transform.hpp>
#include <gonio/web/zones.hpp>

#include "../folders.hpp"
#include "webs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;
using test::random_web;
using test::steps;

constexpr double rad = pi / 180.0;

// A Lambertian source of 1 cd, in steps fine enough for the linear interpolant.
Web lambertian() {
    const std::vector<double> gammas = steps(0, 90, 1801);
    std::vector<double> candela;
    for (const double gamma : gammas)
        candela.push_back(gamma == 90.0 ? 0.0 : std::cos(gamma * rad));
    return *Web::create(Symmetry::axial, {0}, gammas, candela);
}

TEST(Zones, AddUpToTheFluxAndMeetTheQuadrature) {
    for (const Web& web :
         {random_web(Symmetry::axial, {0}, {0, 3, 7.5, 40, 90}, 1),
          random_web(Symmetry::quadrant, {0, 11, 45, 90}, steps(0, 90, 19), 2),
          random_web(Symmetry::bilateral_0_180, steps(0, 180, 13), steps(0, 180, 37), 3),
          random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, steps(30, 150, 25), 4),
          random_web(Symmetry::none, {10, 50, 200, 370}, steps(90, 180, 19), 5),
          *Web::create(Photometry::b, Symmetry::quadrant, {0, 20, 60}, {0, 30, 80}, {9, 3, 1, 4, 5, 1, 2, 1, 0})}) {
        const double all = flux(web).value;
        double sum = 0.0;
        for (const Lumens zone : ten_degree_zones(web))
            sum += zone.value;
        EXPECT_NEAR(sum, all, 1e-6 * all);
        EXPECT_NEAR(zone_flux(web, 0, 180).value, all, 1e-6 * all);
        const Rings rings(web);
        for (const auto& [low, high] : {std::pair{0.0, 41.3}, {12.5, 12.6}, {85.0, 133.0}})
            EXPECT_NEAR(zone_flux(web, low, high).value, rings.zone(low, high), 1e-7 * all) << low;
        const LuminaireClassification classes = luminaire_classification(web);
        double classified = classes.up_low.value + classes.up_high.value;
        for (std::size_t i = 0; i < 4; ++i)
            classified += classes.front[i].value + classes.back[i].value;
        EXPECT_NEAR(classified, all, 1e-6 * all);
    }
}

TEST(Zones, FrontIsTheSideOfC0) {
    // Light towards C0 ± 45° only.
    const Web web =
        *Web::create(Symmetry::bilateral_0_180, {0, 45, 90, 180}, {0, 90}, {100, 100, 100, 100, 0, 0, 0, 0});
    const LuminaireClassification classes = luminaire_classification(web);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GT(classes.front[i].value, 0.0);
        EXPECT_EQ(classes.back[i].value, 0.0);
    }
    // 100 cd over a quarter turn, and two flanks of 45° with half of that flux.
    EXPECT_NEAR(classes.front[0].value, 100.0 * (0.5 * pi + 0.25 * pi) * (1.0 - std::cos(30 * rad)), 1e-9);
}

TEST(Zones, FrontMayBeTheSideOfAnotherPlane) {
    const Web web =
        *Web::create(Symmetry::bilateral_0_180, {0, 45, 90, 180}, {0, 90}, {100, 100, 100, 100, 0, 0, 0, 0});
    const LuminaireClassification straight = luminaire_classification(web);
    const LuminaireClassification turned = luminaire_classification(rotated(web, 90.0).web, 90.0);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(turned.front[i].value, straight.front[i].value, 1e-12);
        EXPECT_NEAR(turned.back[i].value, 0.0, 1e-12);
    }
}

// Roads in EULUMDAT run along C0, and LM-63 looks across them along C0.
TEST(Zones, TheStreetSideIsThatOfTheFormat) {
    const Web ahead = *Web::create(Symmetry::bilateral_0_180, {0, 90, 180}, {0, 90}, {100, 50, 50, 25, 0, 0});
    const Web across = rotated(ahead, 90.0).web;
    EXPECT_EQ(street_side_c_deg({"a.ies", IesFile{}, {}}, ahead), 0.0);
    EXPECT_EQ(street_side_c_deg({"a.ies", IesFile{}, {}}, across), 90.0);
    EXPECT_EQ(street_side_c_deg({"a.ldt", LdtFile{}, {}}, ahead), 90.0);
    EXPECT_EQ(street_side_c_deg({"a.ldt", LdtFile{}, {}}, across), 90.0);
}

TEST(CieFluxCode, OfALambertianSource) {
    const CieFluxCode code = cie_flux_code(lambertian(), Lumens(2.0 * pi));
    // Φ up to γ is π sin²γ; cosγ is 3/4, 1/2, 1/4.
    EXPECT_NEAR(*code.within[0], 1.0 - 9.0 / 16.0, 1e-6);
    EXPECT_NEAR(*code.within[1], 0.75, 1e-6);
    EXPECT_NEAR(*code.within[2], 1.0 - 1.0 / 16.0, 1e-6);
    EXPECT_NEAR(*code.downward, 1.0, 1e-12);
    EXPECT_NEAR(*code.light_output_ratio, 0.5, 1e-6);
    EXPECT_EQ(*cie_flux_code(lambertian(), std::nullopt).light_output_ratio, 1.0);
    const Web dark = *Web::create(Symmetry::axial, {0}, {0, 90}, {0, 0});
    EXPECT_FALSE(cie_flux_code(dark, std::nullopt).within[0]);
    EXPECT_FALSE(cie_flux_code(dark, std::nullopt).downward);
}

TEST(SpacingCriterion, OfALambertianSource) {
    // cos⁴γ = ½ and ¼: the handbook's 1.29 and 1.41.
    const SpacingCriterion sc = spacing_criterion(lambertian());
    EXPECT_NEAR(*sc.along_c0, 2.0 * std::tan(std::acos(std::pow(0.5, 0.25))), 1e-6);
    EXPECT_NEAR(*sc.along_c90, *sc.along_c0, 1e-12);
    EXPECT_NEAR(*sc.diagonal, std::sqrt(2.0), 1e-6);
    EXPECT_FALSE(spacing_criterion(*Web::create(Symmetry::axial, {0}, {90, 180}, {5, 5})).along_c0);
}

// Step by step over γ: the earlier method, from before the table's angles were found to be sufficient.
std::optional<double> spacing_by_steps(const Web& web, const std::vector<double>& planes_deg, double share,
                                       double factor) {
    const auto illuminance = [&](double gamma) {
        double sum = 0.0;
        for (const double c : planes_deg)
            sum += web.candela(c, gamma);
        return sum / static_cast<double>(planes_deg.size()) * std::pow(std::cos(gamma * rad), 3);
    };
    const double threshold = share * illuminance(0.0);
    if (!(threshold > 0.0)) return std::nullopt;
    for (double bright = 0.0; bright < 90.0; bright += 0.01) {
        double dark = bright + 0.01;
        if (illuminance(dark) >= threshold) continue;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (bright + dark);
            (illuminance(middle) >= threshold ? bright : dark) = middle;
        }
        return factor * std::tan(bright * rad);
    }
    return std::nullopt;
}

TEST(SpacingCriterion, AsStepByStep) {
    for (const Web& web :
         {lambertian(), random_web(Symmetry::axial, {0}, {0, 3, 7.5, 40, 90}, 1),
          random_web(Symmetry::quadrant, {0, 11, 45, 90}, steps(0, 90, 19), 2),
          random_web(Symmetry::bilateral_0_180, steps(0, 180, 13), {0, 10, 30, 45, 170}, 3),
          random_web(Symmetry::bilateral_90_270, {90, 100, 200, 270}, {0, 20, 35}, 4), // ends while still bright
          random_web(Symmetry::none, {10, 50, 200, 370}, steps(0, 180, 3), 5)}) {
        const SpacingCriterion sc = spacing_criterion(web);
        const double root = std::numbers::sqrt2;
        for (const auto& [found, stepped] : {std::pair{sc.along_c0, spacing_by_steps(web, {0, 180}, 0.5, 2.0)},
                                             {sc.along_c90, spacing_by_steps(web, {90, 270}, 0.5, 2.0)},
                                             {sc.diagonal, spacing_by_steps(web, {45, 135, 225, 315}, 0.25, root)}}) {
            ASSERT_EQ(found.has_value(), stepped.has_value());
            if (found) {
                EXPECT_NEAR(*found, *stepped, 1e-12 * *stepped);
            }
        }
    }
}

TEST(Beam, CieTakesHalfOfTheAxis) {
    // A batwing: 20 cd on the axis, 100 at 30°. The IES beam is at 50 cd, the CIE beam at 10.
    const Web web = *Web::create(Symmetry::axial, {0}, {0, 30, 50, 60, 90}, {20, 100, 100, 0, 0});
    EXPECT_NEAR(to_degrees(*spread_angle(web, 0, 0.5)), 110.0, 1e-9);
    EXPECT_NEAR(to_degrees(*cie_beam_angle(web, 0)), 118.0, 1e-9);
    EXPECT_EQ(center_beam(web).value, 20.0);
    const Web up = *Web::create(Symmetry::axial, {0}, {90, 140, 180}, {0, 0, 100});
    EXPECT_EQ(center_beam(up).value, 100.0);
    EXPECT_NEAR(to_degrees(*cie_beam_angle(up, 0)), 40.0, 1e-9);
    const Web side = *Web::create(Symmetry::axial, {0}, {0, 30, 50}, {0, 100, 0});
    EXPECT_FALSE(cie_beam_angle(side, 0));
}

TEST(Nema, TypesEndWhereTheTableSays) {
    for (const auto& [angle, type] : {std::pair{5.0, 1},
                                      {18.0, 1},
                                      {18.1, 2},
                                      {29.0, 2},
                                      {46.0, 3},
                                      {46.5, 4},
                                      {70.0, 4},
                                      {100.0, 5},
                                      {130.0, 6},
                                      {130.1, 7},
                                      {180.0, 7}})
        EXPECT_EQ(nema_type(degrees(angle)), type) << angle;
}

// Lumens that a laboratory's software printed into a file: the zonal rule reproduces them, to the printed lumen, and to
// a hundredth for the listed files.
TEST(FluxCorpus, TheZonalRuleIsTheIndustrys) {
    namespace fs = std::filesystem;
    const fs::path good = fs::path(test::corpus_folder) / "good";
    if (std::string(test::corpus_folder).empty() || !fs::is_directory(good))
        GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    constexpr double known[] = {9217.18, 5834.20, 13359.57, 5821.76, 753.80, 9230.16, 531.98, 828.32};
    int found = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(good)) {
        const Result<Profile> profile = read_profile_file(entry.path().string());
        const auto* const file = profile ? std::get_if<IesFile>(&profile->file) : nullptr;
        if (file == nullptr) continue;
        for (const IesKeyword& keyword : file->keywords) {
            if (keyword.name != "_ABSOLUTELUMENS") continue;
            const double printed = std::stod(keyword.text);
            const double lumens = zonal_flux(resolve_web(*profile)->web).value;
            EXPECT_NEAR(lumens, printed, 0.5) << entry.path();
            for (const double value : known)
                if (std::round(value) == printed) {
                    EXPECT_NEAR(lumens, value, 0.01) << entry.path();
                }
            ++found;
        }
    }
    EXPECT_GT(found, 0);
}

} // namespace
} // namespace gonio
