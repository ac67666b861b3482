// Luminous openings: their grammar, their faces, and what they say about odd files.
#include <gonio/light/light_parts.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>

#include "../web/webs.hpp"
#include "luminaire.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;

glm::dvec3 towards(double c_deg, double gamma_deg) {
    return direction_of({degrees(c_deg), degrees(gamma_deg)});
}

LuminousBody body_of(const Opening& opening, const std::string& formula = "cosine:up=1") {
    return LuminousBody::of(opening, *test::authored_web(formula)).value();
}
LuminousBody body_of(const std::string& opening, const std::string& formula = "cosine:up=1") {
    return body_of(parse_opening(opening).value(), formula);
}

std::string message(const Result<Opening>& refused) {
    return refused ? std::string() : refused.error().diagnostics.back().message;
}

TEST(Opening, HasAGrammar) {
    const Opening rect = parse_opening("rect:w=1.2m,h=30cm").value();
    EXPECT_EQ(rect.shape, OpeningShape::rectangle);
    EXPECT_EQ(rect.size_m, glm::dvec3(1.2, 0.3, 0.0));
    EXPECT_EQ(parse_opening("disk:d=20cm").value().size_m, glm::dvec3(0.2, 0.2, 0.0));
    EXPECT_EQ(parse_opening("cylinder:r=5cm,l=30cm").value().size_m, glm::dvec3(0.1, 0.1, 0.3));
    EXPECT_EQ(parse_opening("tube:radius=5cm,length=1m").value().size_m, glm::dvec3(1.0, 0.1, 0.1));
    EXPECT_EQ(parse_opening("point").value().shape, OpeningShape::point);
    EXPECT_EQ(message(parse_opening("rekt:w=1m")), "unknown opening 'rekt'");
    EXPECT_EQ(message(parse_opening("rect:w=1m")), "'rect' needs h=LENGTH");
    EXPECT_NE(message(parse_opening("rect:w=0m,h=1m")), "");
    EXPECT_NE(message(parse_opening("disk:r=1m,w=1m")), "");
}

