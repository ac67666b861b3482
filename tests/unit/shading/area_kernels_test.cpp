// Disk, rectangle and tube lights in the kernels of every instruction set: against double on the same floats, for every
// count, on hostile input; and their shading.
#include <gonio/measure/area_cases.hpp>
#include <gonio/measure/area_methods.hpp>
#include <gonio/measure/error_statistics.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/shade.hpp>

#include "../scaled.hpp"
#include "poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace gonio::shading;
using gonio::measure::AreaCases;
using gonio::measure::Random;
using gonio::measure::Stratum;
using gonio::test::scaled;
using Kind = LightConstants::Kind;

// Base colour and other parameters 0.5, with a dielectric's reflectance.
const Frostbite<float> painted{{0.5F, 0.5F, 0.5F}, {0.04F, 0.04F, 0.04F}, 1.0F, 0.5F, 0.25F};

std::string name_of(Kind kind) {
    return kind == Kind::disk        ? "disk"
           : kind == Kind::ellipse   ? "ellipse"
           : kind == Kind::rectangle ? "rectangle"
           : kind == Kind::cylinder  ? "cylinder"
                                     : "tube";
}

class AreaKernels : public testing::TestWithParam<std::tuple<Kind, gonio::simd::InstructionSet>> {
protected:
    Kind kind = std::get<0>(GetParam());
    const Kernels& kernels = gonio::shading::kernels(std::get<1>(GetParam()));

    [[nodiscard]] std::vector<float> run(const AreaCases& cases) const {
        std::vector<float> lx(cases.size());
        for (std::size_t g = 0; g < cases.lights.size(); ++g)
            kernels.irradiance(cases.surfaces(g), cases.lights[g], lx.data() + g * AreaCases::group_size);
        return lx;
    }
};

INSTANTIATE_TEST_SUITE_P(
    Sets, AreaKernels,
    testing::Combine(testing::Values(Kind::disk, Kind::ellipse, Kind::rectangle, Kind::tube, Kind::cylinder),
                     testing::ValuesIn(gonio::simd::available_sets().begin(), gonio::simd::available_sets().end())),
    [](const auto& each) {
        return name_of(std::get<0>(each.param)) + "_" + gonio::simd::to_text(std::get<1>(each.param));
    });

