#include <gonio/light/luminances.hpp>

#include "../preview/numbers.hpp"
#include "luminaire.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace gonio {
namespace {

void expect_those_of(const Light& light, const std::string& name) {
    constexpr std::size_t count = 300;
    test::Numbers numbers(3);
    LuminanceShares shares(light);
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 local = numbers.direction();
        x.push_back(local.x);
        y.push_back(local.y);
        z.push_back(local.z);
    }
    std::vector<double> found(count, -1.0);
    shares.along(x, y, z, found);
    std::size_t lit = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double expected = light.luminance_share(shares.frame().to_world({x[i], y[i], z[i]}));
        EXPECT_NEAR(found[i], expected, 1e-9 * expected) << name << ' ' << i;
        lit += expected > 0.0 ? 1U : 0U;
    }
    EXPECT_GT(lit, count / 10) << name;
}

TEST(LuminanceShares, AreThoseOfTheLight) {
    for (const char* const opening : {"rect:w=60cm,h=30cm", "ellipse:w=60cm,h=20cm", "box:w=40cm,h=30cm,d=10cm",
                                      "sphere:d=20cm", "cylinder:d=10cm,l=60cm"})
        for (const char* const formula : {"wall-washer", "cosine:power=3,up=0.5"}) {
            const Light light = test::luminaire(formula, opening);
            ASSERT_TRUE(light.parts) << opening;
            for (const Light& face : *light.parts)
                expect_those_of(face, std::string(formula) + " on " + opening);
        }
    LightDescription description;
    description.shape = test::shape("disk:r=15cm");
    std::get<DiskShape>(description.shape).mask = test::authored_web("cosine:power=3,up=0.5");
    description.intensity = parse_photometric_value("1nt").value();
    Diagnostics ignored;
    expect_those_of(resolve_light(description, ignored).value(), "mask");
}

} // namespace
} // namespace gonio
