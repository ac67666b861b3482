// The exact near field of luminaires with a size, against sums over their openings and against their flux.
#include <gonio/scene/probe.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/web/integrate.hpp>

#include "../light/luminaire.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace gonio {
namespace {

double lux(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
           IrradianceMethod method = IrradianceMethod::exact, double relative_error = 1e-6) {
    const Receiver receiver{position, normal};
    ProbeOptions options;
    options.method = method;
    options.goal.relative_error = relative_error;
    options.threads = 1;
    return probe({&light, 1}, {&receiver, 1}, options).value().illuminance_lx.front();
}

// Σ I(ω) ⟨n·l⟩/(A r²) ΔA over n by n elements of a horizontal rectangle at the origin: independent of luminances, solid
// angles and clipping.
double sum_over(const Light& light, double width_m, double height_m, const glm::dvec3& position,
                const glm::dvec3& normal, int n) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const glm::dvec3 element(((i + 0.5) / n - 0.5) * width_m, ((j + 0.5) / n - 0.5) * height_m, 0.0);
            const glm::dvec3 away = position - element;
            const double r = glm::length(away);
            const double cosine = -glm::dot(away, glm::normalize(normal)) / r;
            if (cosine > 0.0) sum += light.intensity_towards(away).value * cosine / (r * r);
        }
    return sum / (n * n);
}

TEST(NearField, IsTheSumOfTheElementsOfAnOpening) {
    struct Pose {
        glm::dvec3 position, normal;
    };
    // Below, beside, and with the light across the horizon; from a quarter of the longer side on.
    const std::array poses{Pose{{0.1, 0.0, -0.3}, {0, 0, 1}},     Pose{{0.5, 0.2, -0.3}, {0, 0, 1}},
                           Pose{{0.9, 0.1, -0.4}, {-1, 0, 0.2}},  Pose{{0.2, 0.1, -0.5}, {1, 0.1, 0.1}},
                           Pose{{-0.8, 0.9, -1.2}, {0, 0, 1}},    Pose{{0.3, 0.2, -2.5}, {0, 1, 1}},
                           Pose{{3.0, 1.0, -4.0}, {-0.5, 0, 0.8}}};
    for (const char* const formula : {"batwing", "wall-washer", "cosine:power=2"}) {
        const Light light = test::luminaire(formula, "rect:w=1.2m,h=0.3m");
        for (const Pose& pose : poses) {
            // Midpoint sums converge with the square of the step: the last two give the limit.
            const double coarse = sum_over(light, 1.2, 0.3, pose.position, pose.normal, 200);
            const double fine = sum_over(light, 1.2, 0.3, pose.position, pose.normal, 400);
            const double limit = fine + (fine - coarse) / 3.0;
            EXPECT_NEAR(lux(light, pose.position, pose.normal), limit, 1e-4 * limit + 1e-6 * light.intensity.value)
                << formula << " at " << pose.position.x << ", " << pose.position.y << ", " << pose.position.z;
        }
    }
}

// What crosses a closed box around a luminaire is its flux.
TEST(NearField, CarriesTheFluxThroughABox) {
    // Gauss–Legendre nodes on each half of an edge, since the light's own plane crosses the middle.
    constexpr std::array nodes{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842, 0.953089922969332};
    constexpr std::array weights{0.118463442528095, 0.239314335249683, 0.284444444444444, 0.239314335249683,
                                 0.118463442528095};
    for (const char* const opening :
         {"rect:w=60cm,h=20cm", "disk:r=20cm", "box:w=50cm,h=20cm,d=10cm", "sphere:r=15cm"}) {
        const Light light = test::luminaire("cosine:up=0.5", opening);
        const double flux_lm = flux(*std::get<ProfileShape>(light.shape).web).value;
        constexpr double half = 1.0; // of the box's edge [m]
        double sum = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                for (std::size_t i = 0; i < 10; ++i)
                    for (std::size_t j = 0; j < 10; ++j) {
                        const auto along = [&](std::size_t k) {
                            return half * (nodes.at(k % 5) - (k < 5 ? 1.0 : 0.0));
                        };
                        glm::dvec3 at(0.0);
                        at[axis] = side * half;
                        at[(axis + 1) % 3] = along(i);
                        at[(axis + 2) % 3] = along(j);
                        glm::dvec3 inward(0.0);
                        inward[axis] = -side;
                        sum += lux(light, at, inward, IrradianceMethod::reference, 3e-5) * half * half *
                               weights.at(i % 5) * weights.at(j % 5);
                    }
        EXPECT_NEAR(sum, flux_lm, 1e-3 * flux_lm) << opening;
    }
}

TEST(NearField, BecomesThePointFarAway) {
    const Light light = test::luminaire("batwing", "rect:w=1m,h=0.2m");
    for (const glm::dvec3 direction : {glm::dvec3(0, 0, -1), glm::dvec3(0.3, 0.2, -1), glm::dvec3(0.6, 0.1, -1)}) {
        const glm::dvec3 at = 30.0 * glm::normalize(direction);
        const double far = lux(light, at, -direction, IrradianceMethod::point);
        EXPECT_NEAR(lux(light, at, -direction), far, 1e-3 * far);
    }
}

TEST(NearField, SaysWhereAPointIsNotEnough) {
    LightDescription description;
    ProfileShape shape{"made.ies", test::authored_web("batwing")};
    shape.declared = std::make_shared<const Opening>(parse_opening("rect:w=1m,h=0.2m").value());
    const auto near = [&](ProfileSize size, double distance) {
        shape.size = size;
        description.shape = shape;
        Diagnostics ignored;
        const Light light = resolve_light(description, ignored).value();
        const Receiver receiver{{0.0, 0.0, -distance}, {0.0, 0.0, 1.0}};
        return probe({&light, 1}, {&receiver, 1}, {}).value().remarks.near_point.count;
    };
    EXPECT_EQ(near(ProfileSize::unsaid, 4.9), 1U);
    EXPECT_EQ(near(ProfileSize::unsaid, 5.1), 0U);
    EXPECT_EQ(near(ProfileSize::point, 1.0), 0U);
    EXPECT_EQ(near(ProfileSize::opening, 1.0), 0U);
}

} // namespace
} // namespace gonio
