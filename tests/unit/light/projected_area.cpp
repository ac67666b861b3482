// Projected areas: of solids by the mean over all directions, a quarter of the surface (Cauchy), and against the faces
// of LuminousBody.
#include <gonio/light/luminous_body.hpp>
#include <gonio/light/projected_area.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio {
namespace {

constexpr double pi = std::numbers::pi;

Opening opening(OpeningShape shape, glm::dvec3 size_m) {
    Opening made;
    made.shape = shape;
    made.size_m = size_m;
    made.side_heights_m.fill(size_m.z);
    return made;
}

template<class Function>
void for_directions(const Function& function) {
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt(1.0 - z * z);
        function(glm::dvec3(r * std::cos(2.399963 * i), r * std::sin(2.399963 * i), z), 1.0 / count);
    }
}

double mean_of(const Opening& of) {
    double mean = 0.0;
    for_directions(
        [&](const glm::dvec3& direction, double weight) { mean += weight * projected_area_m2(of, direction); });
    return mean;
}

TEST(ProjectedArea, OfConvexSolidsIsAQuarterOfTheSurfaceOnAverage) {
    const double d = 0.3;
    const double l = 1.1;
    EXPECT_NEAR(mean_of(opening(OpeningShape::sphere, {d, d, d})), pi * d * d / 4.0, 1e-12);
    const double cylinder = (pi * d * l + pi * d * d / 2.0) / 4.0;
    EXPECT_NEAR(mean_of(opening(OpeningShape::vertical_cylinder, {d, d, l})), cylinder, 1e-4);
    EXPECT_NEAR(mean_of(opening(OpeningShape::horizontal_cylinder, {l, d, d})), cylinder, 1e-4);
    EXPECT_NEAR(mean_of(opening(OpeningShape::horizontal_cylinder_across, {d, l, d})), cylinder, 1e-4);
    // An ellipsoid of revolution has a surface in closed form.
    const double e = std::sqrt(1.0 - (d * d) / (l * l));
    const double spheroid = pi * d * d / 2.0 * (1.0 + l / (d * e) * std::asin(e));
    EXPECT_NEAR(mean_of(opening(OpeningShape::ellipsoid, {d, d, l})), spheroid / 4.0, 1e-5);
}

TEST(ProjectedArea, OfFlatOnesIsTheirCosine) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.4, -0.8));
    EXPECT_NEAR(projected_area_m2(opening(OpeningShape::rectangle, {0.2, 0.5, 0.0}), direction), -0.1 * direction.z,
                1e-15);
    EXPECT_NEAR(projected_area_m2(opening(OpeningShape::ellipse, {0.2, 0.5, 0.0}), direction),
                -0.1 * pi / 4.0 * direction.z, 1e-15);
    EXPECT_EQ(projected_area_m2(opening(OpeningShape::rectangle, {0.2, 0.5, 0.0}), -direction), 0.0);
    EXPECT_NEAR(projected_area_m2(opening(OpeningShape::upright_disk, {0.4, 0.0, 0.4}), direction),
                -0.16 * pi / 4.0 * direction.y, 1e-15);
    EXPECT_EQ(projected_area_m2({}, direction), 0.0);
}

TEST(ProjectedArea, OfABoxIsThatOfItsFaces) {
    Opening box = opening(OpeningShape::box, {0.2, 0.9, 0.3});
    box.side_heights_m = {0.3, 0.1, 0.2, 0.05};
    const Web web = *Web::create(Symmetry::axial, {0.0}, {0.0, 90.0}, {100.0, 0.0});
    const auto body = LuminousBody::of(box, web);
    ASSERT_TRUE(body);
    for_directions([&](const glm::dvec3& direction, double) {
        EXPECT_NEAR(projected_area_m2(box, direction), body->projected_area_m2(direction), 1e-12);
    });
}

} // namespace
} // namespace gonio