TEST_P(AreaKernels, FloatWithinItsBarOfDouble) {
    const AreaCases cases = gonio::measure::area_cases(kind, scaled(std::size_t{200'000}), 21);
    const std::vector<double> truth = gonio::measure::area_truth(cases);
    const std::vector<float> lx = run(cases);
    double worst_share = 0.0;
    double worst_above = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        double d2 = 0.0;
        for (const auto& component : cases.position)
            d2 += static_cast<double>(component[i]) * static_cast<double>(component[i]);
        const double size = gonio::measure::bounding_radius(cases.lights[i / AreaCases::group_size]);
        const double subtended = 2.0 * std::asin(std::min(1.0, size / std::sqrt(d2)));
        const double error = std::fabs(static_cast<double>(lx[i]) - truth[i]);
        const double share = error / (1e-5 * truth[i] + 1e-6 * subtended);
        EXPECT_LE(share, 1.0) << i << ' ' << gonio::measure::to_text(cases.stratum[i]) << " truth " << truth[i];
        worst_share = std::max(worst_share, share);
        if (cases.stratum[i] == Stratum::above && truth[i] > 1e-6)
            worst_above = std::max(worst_above, error / truth[i]);
    }
    RecordProperty("worst_share_of_bar", std::to_string(worst_share));
    RecordProperty("worst_relative_above", std::to_string(worst_above * 1e6) + "e-6");
}

TEST_P(AreaKernels, SameAtAnyScale) {
    const AreaCases cases = gonio::measure::area_cases(kind, 2000, 23);
    const std::vector<float> base = run(cases);
    for (const float scale : {0x1p-80F, 0x1p-20F, 0x1p30F, 0x1p80F}) {
        AreaCases other = cases;
        for (auto& component : other.position)
            for (float& p : component)
                p *= scale;
        for (LightConstants& light : other.lights)
            for (float* size : {&light.radius, &light.width, &light.height, &light.length})
                *size *= scale;
        EXPECT_EQ(run(other), base) << scale;
    }
}

TEST_P(AreaKernels, TwoSidedGivesEachSideWhatOneSideGives) {
    AreaCases cases = gonio::measure::area_cases(kind, 4000, 24);
    const std::vector<float> front = run(cases);
    for (LightConstants& light : cases.lights)
        light.two_sided = true;
    EXPECT_EQ(run(cases), front);
    for (LightConstants& light : cases.lights)
        for (float& component : light.axis)
            component = -component;
    const std::vector<float> turned = run(cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
        ASSERT_NEAR(turned[i], front[i], 2e-5F * front[i] + 4e-6F) << i;
    if (kind == Kind::tube || kind == Kind::cylinder) return; // has no sides, so the option is ignored
    for (LightConstants& light : cases.lights)
        light.two_sided = false;
    for (const float lx : run(cases))
        ASSERT_EQ(lx, 0.0F) << "seen from behind";
}

TEST_P(AreaKernels, EveryCountGivesWhatAFullPacketGivesAndWritesNoMore) {
    const AreaCases cases = gonio::measure::area_cases(kind, 48, 33);
    const LightConstants& light = cases.lights[0];
    const std::vector<float> whole = run(cases);
    for (std::size_t count = 0; count <= 33; ++count) {
        Surfaces surfaces = cases.surfaces(0);
        surfaces.count = count;
        std::vector<float> lx(cases.size(), -7.0F);
        kernels.irradiance(surfaces, light, lx.data());
        for (std::size_t i = 0; i < cases.size(); ++i)
            ASSERT_NEAR(lx[i], i < count ? whole[i] : -7.0F, 1e-6F) << count << ' ' << i;
    }
}

// Receivers are sorted by blocks before they are packed.
TEST_P(AreaKernels, CountsAroundABlockGiveTheSameAndWriteNoMore) {
    const AreaCases cases = gonio::measure::area_cases(kind, 1200, 34);
    Surfaces surfaces;
    for (std::size_t k = 0; k < 3; ++k) {
        surfaces.position[k] = cases.position[k].data();
        surfaces.normal[k] = cases.normal[k].data();
    }
    surfaces.count = cases.size();
    std::vector<float> whole(cases.size());
    kernels.irradiance(surfaces, cases.lights[0], whole.data());
    for (const std::size_t count : {255U, 256U, 257U, 288U, 511U, 512U, 513U, 1199U}) {
        std::vector<float> lx(cases.size(), -7.0F);
        surfaces.count = count;
        kernels.irradiance(surfaces, cases.lights[0], lx.data());
        for (std::size_t i = 0; i < cases.size(); ++i)
            ASSERT_NEAR(lx[i], i < count ? whole[i] : -7.0F, 1e-6F) << count << ' ' << i;
    }
    surfaces.count = cases.size();
    std::vector<float> again(cases.size());
    kernels.irradiance(surfaces, cases.lights[0], again.data());
    EXPECT_EQ(again, whole);
}

// For a receiver in the light's own plane that faces it, the height over the receiver's plane is only rounding, and the
// light fills half of the sky: such a receiver must not be sorted out as dark.
TEST_P(AreaKernels, ReceiversOnTheLightAmongOthers) {
    AreaCases cases = gonio::measure::area_cases(kind, 256 * 64, 36);
    Random random(37);
    for (std::size_t i = 0; i < cases.size(); i += 3) {
        const LightConstants& light = cases.lights[i / AreaCases::group_size];
        const vec3<double> axis{light.axis[0], light.axis[1], light.axis[2]};
        const poses::Vec any = poses::random_direction(random);
        const vec3<double> aside = normalized(cross(axis, {any.x, any.y, any.z}));
        const double radius = light.radius;
        const double smaller = 0.5 * std::min<double>(light.width, light.height);
        const bool is_round = kind == Kind::tube || kind == Kind::cylinder;
        const double out = is_round ? radius : 0.9 * (kind == Kind::disk ? radius : smaller);
        const vec3<double> at = is_round ? aside * out + axis * (0.3 * double{light.length}) : aside * out;
        const vec3<double> toward = is_round ? aside * -1.0 : axis * -1.0;
        const double position[3] = {at.x, at.y, at.z};
        const double normal[3] = {toward.x, toward.y, toward.z};
        for (std::size_t k = 0; k < 3; ++k) {
            cases.position[k][i] = static_cast<float>(position[k]);
            cases.normal[k][i] = static_cast<float>(normal[k]);
        }
    }
    const std::vector<double> truth = gonio::measure::area_truth(cases);
    const std::vector<float> lx = run(cases);
    std::size_t full = 0;
    for (std::size_t i = 0; i < cases.size(); i += 3) {
        full += truth[i] > 3.14 ? 1U : 0U;
        ASSERT_NEAR(static_cast<double>(lx[i]), truth[i], 1e-5 * truth[i] + 1e-6 * std::numbers::pi) << i;
    }
    EXPECT_GT(full, cases.size() / 12) << "half of them at least are in front, or on the tube";
}

TEST_P(AreaKernels, HostileInputGivesFiniteNumbersThatAreNotNegative) {
    Random random(35);
    const std::size_t count = scaled(std::size_t{15'625}); // × 64 lights: a million points
    std::vector<float> arrays[12];
    for (std::size_t i = 0; i < count; ++i) {
        const poses::Vec n = i % 4 == 0 ? poses::Vec{0.0, 0.0, 1.0} : poses::random_direction(random);
        const poses::Vec v = i % 5 == 0 ? n : poses::random_direction(random);
        const double values[9] = {
            poses::hostile(random), poses::hostile(random), poses::hostile(random), n.x, n.y, n.z, v.x, v.y, v.z};
        for (std::size_t k = 0; k < 9; ++k)
            arrays[k].push_back(static_cast<float>(values[k]));
    }
    Surfaces surfaces;
    for (std::size_t k = 0; k < 3; ++k) {
        surfaces.position[k] = arrays[k].data();
        surfaces.normal[k] = arrays[3 + k].data();
        surfaces.view[k] = arrays[6 + k].data();
        arrays[9 + k].resize(count);
    }
    surfaces.count = count;
    std::vector<float> lx(count);
    float* const rgb[3] = {arrays[9].data(), arrays[10].data(), arrays[11].data()};
    for (int round = 0; round < 64; ++round) {
        LightConstants light;
        light.kind = kind;
        light.two_sided = round % 3 == 0;
        if (round % 2 == 0) {
            const poses::Vec axis = poses::random_direction(random);
            const poses::Vec across = poses::unit(cross(axis, poses::random_direction(random)));
            const double a[3] = {axis.x, axis.y, axis.z};
            const double w[3] = {across.x, across.y, across.z};
            for (int k = 0; k < 3; ++k) {
                light.axis[k] = static_cast<float>(a[k]);
                light.width_direction[k] = static_cast<float>(w[k]);
            }
        }
        for (float* size : {&light.radius, &light.width, &light.height, &light.length, &light.color[0]})
            *size = static_cast<float>(std::fabs(poses::hostile(random)));
        for (int k = 0; k < 3; ++k)
            light.position[k] = round % 5 == 0 ? surfaces.position[k][17] : static_cast<float>(poses::hostile(random));
        Frostbite<float> glossy = painted;
        glossy.alpha = static_cast<float>(round) / 63.0F;
        const MaterialConstants material = constants_of(glossy);
        kernels.irradiance(surfaces, light, lx.data());
        kernels.shade(surfaces, light, material, rgb);
        for (std::size_t i = 0; i < count; ++i) {
            ASSERT_TRUE(lx[i] >= 0.0F && lx[i] <= std::numbers::pi_v<float>) << round << ' ' << i << ' ' << lx[i];
            for (const float* channel : rgb)
                ASSERT_TRUE(std::isfinite(channel[i]) && channel[i] >= 0.0F) << round << ' ' << i << ' ' << channel[i];
        }
    }
}

// The kernels against shade.hpp in double.
TEST_P(AreaKernels, ShadeWithinABoundOfDouble) {
    const AreaCases cases = gonio::measure::area_cases(kind, scaled(std::size_t{20'000}), 25);
    std::vector<float> view[3];
    Random random(26);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const poses::Vec n{static_cast<double>(cases.normal[0][i]), static_cast<double>(cases.normal[1][i]),
                           static_cast<double>(cases.normal[2][i])};
        const poses::Vec v = poses::tilted(n, random.uniform(0.1, 1.0), random);
        view[0].push_back(static_cast<float>(v.x));
        view[1].push_back(static_cast<float>(v.y));
        view[2].push_back(static_cast<float>(v.z));
    }
    const MaterialConstants material = constants_of(painted);
    const auto frostbite = material_of<Frostbite, double>(material);
    std::size_t off = 0;
    for (std::size_t g = 0; g < cases.lights.size(); ++g) {
        const LightConstants& light = cases.lights[g];
        Surfaces surfaces = cases.surfaces(g);
        std::vector<float> rgb(3 * surfaces.count);
        for (std::size_t k = 0; k < 3; ++k)
            surfaces.view[k] = view[k].data() + g * AreaCases::group_size;
        float* const out[3] = {rgb.data(), rgb.data() + surfaces.count, rgb.data() + 2 * surfaces.count};
        kernels.shade(surfaces, light, material, out);
        const auto three = [](const auto& a, const auto& b, const auto& c) {
            return vec3<double>{static_cast<double>(a), static_cast<double>(b), static_cast<double>(c)};
        };
        const vec3<double> axis = three(light.axis[0], light.axis[1], light.axis[2]);
        const vec3<double> across = three(light.width_direction[0], light.width_direction[1], light.width_direction[2]);
        for (std::size_t i = 0; i < surfaces.count; ++i) {
            const auto at = [i, &three](const float* const(&v)[3]) { return three(v[0][i], v[1][i], v[2][i]); };
            const SurfacePoint<double> point{at(surfaces.position), at(surfaces.normal), at(surfaces.view)};
            const vec3<double> zero{0, 0, 0};
            const vec3<double> white{1, 1, 1};
            double truth = 0.0;
            if (kind == Kind::disk)
                truth = shade(point, DiskLight<double>{zero, white, axis, light.radius, 0.0, false}, frostbite).x;
            if (kind == Kind::ellipse)
                truth = shade(point,
                              EllipseLight<double>{zero, white, axis, across, 0.5 * double{light.width},
                                                   0.5 * double{light.height}, 0.0, false},
                              frostbite)
                            .x;
            if (kind == Kind::rectangle)
                truth = shade(point,
                              RectangleLight<double>{zero, white, axis, across, light.width, light.height, 0.0, false},
                              frostbite)
                            .x;
            if (kind == Kind::tube)
                truth =
                    shade(point, TubeLight<double>{zero, white, axis, light.radius, light.length, 0.0}, frostbite).x;
            if (kind == Kind::cylinder)
                truth =
                    shade(point, CylinderLight<double>{zero, white, axis, light.radius, light.length, 0.0}, frostbite)
                        .x;
            // The representative point jumps where the mirrored ray runs along the plane: a few points may differ.
            if (std::fabs(static_cast<double>(out[0][i]) - truth) > 1e-3 * truth + 1e-6) ++off;
        }
    }
    EXPECT_LE(off, cases.size() / 200);
    RecordProperty("off", std::to_string(off));
}

// A small, distant light is a point light with its intensity, diffuse and specular.
TEST_P(AreaKernels, SmallAndFarItIsAPoint) {
    float position[3][1] = {{0.0F}, {0.0F}, {0.0F}};
    float normal[3][1] = {{0.0F}, {0.0F}, {1.0F}};
    float view[3][1] = {{0.6F}, {0.0F}, {0.8F}};
    Surfaces surfaces;
    for (int k = 0; k < 3; ++k) {
        surfaces.position[k] = position[k];
        surfaces.normal[k] = normal[k];
        surfaces.view[k] = view[k];
    }
    surfaces.count = 1;
    LightConstants light;
    light.kind = kind;
    light.position[0] = -3.0F;
    light.position[2] = 4.0F;
    light.radius = light.width = light.height = light.length = 1e-3F;
    light.color[0] = light.color[1] = light.color[2] = 1e6F;
    double intensity = std::numbers::pi * 0.8;
    if (kind == Kind::ellipse) intensity = 0.25 * std::numbers::pi * 0.8;
    if (kind == Kind::rectangle) intensity = 0.8;
    if (kind == Kind::tube) intensity = std::numbers::pi + 2.0 * 0.6;
    if (kind == Kind::cylinder) intensity = 2.0 * 0.6;
    const float candela[1] = {static_cast<float>(intensity)};
    LightConstants punctual;
    punctual.position[0] = -3.0F;
    punctual.position[2] = 4.0F;
    punctual.intensity_cd = &candela[0];
    const MaterialConstants material = constants_of(painted);
    float a[3];
    float b[3];
    float* const to_a[3] = {&a[0], &a[1], &a[2]};
    float* const to_b[3] = {&b[0], &b[1], &b[2]};
    kernels.shade(surfaces, light, material, to_a);
    kernels.shade(surfaces, punctual, material, to_b);
    EXPECT_GT(b[0], 0.0F);
    EXPECT_NEAR(a[0], b[0], 2e-3F * b[0]);
}

TEST(AreaMethods, ErrorsOfEachAreWhatTheyAreKnownFor) {
    using namespace gonio::measure;
    for (const Kind kind : {Kind::disk, Kind::ellipse, Kind::rectangle, Kind::tube, Kind::cylinder}) {
        const AreaCases all = area_cases(kind, 2000, 1);
        const AreaCases far = area_cases_of(kind, Stratum::far, 512, 1);
        const AreaCases straddling = area_cases_of(kind, Stratum::straddling, 512, 1);
        int exact_methods = 0;
        for (const AreaMethod& m : area_methods(kind)) {
            SCOPED_TRACE(name_of(kind) + " " + m.name + " " + m.precision);
            const auto errors = [&](const AreaCases& cases) {
                return compare(evaluated(m, cases), area_truth(cases), 1e-6);
            };
            if (m.name == "exact") {
                ++exact_methods;
                EXPECT_LE(errors(all).absolute.max, 4e-5);
                EXPECT_LE(errors(far).relative.median, 1e-6);
            } else {
                EXPECT_GE(errors(straddling).relative.median, 0.05) << "an approximation where the horizon cuts";
                if (m.name != "ue4") {
                    EXPECT_LE(errors(far).relative.median, 5e-3);
                }
                EXPECT_LE(errors(all).absolute.median, 0.5);
            }
        }
        EXPECT_GE(exact_methods, 3) << "double, float and at least one instruction set";
    }
    EXPECT_TRUE(area_methods(Kind::sphere).empty());
}

} // namespace
