#include <gonio/base/gauss_legendre.hpp>
#include <gonio/ibl/split_sum.hpp>
#include <gonio/ibl/split_sum_table.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

constexpr std::array heights{0.05, 0.2, 0.5, 1.0};

// Nested adaptive quadrature in double of another program.
TEST(SplitSum, HasTheValuesOfIndependentQuadrature) {
    struct Row {
        double roughness;
        std::array<double, 4> scale;
        std::array<double, 4> bias;
        double mean;
    };
    constexpr std::array rows{
        Row{0.1, {0.242548, 0.673392, 0.968339, 0.999898}, {0.733660, 0.325195, 0.031403, 0.000000}, 0.999491},
        Row{0.25, {0.449258, 0.681494, 0.955687, 0.995685}, {0.444847, 0.264780, 0.032637, 0.000003}, 0.987250},
        Row{0.5, {0.768819, 0.749895, 0.834916, 0.915785}, {0.164313, 0.098265, 0.022347, 0.000027}, 0.882323},
        Row{0.75, {0.839807, 0.737398, 0.654693, 0.626838}, {0.065119, 0.034593, 0.008483, 0.000048}, 0.656201},
        Row{1.0, {0.815684, 0.627621, 0.447705, 0.306819}, {0.032090, 0.014028, 0.002989, 0.000034}, 0.409137},
    };
    constexpr double digits = 1e-6; // six of them, and the second program's last one
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const SplitSum sum = split_sum(heights.at(i), row.roughness);
            EXPECT_NEAR(sum.scale, row.scale.at(i), digits) << row.roughness << ' ' << heights.at(i);
            EXPECT_NEAR(sum.bias, row.bias.at(i), digits) << row.roughness << ' ' << heights.at(i);
        }
        EXPECT_NEAR(mean_albedo(row.roughness), row.mean, digits) << row.roughness;
    }
}

TEST(SplitSum, HasAClosedFormForTheRoughestSurface) {
    for (const double mu : {0.01, 0.05, 0.3, 0.7, 0.999})
        EXPECT_NEAR(split_sum(mu, 1.0).albedo(), 1.0 - mu * std::log(1.0 + 1.0 / mu), 1e-7) << mu;
    EXPECT_NEAR(mean_albedo(1.0), 4.0 * (1.0 - std::numbers::ln2) / 3.0, 1e-6);
}

TEST(SplitSum, OfAMirrorIsSchlicksReflectance) {
    const SplitSum mirror = split_sum(0.3, 0.0);
    EXPECT_DOUBLE_EQ(mirror.bias, std::pow(0.7, 5.0));
    EXPECT_DOUBLE_EQ(mirror.scale + mirror.bias, 1.0);
    // A surface that is almost one is close to it, which the integral has to find out.
    EXPECT_NEAR(split_sum(0.3, 0.012).bias, mirror.bias, 1e-6);
    EXPECT_NEAR(split_sum(0.3, 0.012).albedo(), 1.0, 1e-6);
}

TEST(SplitSum, IsNotANumberOutsideItsDomain) {
    EXPECT_TRUE(std::isnan(split_sum(0.0, 0.5).scale));
    EXPECT_TRUE(std::isnan(split_sum(0.5, 1.1).scale));
}

TEST(SplitSum, OfUnrealReflectsLess) {
    EXPECT_NEAR(split_sum(0.5, 0.5, SplitSumModel::ue4).albedo(), 0.7471, 5e-5);
    EXPECT_NEAR(split_sum(0.5, 0.5).albedo(), 0.8573, 5e-5);
}

// A plain product of Gauss nodes over the hemisphere, from the formula as published.
double frostbite_diffuse(double n_dot_v, double r) {
    static constexpr auto nodes = gauss_legendre<20>();
    double sum = 0.0;
    for (const QuadratureNode& height : nodes)
        for (const QuadratureNode& turn : nodes) {
            const double n_dot_l = 0.5 * (1.0 + height.at);
            const double phi = std::numbers::pi * turn.at;
            const double l_dot_v =
                n_dot_l * n_dot_v + std::sqrt((1.0 - n_dot_l * n_dot_l) * (1.0 - n_dot_v * n_dot_v)) * std::cos(phi);
            const double l_dot_h = std::sqrt(0.5 * (1.0 + l_dot_v));
            const double fd90 = 0.5 * r + 2.0 * l_dot_h * l_dot_h * r;
            const double light = 1.0 + (fd90 - 1.0) * std::pow(1.0 - n_dot_l, 5.0);
            const double view = 1.0 + (fd90 - 1.0) * std::pow(1.0 - n_dot_v, 5.0);
            const double factor = 1.0 + r * (1.0 / 1.51 - 1.0);
            sum += 0.5 * height.weight * std::numbers::pi * turn.weight * light * view * factor * n_dot_l /
                   std::numbers::pi;
        }
    return sum;
}

