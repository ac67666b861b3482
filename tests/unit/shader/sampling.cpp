// The printed samplers of lights, in float: their moments against closed forms that share nothing with them.
#include <gonio/shader/evaluate.hpp>
#include <gonio/shader/formulas.hpp>

#include "cases.hpp"

// The scalar is double here; the recording scalar has come first.
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_tube.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::shader {
namespace {

using Vec = shading::vec3<double>;

Function function_named(std::string_view name) {
    const auto found = std::find_if(formulas().begin(), formulas().end(),
                                    [&](const Formula& formula) { return formula.function == name; });
    return recorded(*found);
}

struct Light {
    std::string_view name; // of its functions, before _sample and _pdf
    std::vector<float> parameters;
    std::function<double(Vec)> irradiance; // of a receiver's normal
    double solid_angle;                    // 0 if there is no closed form here
    double tolerance;                      // of the mean over the strata, relative
};

std::vector<Light> lights() {
    const Vec c{-0.25, 0.5, 1.0};
    const Vec m = shading::normalized(Vec{0.3, -0.5, -0.8});
    const Vec b = shading::normalized(shading::cross(m, Vec{0.2, 1.0, 0.1}));
    const auto numbers = [](std::initializer_list<Vec> vectors, std::initializer_list<double> sizes) {
        std::vector<float> all;
        for (const Vec& v : vectors)
            for (const double x : {v.x, v.y, v.z})
                all.push_back(static_cast<float>(x));
        for (const double size : sizes)
            all.push_back(static_cast<float>(size));
        return all;
    };
    std::vector<Light> all;
    for (const double scale : {0.6, 1.0, 40.0}) { // the distance: near, usual and far
        const Vec to = c * scale;
        const double d = shading::length(to);
        const double solid_angle = 2.0 * std::numbers::pi * (1.0 - std::sqrt(1.0 - 0.25 / (d * d)));
        all.push_back({"sphere", numbers({to}, {0.5}), [=](Vec n) { return shading::irradiance_sphere(to, 0.5, n); },
                       solid_angle, 1e-5});
        all.push_back({"disk", numbers({to, m}, {0.5}), [=](Vec n) { return shading::irradiance_disk(to, m, 0.5, n); },
                       0.0, 2e-4});
        all.push_back({"rect", numbers({to, m, b}, {1.25, 0.5}),
                       [=](Vec n) { return shading::irradiance_rectangle(to, m, b, 1.25, 0.5, n); }, 0.0, 1e-3});
        all.push_back({"tube", numbers({to, m}, {0.125, 1.5}),
                       [=](Vec n) { return shading::irradiance_tube(to, m, 0.125, 1.5, n); }, 0.0, 5e-3});
    }
    return all;
}

// The samples are directions divided by their density, so that the mean of max(n·s, 0) is the irradiance E/L, for any
// normal; and their mean length is the solid angle.
TEST(ShaderLightSamples, HaveTheMomentsOfTheLight) {
    const std::vector<Vec> normals{shading::normalized(Vec{-0.25, 0.5, 1.0}),
                                   shading::normalized(Vec{1.0, 0.5, 0.3}),
                                   shading::normalized(Vec{-0.5, -0.8, 0.6}),
                                   {0.0, 1.0, 0.0}};
    for (const Light& light : lights()) {
        const Function function = function_named(std::string(light.name) + "_sample");
        const Evaluator sample(function);
        constexpr int side = 64; // strata of each random number
        std::vector<double> means(normals.size(), 0.0);
        double mean_length = 0.0;
        std::vector<float> inputs = light.parameters;
        inputs.resize(inputs.size() + 5); // the normal, which is not read, and two random numbers
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                inputs[inputs.size() - 2] = (static_cast<float>(i) + 0.5F) / side;
                inputs[inputs.size() - 1] = (static_cast<float>(k) + 0.5F) / side;
                const std::array<float, 3> drawn = sample(inputs);
                const Vec s{static_cast<double>(drawn[0]), static_cast<double>(drawn[1]),
                            static_cast<double>(drawn[2])};
                mean_length += shading::length(s) / (side * side);
                for (std::size_t at = 0; at < normals.size(); ++at)
                    means[at] += std::max(shading::dot(normals[at], s), 0.0) / (side * side);
            }
        for (std::size_t at = 0; at < normals.size(); ++at)
            EXPECT_NEAR(means[at], light.irradiance(normals[at]), light.tolerance * mean_length)
                << light.name << ", normal " << at;
        if (light.solid_angle > 0.0) {
            EXPECT_NEAR(mean_length, light.solid_angle, light.tolerance * light.solid_angle) << light.name;
        }
    }
}

// The density of a sample's direction is 1 over its length, but for those few that rounding puts beside the outline of
// the light or of one of a tube's parts.
TEST(ShaderLightSamples, HaveTheirDensity) {
    for (const Light& light : lights()) {
        const Function sampler = function_named(std::string(light.name) + "_sample");
        const Function density = function_named(std::string(light.name) + "_pdf");
        const Evaluator sample(sampler);
        const Evaluator pdf(density);
        constexpr int side = 50;
        int apart = 0;
        std::vector<float> inputs = light.parameters;
        inputs.resize(inputs.size() + 5);
        std::vector<float> of_density = light.parameters;
        of_density.resize(of_density.size() + 6);
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                inputs[inputs.size() - 2] = (static_cast<float>(i) + 0.37F) / side;
                inputs[inputs.size() - 1] = (static_cast<float>(k) + 0.37F) / side;
                const std::array<float, 3> s = sample(inputs);
                const float length = std::hypot(s[0], s[1], s[2]);
                ASSERT_GT(length, 0.0F) << light.name;
                for (std::size_t at = 0; at < 3; ++at)
                    of_density[of_density.size() - 3 + at] = s[at] / length;
                if (std::fabs(pdf(of_density)[0] * length - 1.0F) > 2e-3F) ++apart;
            }
        EXPECT_LE(apart, side * side / 500) << light.name;
    }
}

} // namespace
} // namespace gonio::shader
