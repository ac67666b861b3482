#include <gonio/web/author.hpp>
#include <gonio/web/author_csv.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/luminaire.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/to_profile.hpp>

#include "webs.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gonio {
namespace {

using test::steps;

constexpr double rad = std::numbers::pi / 180.0;

Web made(std::string_view text, AuthorOptions options = {}) {
    return *authored(*parse_authored(text), options);
}

TEST(Author, EveryKindHasTheFluxAndTheSymmetryThatItSays) {
    for (const AuthoredKind& kind : authored_kinds()) {
        const AuthoredShape shape = *parse_authored(kind.kind);
        for (const Photometry type : {Photometry::a, Photometry::b, Photometry::c}) {
            AuthorOptions options;
            options.photometry = type;
            options.flux = Lumens(1234.5);
            const Web web = *authored(shape, options);
            EXPECT_EQ(web.photometry(), type);
            EXPECT_NEAR(flux(web).value, 1234.5, 1e-6 * 1234.5) << kind.kind;
            if (type == Photometry::c) {
                EXPECT_EQ(web.stored_symmetry(), shape.symmetry);
            }
            // A table written out by hand has the mirrors that the shape declares.
            AuthoredShape plain = shape;
            plain.symmetry = Symmetry::none;
            EXPECT_LE(difference(*authored(plain, options), web).relative, 1e-6) << kind.kind;
        }
    }
}

TEST(Author, ShapesAreTheirFormulas) {
    AuthorOptions fine;
    fine.vertical_step_deg = 0.5;
    fine.horizontal_step_deg = 2.5;
    EXPECT_NEAR(to_degrees(*spread_angle(made("gaussian:beam=24deg", fine), 0, 0.5)), 24.0, 0.01);
    const Web cosine = made("cosine:power=3", fine);
    EXPECT_NEAR(cosine.candela(0, 60) / cosine.candela(0, 0), 0.125, 1e-6);
    EXPECT_EQ(cosine.candela(0, 91), 0.0);
    const Web up = made("cosine:power=1,up=0.5", fine);
    EXPECT_NEAR(up.candela(0, 180) / up.candela(0, 0), 0.5, 1e-6);
    // A batwing is as bright on the floor at its reach as directly below it.
    const Web wings = made("batwing:reach=50deg,across=30deg", fine);
    EXPECT_NEAR(wings.candela(0, 50) * std::pow(std::cos(50 * rad), 3) / wings.candela(0, 0), 1.0, 1e-6);
    EXPECT_NEAR(wings.candela(90, 30) * std::pow(std::cos(30 * rad), 3) / wings.candela(0, 0), 1.0, 1e-6);
    EXPECT_LT(wings.candela(90, 50) / wings.candela(0, 50), 0.01);
    const Peak washer = peak(made("wall-washer:lean=40deg", fine));
    EXPECT_EQ(washer.c_deg, 0.0);
    EXPECT_NEAR(washer.gamma_deg, 37.0, 2.0);
    const Web road = made("street", fine);
    EXPECT_NEAR(peak(road).gamma_deg, 60.0, 2.0);
    EXPECT_GT(road.candela(90, 60), road.candela(270, 60));
    const Web tube = made("tube:r=10mm,l=1m", fine);
    EXPECT_NEAR(tube.candela(0, 90) / tube.candela(90, 90), std::numbers::pi * 1e-4 / (2e-2 + std::numbers::pi * 1e-4),
                1e-6);
}

TEST(Author, TakesItsDefaultsWhereNothingFollowsTheColon) {
    for (const AuthoredKind& kind : authored_kinds()) {
        const auto begun = parse_authored(std::string(kind.kind) + ":");
        ASSERT_TRUE(begun) << kind.kind;
        EXPECT_EQ(difference(*authored(*begun, {}), made(kind.kind)).relative, 0.0) << kind.kind;
    }
}

// A Gaussian of 10° is 1e-90 at the horizon, and some readers take "1e-90" as 1.
TEST(Author, FilesHaveNoExponents) {
    for (const AuthoredKind& kind : authored_kinds())
        for (const std::string keys : {"", ":beam=10deg"})
            for (const double lumens : {1e-3, 800.0, 1e6}) {
                const auto shape = parse_authored(std::string(kind.kind) + keys);
                if (!shape) continue; // it has no beam angle
                AuthorOptions options;
                options.flux = Lumens(lumens);
                const Web web = *authored(*shape, options);
                for (const ProfileTarget target :
                     {ProfileTarget::lm63_2002, ProfileTarget::eulumdat, ProfileTarget::portable}) {
                    const std::string text = write_profile(to_profile(web, {}, target)->profile, target);
                    const std::size_t exponent = text.find("e-");
                    EXPECT_EQ(exponent, std::string::npos) << kind.kind << ": " << text.substr(exponent - 12, 20);
                }
                EXPECT_NEAR(flux(web).value, lumens, 1e-6 * lumens) << kind.kind;
            }
}

TEST(Author, RefusesWhatMakesNoSense) {
    for (const char* text : {"spt", "cosine:power=-1", "cosine:pow=1", "gaussian:beam=200deg", "gaussian:beam=30",
                             "batwing:reach=90deg", "tube:r=0m", "cosine:power=x", "street:out=0deg"})
        EXPECT_FALSE(parse_authored(text)) << text;
    const AuthoredShape shape = *parse_authored("cosine");
    AuthorOptions options;
    options.vertical_step_deg = 7.0;
    EXPECT_FALSE(authored(shape, options));
    options.vertical_step_deg = 0.01;
    EXPECT_FALSE(authored(shape, options));
    options = {};
    options.flux = Lumens(0.0);
    EXPECT_FALSE(authored(shape, options));
    const AuthoredShape dark{[](double, double) { return 0.0; }, Symmetry::axial, 90.0};
    EXPECT_FALSE(authored(dark, {}));
    const AuthoredShape broken{[](double, double) { return -1.0; }, Symmetry::axial, 90.0};
    EXPECT_FALSE(authored(broken, {}));
}

TEST(Csv, IsReadAsSpreadsheetsWriteIt) {
    const Web web = *web_from_csv("\xef\xbb\xbf"
                                  "C \\ gamma;0;45;90\r\n# a remark\r\n\r\n0;100;50;0\r\n90;100;80;0\r\n",
                                  "t.csv");
    EXPECT_EQ(web.stored_symmetry(), Symmetry::quadrant);
    EXPECT_EQ(web.candela(0, 45), 50.0);
    EXPECT_EQ(web.candela(270, 45), 80.0);
    EXPECT_EQ(web_from_csv(",0,90\n0,5,0\n", "t")->stored_symmetry(), Symmetry::axial);
}

TEST(Csv, SaysWhereItIsWrong) {
    const auto place = [](std::string_view text) {
        const Result<Web> web = web_from_csv(text, "t.csv");
        EXPECT_FALSE(web) << text;
        return web ? Location{} : web.error().diagnostics.back().location;
    };
    EXPECT_EQ(place("x,0,90\n0,5,oh\n").line, 2U);
    EXPECT_EQ(place("x,0,90\n0,5,oh\n").column, 5U);
    EXPECT_EQ(place("x,0,90\n\n0,5\n").line, 3U);
    // Messages quote nothing from a text that is another kind of file.
    const auto said = [](std::string_view text) {
        return web_from_csv(text, "t.csv").error().diagnostics.back().message;
    };
    EXPECT_EQ(said("x,0,90\n0,5,oh\n"), "'oh' is not a number");
    EXPECT_EQ(said("root:x:0\nmallory:hunter2:1\n"), "not a table of candela");
    EXPECT_EQ(said("name,hunter2\n"), "not a table of candela");
    EXPECT_EQ(place("").file, "t.csv");
    EXPECT_EQ(place("x,0,90\n").file, "t.csv");
    EXPECT_EQ(place("x,90,0\n0,1,2\n").file, "t.csv");
    EXPECT_EQ(place("x,0,45,45\n0,1,2,3\n").line, 1U);
    EXPECT_EQ(place("x,0,90\n90,1,2\n90,1,2\n").line, 3U);
}

TEST(Luminaire, StretchesWithItsFluxAndLength) {
    Luminaire lamp{test::random_web(Symmetry::quadrant, steps(0, 90, 7), steps(0, 90, 7), 1), {}};
    lamp.header.opening = {OpeningShape::rectangle, 0.1, 1.2, 0.0};
    lamp.header.lamp_flux_lm = 3000.0;
    lamp.header.input_watts = 30.0;
    lamp.header.length_m = 1.25;
    const Luminaire longer = *stretched(lamp, 1.5);
    EXPECT_NEAR(flux(longer.web).value, 1.5 * flux(lamp.web).value, 1e-9);
    EXPECT_DOUBLE_EQ(*longer.header.lamp_flux_lm, 4500.0);
    EXPECT_DOUBLE_EQ(longer.header.input_watts, 45.0);
    EXPECT_DOUBLE_EQ(longer.header.opening.length_m, 1.8);
    EXPECT_DOUBLE_EQ(longer.header.opening.width_m, 0.1);
    EXPECT_DOUBLE_EQ(longer.header.length_m, 1.875);
    EXPECT_FALSE(stretched(lamp, 0.0));
    EXPECT_FALSE(stretched(lamp, -1.0));
    lamp.header.opening.shape = OpeningShape::disk;
    EXPECT_FALSE(stretched(lamp, 2.0));
    const Luminaire dim = *dimmed(lamp, 0.25);
    EXPECT_DOUBLE_EQ(*dim.header.lamp_flux_lm, 750.0);
    EXPECT_DOUBLE_EQ(dim.header.input_watts, 30.0);
    EXPECT_NEAR(flux(scaled_to(lamp, Lumens(500.0))->web).value, 500.0, 1e-9);
}

TEST(Luminaire, CombinesWattsAndLampsByWeight) {
    std::vector<Luminaire> both(2, {test::random_web(Symmetry::axial, {0}, steps(0, 90, 7), 1), {}});
    both[0].header.lamp_flux_lm = 1000.0;
    both[1].header.lamp_flux_lm = 3000.0;
    both[0].header.input_watts = 10.0;
    both[1].header.input_watts = 30.0;
    const std::vector<double> weights{0.75, 0.25};
    const CombinedLuminaire mix = *combined(both, weights);
    EXPECT_DOUBLE_EQ(*mix.luminaire.header.lamp_flux_lm, 1500.0);
    EXPECT_DOUBLE_EQ(mix.luminaire.header.input_watts, 15.0);
    EXPECT_LE(difference(mix.luminaire.web, both[0].web).relative, 1e-12);
    both[1].header.lamp_flux_lm.reset();
    EXPECT_FALSE(combined(both, weights)->luminaire.header.lamp_flux_lm);
    EXPECT_FALSE(combined(both, std::vector<double>{1.0}));
}

TEST(DirectRatios, OfANarrowBeamAreOneAndOfUplightNothing) {
    const std::array<double, 10> beam = direct_ratios(made("gaussian:beam=5deg"));
    const std::array<double, 10> wide = direct_ratios(made("cosine"));
    for (std::size_t i = 0; i < beam.size(); ++i) {
        EXPECT_GT(beam[i], 0.9);
        EXPECT_GT(beam[i], wide[i]);
        if (i > 0) {
            EXPECT_GT(wide[i], wide[i - 1]);
        }
    }
    // A Lambertian ceiling and the floor of a cube (k = ½·a/h = ½…): the form factor of a square room of index 1, two
    // squares of side 2h at distance h, is 0.4153 (Siegel and Howell, configuration C-11).
    EXPECT_NEAR(wide[2], 0.4153, 5e-4);
    const Web up = *Web::create(Symmetry::axial, {0}, {90, 180}, {1, 1});
    for (const double ratio : direct_ratios(up))
        EXPECT_EQ(ratio, 0.0);
}

} // namespace
} // namespace gonio