TEST(SplitSum, HasFrostbitesDiffusePartAsAThirdChannel) {
    for (const double roughness : {0.0, 0.3, 1.0})
        for (const double mu : heights) {
            const SplitSum sum = split_sum(mu, roughness, SplitSumModel::frostbite);
            EXPECT_NEAR(sum.diffuse, frostbite_diffuse(mu, roughness), 1e-12);
            EXPECT_EQ(sum.scale, split_sum(mu, roughness).scale);
        }
    EXPECT_EQ(split_sum(0.5, 0.5).diffuse, 0.0);
}

TEST(MultipleScattering, HasThePublishedValues) {
    const SplitSum sum = split_sum(0.5, 1.0);
    const double mean = mean_albedo(1.0);
    const auto albedo = [&](MultipleScattering scheme) { return specular_albedo(0.5, sum, mean, scheme); };
    EXPECT_NEAR(albedo(MultipleScattering::none), 0.226842, 1e-6);
    EXPECT_NEAR(albedo(MultipleScattering::filament), 0.365078, 1e-6);
    EXPECT_NEAR(albedo(MultipleScattering::kulla_conty), 0.316144, 1e-6);
    EXPECT_NEAR(albedo(MultipleScattering::fdez_aguera), 0.318477, 1e-6);
}

// The furnace: a white surface under uniform light cannot be told from the light.
TEST(MultipleScattering, ReflectsAllLightFromAWhiteSurface) {
    for (const double roughness : {0.1, 0.5, 1.0})
        for (const double mu : heights)
            for (const MultipleScatteringInfo& info : multiple_scattering_schemes()) {
                const double albedo =
                    specular_albedo(1.0, split_sum(mu, roughness), mean_albedo(roughness), info.scheme);
                if (info.scheme == MultipleScattering::none)
                    EXPECT_LT(albedo, 1.0);
                else
                    EXPECT_NEAR(albedo, 1.0, 1e-12) << info.name;
            }
}

TEST(SplitSumTable, HoldsTheSumsAtTheMiddlesOfTexels) {
    const SplitSumTable table = *SplitSumTable::create(16, SplitSumModel::frostbite);
    const SplitSum exact = split_sum(2.5 / 16.0, 7.5 / 16.0, SplitSumModel::frostbite);
    const SplitSum found = table.lookup(2.5 / 16.0, 7.5 / 16.0);
    EXPECT_NEAR(found.scale, exact.scale, 1e-7);
    EXPECT_NEAR(found.bias, exact.bias, 1e-7);
    EXPECT_NEAR(found.diffuse, exact.diffuse, 1e-7);
    EXPECT_NEAR(table.mean_albedo(7.5 / 16.0), mean_albedo(7.5 / 16.0), 1e-12);
    // Held beyond the outermost middles.
    EXPECT_EQ(table.lookup(0.0, 0.0).scale, table.lookup(0.5 / 16.0, 0.5 / 16.0).scale);
    EXPECT_EQ(table.lookup(1.0, 1.0).scale, table.lookup(15.5 / 16.0, 15.5 / 16.0).scale);
}

// Bilinear interpolation of a smooth function errs by the square of the step. Smooth surfaces at grazing, where E falls
// within n·v ~ α, are no smooth function: the greatest error of all is there.
TEST(SplitSumTable, IsTheBetterTheLargerItIs) {
    const SplitSumTable coarse = *SplitSumTable::create(16);
    const SplitSumTable fine = *SplitSumTable::create(64);
    const auto error = [](const SplitSumTable& table) {
        double most = 0.0;
        for (double roughness = 0.3; roughness < 0.9; roughness += 0.0371)
            for (double mu = 0.3; mu < 0.9; mu += 0.0373)
                most = std::max(most, std::abs(table.lookup(mu, roughness).scale - split_sum(mu, roughness).scale));
        return most;
    };
    EXPECT_LT(error(coarse), 3e-3);
    EXPECT_LT(error(fine), 0.1 * error(coarse));
    EXPECT_GT(fine.lookup_error(3), error(fine));
    EXPECT_LT(fine.lookup_error(3), 0.03);
}

TEST(SplitSumTable, DoesNotDependOnThreads) {
    EXPECT_EQ(SplitSumTable::create(8, SplitSumModel::ue4, 1)->image().pixels,
              SplitSumTable::create(8, SplitSumModel::ue4, 3)->image().pixels);
}

TEST(SplitSumTable, RefusesSizesThatAreNoTable) {
    EXPECT_FALSE(SplitSumTable::create(1));
    EXPECT_FALSE(SplitSumTable::create(1025));
}

TEST(SplitSumModels, AreFoundByTheirNames) {
    for (const SplitSumModelInfo& info : split_sum_models())
        EXPECT_EQ(*parse_split_sum_model(info.name), info.model);
    for (const MultipleScatteringInfo& info : multiple_scattering_schemes())
        EXPECT_EQ(*parse_multiple_scattering(info.name), info.scheme);
    EXPECT_FALSE(parse_split_sum_model("ggx2"));
}

} // namespace
} // namespace gonio