TEST(Opening, ComesAfterTheFileOfAProfile) {
    const auto profile = [](const char* text) { return std::get<ProfileShape>(parse_shape(text).value()); };
    EXPECT_EQ(profile("ies:a,b.ies").size, ProfileSize::unsaid);
    EXPECT_EQ(profile("ies:a,b.ies,opening").file, "a,b.ies");
    EXPECT_EQ(profile("ies:a,b.ies,opening").size, ProfileSize::opening);
    EXPECT_EQ(profile("ies:a.ies,opening=off").size, ProfileSize::point);
    EXPECT_EQ(profile("ies:a.ies,opening=point").size, ProfileSize::point);
    EXPECT_EQ(profile("ies:a.ies,opening=box:w=1m,h=2m,d=3m").given->size_m, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(profile("ies:a,openings.ies").file, "a,openings.ies");
    EXPECT_FALSE(parse_shape("ies:a.ies,opening=wide"));
    EXPECT_FALSE(parse_shape("ies:,opening"));
}

// EULUMDAT measures its width along C0, LM-63 its length.
TEST(Opening, LiesAsItsFileSays) {
    IesFile ies;
    ies.width = 0.1;
    ies.length = 1.5;
    EXPECT_EQ(opening_of({{}, ies, {}}).size_m, glm::dvec3(1.5, 0.1, 0.0));
    LdtFile ldt;
    ldt.luminous_width_mm = 100.0;
    ldt.luminous_length_mm = 1500.0;
    ldt.luminous_height_c90_mm = 40.0;
    const Opening box = opening_of({{}, ldt, {}});
    EXPECT_EQ(box.size_m, glm::dvec3(0.1, 1.5, 0.04));
    EXPECT_EQ(box.side_heights_m, (std::array<double, 4>{0.0, 0.04, 0.0, 0.0}));
    EXPECT_EQ(opening_of({{}, IesFile(), {}}).shape, OpeningShape::point);
}

// A_proj = w l |cosγ| + sinγ (l h |cosC| + w h' |sinC|), each h that of the side that faces the direction.
TEST(LuminousBody, ProjectsABoxOfEulumdat) {
    LdtFile ldt;
    ldt.luminous_length_mm = 1208.0;
    ldt.luminous_width_mm = 105.0;
    ldt.luminous_height_c0_mm = ldt.luminous_height_c180_mm = 51.0;
    const LuminousBody body = body_of(opening_of({{}, ldt, {}}));
    const auto projected = [&](double c, double gamma) { return body.projected_area_m2(towards(c, gamma)); };
    EXPECT_NEAR(projected(0, 60), 0.11677409, 5e-9);
    EXPECT_NEAR(projected(90, 60), 0.06342, 5e-9);
    EXPECT_NEAR(projected(45, 85), 0.05445250, 5e-9);
    EXPECT_NEAR(projected(0, 90), 0.061608, 5e-9);
    EXPECT_NEAR(projected(200, 120), projected(160, 60), 1e-12);
}

// A prism of twelve sides: within 1.2 % of the cylinder, and on average equal to it.
TEST(LuminousBody, ProjectsACylinder) {
    const LuminousBody body = body_of("cylinder:d=20cm,l=10cm");
    EXPECT_NEAR(body.projected_area_m2(towards(0, 0)), 0.03141593, 1e-8);
    double sum = 0.0;
    for (int c = 0; c < 360; ++c) {
        const double at_45 = body.projected_area_m2(towards(c, 45));
        EXPECT_NEAR(at_45, 0.03635655, 0.012 * 0.03635655);
        sum += body.projected_area_m2(towards(c, 90)) / 360.0;
    }
    EXPECT_NEAR(sum, 0.02, 1e-6);
    EXPECT_NEAR(body_of("tube:d=10cm,l=1m").projected_area_m2({1.0, 0.0, 0.0}), 0.25 * pi * 0.01, 1e-9);
}

TEST(LuminousBody, HasTheAreaOfASphere) {
    const LuminousBody body = body_of("sphere:r=10cm");
    for (const double gamma : {0.0, 40.0, 90.0, 180.0})
        EXPECT_NEAR(body.projected_area_m2(towards(30, gamma)), pi * 0.01, 1e-12);
}

// The intensities of the faces add up to the measured ones in every direction that the opening has.
TEST(Luminaire, EmitsWhatWasMeasuredAsFromFarAway) {
    for (const char* const formula : {"batwing", "wall-washer", "cosine:up=0.5", "gaussian:beam=20deg"})
        for (const char* const opening : {"rect:w=1.2m,h=5cm", "disk:r=10cm", "ellipse:w=30cm,h=10cm",
                                          "box:w=60cm,h=30cm,d=5cm", "cylinder:r=4cm,l=20cm", "sphere:r=15cm"}) {
            const Light light = test::luminaire(formula, opening);
            ASSERT_NE(light.parts, nullptr) << formula << " " << opening;
            const Web& web = *std::get<ProfileShape>(light.shape).web;
            for (double c = 3.0; c < 360.0; c += 37.0)
                for (double gamma = 2.0; gamma < 180.0; gamma += 11.0) {
                    double sum = 0.0;
                    for (const Light& face : *light.parts)
                        sum += face.intensity_towards(towards(c, gamma)).value;
                    const double measured = web.candela(towards(c, gamma));
                    EXPECT_NEAR(sum, measured, 1e-12 * light.intensity.value)
                        << formula << " " << opening << " at " << c << ", " << gamma;
                }
        }
}

// The faces turn with the light, and keep its amount and colour.
TEST(Luminaire, IsPlacedWithItsLight) {
    LightDescription description;
    description.position = {1.0, 2.0, 3.0};
    description.direction = {1.0, 0.0, 0.0};
    description.color = {0.5, 1.1, 0.7};
    ProfileShape shape{"made.ies", test::authored_web("wall-washer"), ProfileSize::opening};
    shape.given = std::make_shared<const Opening>(parse_opening("box:w=60cm,h=30cm,d=10cm").value());
    description.shape = shape;
    description.intensity = parse_photometric_value("2000lm").value();
    Diagnostics diagnostics;
    const Light light = resolve_light(description, diagnostics).value();
    for (const glm::dvec3 direction : {glm::dvec3(1, 0.3, 0.2), glm::dvec3(0.2, -1, 0.4), glm::dvec3(0.4, 0.1, -1)}) {
        double sum = 0.0;
        for (const Light& face : *light.parts)
            sum += face.intensity_towards(direction).value;
        EXPECT_NEAR(sum, light.intensity_towards(direction).value, 1e-9 * light.intensity.value);
    }
    for (const Light& face : *light.parts)
        EXPECT_EQ(face.color, description.color);
    EXPECT_NEAR(glm::dot(light.parts->front().frame.origin - description.position, description.direction), 0.05, 1e-12);
}

TEST(Luminaire, OneSidedLightHasOneFace) {
    EXPECT_EQ(test::luminaire("batwing", "rect:w=1m,h=1m").parts->size(), 1U);
    EXPECT_EQ(test::luminaire("cosine:up=1", "rect:w=1m,h=1m").parts->size(), 2U);
    EXPECT_EQ(test::luminaire("batwing", "box:w=1m,h=1m,d=1m").parts->size(), 5U);
    EXPECT_EQ(test::luminaire("batwing", "rect:w=1m,h=1m", ProfileSize::point).parts, nullptr);
    EXPECT_EQ(test::luminaire("batwing", "rect:w=1m,h=1m", ProfileSize::unsaid).parts, nullptr);
}

Diagnostics said_of(const std::string& formula, const Opening& opening, ProfileSize size) {
    LightDescription description;
    ProfileShape shape{"made.ies", test::authored_web(formula), size};
    shape.declared = std::make_shared<const Opening>(opening);
    description.shape = shape;
    Diagnostics diagnostics;
    EXPECT_TRUE(resolve_light(description, diagnostics));
    return diagnostics;
}

TEST(Luminaire, SaysWhatIsOddAboutAnOpening) {
    const Opening rect = parse_opening("rect:w=1m,h=1m").value();
    EXPECT_TRUE(said_of("batwing", rect, ProfileSize::opening).empty());
    EXPECT_EQ(said_of("batwing", Opening(), ProfileSize::opening).at(0).code, "RES0404");
    EXPECT_TRUE(said_of("batwing", Opening(), ProfileSize::declared).empty());
    EXPECT_EQ(said_of("batwing", parse_opening("rect:w=120m,h=60m").value(), ProfileSize::declared).at(0).code,
              "RES0405");
    const Diagnostics behind = said_of("cosine:up=0.25", rect, ProfileSize::opening);
    ASSERT_EQ(behind.size(), 1U);
    EXPECT_EQ(behind[0].code, "RES0406");
    EXPECT_NE(behind[0].message.find("200 lm, 20 %"), std::string::npos) << behind[0].message;
}

TEST(ShiningLights, ReplaceLuminairesByTheirFaces) {
    const std::vector<Light> lights{test::luminaire("batwing", "rect:w=1m,h=1m", ProfileSize::point),
                                    test::luminaire("batwing", "box:w=1m,h=1m,d=1m")};
    const ShiningLights shining(lights);
    EXPECT_EQ(shining.all().size(), 6U);
    EXPECT_EQ(ShiningLights(lights, false).all().data(), lights.data());
    EXPECT_EQ(ShiningLights({lights.data(), 1}).all().data(), lights.data());
}

} // namespace
} // namespace gonio
