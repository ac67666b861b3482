// Intensities are limited to 1e30 cd: everything that makes a web refuses larger values, and nothing becomes infinite.
#include <gonio/base/amount_range.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/author_csv.hpp>
#include <gonio/web/combine.hpp>
#include <gonio/web/luminaire.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/to_profile.hpp>
#include <gonio/web/transform.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace gonio {
namespace {

Web uniform(double cd) {
    return *Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {cd, cd});
}

template<class T>
std::string reason(const Result<T>& result) {
    return result ? "no failure" : to_text(result.error().diagnostics.back());
}

TEST(AmountRange, AWebHoldsIntensitiesUpToIt) {
    EXPECT_TRUE(Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {1e30, -1e30}));
    for (const double wrong : {1.000001e30, -1e31, 1.7e308, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
        const auto web = Web::create(Symmetry::axial, {0.0}, {0.0, 180.0}, {1.0, wrong});
        ASSERT_FALSE(web) << wrong;
        EXPECT_EQ(web.error().failure, Failure::malformed);
        EXPECT_NE(reason(web).find("is not a finite number up to 1e+30 cd"), std::string::npos) << reason(web);
    }
}

TEST(AmountRange, NoFactorLeadsOutOfIt) {
    const Web web = uniform(1e20);
    EXPECT_EQ(peak(*scaled_by(web, 1e10)).intensity.value, 1e30);
    EXPECT_EQ(reason(scaled_by(web, 1e17)), "error[USE0106]: a factor of 1e+17 makes 1e+20 cd more than 1e+30 cd");
    for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::infinity()})
        EXPECT_FALSE(scaled_by(web, wrong)) << wrong;
    // With almost no light, the factor is out of the range of double.
    EXPECT_FALSE(scaled_to(uniform(1e-320), Lumens(1.0)));
    EXPECT_NEAR(peak(*scaled_to(uniform(1e-300), Lumens(12.566370614359172))).intensity.value, 1.0, 1e-12);
    const Luminaire bright{uniform(1e30), {}};
    EXPECT_FALSE(dimmed(bright, 1.5));
    EXPECT_TRUE(dimmed(bright, 0.5));
    EXPECT_FALSE(combined(std::vector{bright, bright}, std::vector{1.0, 1.0}));
}

TEST(AmountRange, AFluxThatMakesMoreIsRefused) {
    const Result<AuthoredShape> shape = parse_authored("cosine:power=1");
    ASSERT_TRUE(shape) << reason(shape);
    AuthorOptions options;
    options.flux = Lumens(1e40);
    const auto web = authored(*shape, options);
    ASSERT_FALSE(web);
    EXPECT_EQ(web.error().failure, Failure::usage);
    EXPECT_NE(reason(web).find("a flux of 1e+40 lm makes an intensity of "), std::string::npos) << reason(web);
}

TEST(AmountRange, ATableNamesThePlace) {
    EXPECT_EQ(reason(web_from_csv("g,0,90\n0,1,2\n", "t.csv")), "no failure");
    EXPECT_EQ(reason(web_from_csv("g,0,90\n0,1,1e31\n", "t.csv")),
              "t.csv:2:5: error[INP0101]: 1e+31 is above 1e+30 in magnitude");
}

// A web in range, with a header or a flux that takes it out of range.
TEST(AmountRange, AFileThatNoReaderWouldTakeIsNotMade) {
    ProfileHeader header;
    header.source = "lamp";
    header.lamp_flux_lm = 1e31;
    for (const ProfileTarget target : {ProfileTarget::lm63_2002, ProfileTarget::eulumdat, ProfileTarget::tm33}) {
        const auto made = to_profile(uniform(100.0), header, target);
        ASSERT_FALSE(made) << to_text(target);
        EXPECT_EQ(made.error().failure, Failure::malformed);
        EXPECT_EQ(reason(made).substr(0, 25), "lamp: error[INP0101]: the") << reason(made);
    }
    header.lamp_flux_lm = 1e-300;
    EXPECT_TRUE(to_profile(uniform(100.0), header, ProfileTarget::lm63_2002));
    EXPECT_FALSE(to_profile(uniform(100.0), header, ProfileTarget::eulumdat)); // candela per 1000 lm
}

} // namespace
} // namespace gonio
