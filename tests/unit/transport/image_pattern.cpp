// The fast ways of images, against the exact ones.
#include <gonio/scene/image_illuminance.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/intensity_pattern.hpp>
#include <gonio/transport/luminance_pattern.hpp>

#include "../light/light_images.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace gonio {
namespace {

struct Poses {
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;

    void add(const glm::dvec3& at, const glm::dvec3& up) {
        for (int axis = 0; axis < 3; ++axis) {
            position.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(at[axis]));
            normal.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(up[axis]));
        }
    }
    std::size_t size() const { return position[0].size(); }
    glm::dvec3 at(std::size_t i) const { return {position[0][i], position[1][i], position[2][i]}; }
    glm::dvec3 up(std::size_t i) const { return glm::normalize(glm::dvec3(normal[0][i], normal[1][i], normal[2][i])); }
    transport::Receivers receivers() const {
        return {{position[0].data(), position[1].data(), position[2].data()},
                {normal[0].data(), normal[1].data(), normal[2].data()},
                size()};
    }
};

// Receivers at a distance before the plane of the light, over it and beside it; half of them face it.
Poses poses(double distance_m, std::size_t count) {
    std::mt19937 numbers(11);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(numbers() >> 5U) / static_cast<double>(1U << 27U);
    };
    Poses made;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 at(between(-1.0, 1.0), between(-1.0, 1.0), -distance_m);
        glm::dvec3 up(0.0, 0.0, 1.0);
        if (i % 2 == 1) up = glm::normalize(glm::dvec3(between(-1, 1), between(-1, 1), between(-0.2, 1)));
        made.add(at, up);
    }
    return made;
}

std::vector<float> shares(const Light& light, const Poses& of, simd::InstructionSet set) {
    detail::LuminanceTables tables;
    detail::WebTables webs;
    const detail::LuminancePattern pattern(light, tables, webs);
    std::vector<float> share;
    pattern.evaluate(of.receivers(), glm::dvec3(0.0), transport::luminance_kernels(set),
                     transport::intensity_kernels(set), share);
    return share;
}

TEST(ImagePattern, IsNearTheSumOverPixelsAtEveryDistance) {
    for (const char* const shape : {"rect:w=1m,h=0.6m", "rect:w=0.2m,h=1m,two-sided"}) {
        const Light light = test::light_with_image(shape, test::grey_image(64, 48), "1000nt");
        Light bare = light;
        bare.image.reset();
        std::get<RectShape>(bare.shape).image.reset();
        for (const double distance : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 8.0, 100.0}) {
            const Poses of = poses(distance, 120);
            const std::vector<float> share = shares(light, of, simd::InstructionSet::scalar);
            std::vector<double> truth;
            std::vector<double> fast;
            double mean = 0.0;
            for (std::size_t i = 0; i < of.size(); ++i) {
                truth.push_back(detail::image_illuminance(light, of.at(i), of.up(i), {1e-5, 4'000'000}).value);
                fast.push_back(static_cast<double>(share[i]) * reference_illuminance(bare, of.at(i), of.up(i)).value);
                mean += truth.back() / static_cast<double>(of.size());
            }
            std::vector<double> errors; // receivers with less than a twentieth of the mean count as that
            for (std::size_t i = 0; i < of.size(); ++i)
                errors.push_back(std::abs(fast[i] - truth[i]) / std::max(truth[i], 0.05 * mean));
            std::sort(errors.begin(), errors.end());
            EXPECT_LT(errors[errors.size() / 2], 5e-4) << shape << " at " << distance;
            // Where the horizon cuts the light, what a tile sends is not smooth.
            EXPECT_LT(errors[errors.size() * 95 / 100], 0.01) << shape << " at " << distance;
        }
    }
}

TEST(ImagePattern, IsTheSameWithEveryInstructionSet) {
    const Light light = test::light_with_image("rect:w=1m,h=0.6m", test::grey_image(64, 48), "1000nt");
    const Poses of = poses(0.3, 301);
    const std::vector<float> plain = shares(light, of, simd::InstructionSet::scalar);
    for (const simd::InstructionSet set : simd::available_sets()) {
        const std::vector<float> share = shares(light, of, set);
        for (std::size_t i = 0; i < share.size(); ++i)
            EXPECT_NEAR(share[i], plain[i], 2e-5);
    }
}

TEST(ImagePattern, IsFiniteEverywhere) {
    const Light light = test::light_with_image("rect:w=1m,h=0.6m", test::grey_image(5, 4), "1000nt");
    Poses of;
    for (const double z : {0.0, -1e-6, 1e-6, -1e3, -1e5, 2.0})
        for (const double x : {0.0, 0.5, 0.7, -3.0})
            for (const glm::dvec3& up : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0)})
                of.add({x, 0.1, z}, up);
    for (const float share : shares(light, of, simd::InstructionSet::scalar)) {
        EXPECT_TRUE(std::isfinite(share));
        EXPECT_GE(share, 0.0F);
        EXPECT_LE(share, 1.0F);
    }
}

TEST(IntensityPattern, OfAnImageIsTheLightsIntensity) {
    for (const char* const shape :
         {"spot:outer=40deg,inner=25deg", "frustum:h=60deg,v=40deg", "frustum:h=120deg,v=3deg"})
        for (const Image& image : {test::grey_image(64, 48), test::grey_image(1, 1), test::grey_image(1, 9)}) {
            const Light light = test::light_with_image(shape, image, "1000lm");
            detail::WebTables webs;
            const detail::IntensityPattern pattern(light, webs);
            const Poses of = poses(1.5, 501);
            for (const simd::InstructionSet set : simd::available_sets()) {
                std::vector<float> cd(of.size());
                pattern.evaluate({{of.position[0].data(), of.position[1].data(), of.position[2].data()}, of.size()},
                                 glm::dvec3(0.0), transport::intensity_kernels(set), cd.data());
                std::size_t apart = 0;
                for (std::size_t i = 0; i < of.size(); ++i) {
                    const double truth = light.intensity_towards(of.at(i) - light.frame.origin).value;
                    if (std::abs(static_cast<double>(cd[i]) - truth) > 2e-5 * light.intensity.value) ++apart;
                }
                EXPECT_LE(apart, 1U) << shape; // a direction on the outline
            }
        }
}

// An image with more pixels than pictures show is averaged, with the same light.
TEST(IntensityPattern, AveragesLargeImages) {
    const Light light = test::light_with_image("frustum:h=60deg,v=40deg", test::grey_image(2100, 8), "1000lm");
    detail::WebTables webs;
    const detail::IntensityPattern pattern(light, webs);
    Poses of;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i)
        of.add({std::tan(0.5235987756) * (2.0 * (i + 0.5) / n - 1.0), 0.05, -1.0}, {0.0, 0.0, 1.0});
    std::vector<float> cd(of.size());
    pattern.evaluate({{of.position[0].data(), of.position[1].data(), of.position[2].data()}, of.size()},
                     glm::dvec3(0.0), transport::intensity_kernels(simd::InstructionSet::scalar), cd.data());
    double sum = 0.0;
    double truth = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        sum += static_cast<double>(cd[i]);
        truth += light.intensity_towards(of.at(i)).value;
    }
    EXPECT_NEAR(sum, truth, 2e-3 * truth);
}

} // namespace
} // namespace gonio
