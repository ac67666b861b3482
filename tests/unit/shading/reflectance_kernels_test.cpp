// The kernels of reflectance against the same formulas in double, for every material and every instruction set.
#include <gonio/shading/coated.hpp>
#include <gonio/shading/kernels_reflectance.hpp>
#include <gonio/simd/dispatch.hpp>

#include "brdf_cases.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio::shading;
using Vec = vec3<double>;

constexpr std::size_t count = 1003; // full packets and a rest, for every number of lanes

template<template<class> class Material>
MaterialConstants kernel_constants(const Material<double>& material) {
    return constants_of(material);
}
template<template<class> class Base>
MaterialConstants kernel_constants(const brdf_cases::CoatOver<double, Base>& material) {
    return constants_of(Coated{material.base, material.coat});
}

struct Pairs {
    std::array<std::vector<float>, 6> numbers;

    Pairs() {
        gonio::measure::Random random(5);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec eye = poses::random_direction(random);
            // Every other light near the mirrored eye, where lobes are.
            Vec light = poses::random_direction(random);
            if (i % 2 == 0) light = poses::unit(Vec{-eye.x, -eye.y, eye.z} + light * 0.1);
            add(light, 0);
            add(eye, 3);
        }
    }
    void add(Vec direction, std::size_t first) {
        numbers[first].push_back(static_cast<float>(direction.x));
        numbers[first + 1].push_back(static_cast<float>(direction.y));
        numbers[first + 2].push_back(static_cast<float>(direction.z));
    }
    Vec direction(std::size_t i, std::size_t first) const {
        return {numbers[first][i], numbers[first + 1][i], numbers[first + 2][i]};
    }
    DirectionPairs arrays() const {
        DirectionPairs pairs;
        for (std::size_t k = 0; k < 3; ++k) {
            pairs.to_light[k] = numbers[k].data();
            pairs.to_eye[k] = numbers[3 + k].data();
        }
        pairs.count = count;
        return pairs;
    }
};

TEST(ReflectanceKernels, FindVectorsOfOtherLengths) {
    Pairs pairs;
    const DirectionPairs arrays = pairs.arrays();
    for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
        const ReflectanceKernels& kernels = reflectance_kernels(set);
        EXPECT_TRUE(kernels.are_unit(arrays.to_light, count));
        EXPECT_TRUE(kernels.are_unit(arrays.to_light, 0));
        for (const std::size_t at : {std::size_t{0}, std::size_t{500}, count - 1})
            for (const float wrong : {2.0F, std::nanf("")}) {
                const float right = std::exchange(pairs.numbers[1][at], wrong);
                EXPECT_FALSE(kernels.are_unit(arrays.to_light, count)) << kernels.name << ' ' << at;
                EXPECT_EQ(kernels.are_unit(arrays.to_light, count - 1), at == count - 1);
                pairs.numbers[1][at] = right;
            }
    }
}

TEST(ReflectanceKernels, AgreeWithDouble) {
    const Pairs pairs;
    for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
        const ReflectanceKernels& kernels = reflectance_kernels(set);
        EXPECT_EQ(kernels.set, set);
        brdf_cases::each([&](const std::string& name, auto make) {
            const auto material = make(0.0);
            if (lobe_alpha(material) < 0.01) return; // a float's direction is too coarse for a mirror
            std::array<std::vector<float>, 3> rgb;
            for (std::vector<float>& channel : rgb)
                channel.assign(count, -1.0F);
            float* const to[3] = {rgb[0].data(), rgb[1].data(), rgb[2].data()};
            kernels.brdf(pairs.arrays(), kernel_constants(material), to);
            double greatest = 0.0;
            double error = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const Vec light = pairs.direction(i, 0);
                const Vec eye = pairs.direction(i, 3);
                const Vec exact = brdf(material, Vec{0.0, 0.0, 1.0}, light, eye);
                const double values[3] = {exact.x, exact.y, exact.z};
                for (std::size_t k = 0; k < 3; ++k) {
                    greatest = std::max(greatest, values[k]);
                    error = std::max(error, std::abs(static_cast<double>(rgb[k][i]) - values[k]));
                    EXPECT_GE(rgb[k][i], 0.0F);
                    EXPECT_TRUE((light.z > 0.0 && eye.z > 0.0) || rgb[k][i] == 0.0F) << name;
                }
            }
            EXPECT_LE(error, 3e-4 * greatest + 1e-7) << name << ' ' << kernels.name;
        });
    }
}

} // namespace
