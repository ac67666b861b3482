// Factors on the luminance of an area light for each surface point: on what its lobes reflect, and on all else.
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coated.hpp>
#include <gonio/shading/kernels.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace gonio::shading;
using Kind = LightConstants::Kind;

// More than the kernels keep at once.
constexpr std::size_t count = 2500;

struct Scene {
    std::array<std::vector<float>, 3> position, normal, view;
    std::vector<float> share, lobe_share;

    Scene() {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
        for (std::size_t i = 0; i < count; ++i) {
            const float x = 0.5F * unit(random);
            const float y = 0.5F * unit(random);
            const float length = std::sqrt(x * x + y * y + 1.0F);
            const std::array<float, 3> at{3.0F * unit(random), 3.0F * unit(random), 0.0F};
            const std::array<float, 3> up{0.0F, 0.0F, 1.0F};
            const std::array<float, 3> to_eye{x / length, y / length, 1.0F / length};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                position.at(axis).push_back(at.at(axis));
                normal.at(axis).push_back(up.at(axis));
                view.at(axis).push_back(to_eye.at(axis));
            }
            share.push_back(1.0F + 0.9F * unit(random));
            lobe_share.push_back(1.0F + 0.9F * unit(random));
        }
    }

    std::vector<float> shaded(gonio::simd::InstructionSet set, const LightConstants& light,
                              const MaterialConstants& material) const {
        Surfaces surfaces;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            surfaces.position[axis] = position.at(axis).data();
            surfaces.normal[axis] = normal.at(axis).data();
            surfaces.view[axis] = view.at(axis).data();
        }
        surfaces.count = count;
        std::vector<float> rgb(3 * count);
        float* const to[3] = {rgb.data(), rgb.data() + count, rgb.data() + 2 * count};
        kernels(set).shade(surfaces, light, material, to);
        return rgb;
    }
};

LightConstants light_of(Kind kind) {
    LightConstants light;
    light.kind = kind;
    light.position[2] = 1.5F;
    light.radius = 0.2F;
    light.width = 0.6F;
    light.height = 0.3F;
    return light;
}

const Frostbite<float> painted{{0.5F, 0.2F, 0.3F}, {0.04F, 0.1F, 0.9F}, 1.0F, 0.5F, 0.25F};

TEST(LightShares, MultiplyTheLobeAndTheRest) {
    const Scene scene;
    for (const gonio::simd::InstructionSet set : gonio::simd::available_sets())
        for (const Kind kind : {Kind::sphere, Kind::rectangle, Kind::disk}) {
            SCOPED_TRACE(std::string(gonio::simd::to_text(set)) + ' ' + std::to_string(static_cast<int>(kind)));
            LightConstants light = light_of(kind);
            const std::vector<float> whole = scene.shaded(set, light, constants_of(painted));
            const std::vector<float> matte = scene.shaded(set, light, constants_of(diffuse_alone(painted)));
            light.share = scene.share.data();
            light.lobe_share = scene.lobe_share.data();
            const std::vector<float> shaded = scene.shaded(set, light, constants_of(painted));
            for (std::size_t i = 0; i < shaded.size(); ++i) {
                const float lobe = whole[i] - matte[i];
                const float expected = scene.share[i % count] * matte[i] + scene.lobe_share[i % count] * lobe;
                EXPECT_NEAR(shaded[i], expected, 2e-6F * whole[i]) << i;
            }
        }
}

TEST(LightShares, OfAMaterialWithoutALobeAndOfACoatAreOnAll) {
    Scene scene;
    scene.lobe_share = scene.share;
    const Frostbite<double> base{{0.5, 0.2, 0.3}, {0.04, 0.1, 0.9}, 1.0, 0.5, 0.25};
    const MaterialConstants coated = constants_of(coated_material(base, 0.7, 0.6, CoatOrder::physical));
    for (const MaterialConstants& material : {constants_of(Lambert<float>{{0.5F, 0.2F, 0.3F}}), coated}) {
        LightConstants light = light_of(Kind::rectangle);
        const gonio::simd::InstructionSet set = gonio::simd::best_available();
        const std::vector<float> whole = scene.shaded(set, light, material);
        light.share = scene.share.data();
        light.lobe_share = scene.lobe_share.data();
        const std::vector<float> shaded = scene.shaded(set, light, material);
        for (std::size_t i = 0; i < shaded.size(); ++i)
            EXPECT_NEAR(shaded[i], scene.share[i % count] * whole[i], 4e-6F * whole[i]) << i;
    }
}

} // namespace
