// A hundred million specular luminances, of many lights, surfaces and eyes: no method may give NaN, infinity or less
// than 0, and ltc no more than 1. Too long for a test.
//
//   gonio-specular-sweep [POSES_PER_SHAPE [SEED]]
//
// Default 1'050'000 poses before each of four shapes, each evaluated by six methods and every instruction set of this
// machine, `scalar` among them. Prints, for each shape, how many values were taken, how many were out of their range,
// and by how much ltc differs between instruction sets. Exit 1 where a value is out of its range.
#include <gonio/measure/random.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../unit/shading/stratified_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using namespace gonio;
using area::Pose;
using area::Shape;
using Kind = shading::LightConstants::Kind;
using shading::SpecularMethod;

constexpr std::size_t group = 9 * 16; // receivers of one light
constexpr std::size_t method_count = 6;

shading::LightConstants constants(const Pose& light) {
    shading::LightConstants made;
    constexpr Kind kinds[] = {Kind::disk, Kind::rectangle, Kind::tube, Kind::sphere};
    made.kind = kinds[static_cast<std::size_t>(light.shape)];
    made.radius = static_cast<float>(light.p);
    made.width = static_cast<float>(light.p);
    made.height = static_cast<float>(light.q);
    made.length = static_cast<float>(light.q);
    const double axis[3] = {light.axis.x, light.axis.y, light.axis.z};
    const double across[3] = {light.across.x, light.across.y, light.across.z};
    for (std::size_t k = 0; k < 3; ++k) {
        made.axis[k] = static_cast<float>(axis[k]);
        made.width_direction[k] = static_cast<float>(across[k]);
    }
    return made;
}

// Any direction, above the surface or below it; some along the normal, some grazing.
poses::Vec eye(poses::Vec normal, std::size_t index, measure::Random& random) {
    if (index % 7 == 0) return normal;
    if (index % 7 == 1) return poses::tilted(normal, random.uniform(-1e-3, 1e-3), random);
    return poses::random_direction(random);
}

std::size_t sweep(Shape shape, const char* name, std::size_t count, std::uint64_t seed) {
    measure::Random random(seed);
    std::array<std::vector<float>, 9> arrays;
    for (auto& each : arrays)
        each.resize(group);
    std::vector<float> scale(group);
    std::vector<float> grazing(group);
    std::vector<float> plain(group);
    std::size_t values = 0;
    std::size_t broken = 0;
    float widest = 0.0F; // between instruction sets
    for (std::size_t done = 0; done < count; done += group) {
        const Pose light = area::random_light(shape, random);
        for (std::size_t i = 0; i < group; ++i) {
            const Pose pose = area::receiver(light, static_cast<area::Stratum>(i % area::stratum_count), random);
            const poses::Vec v = eye(pose.normal, i, random);
            const double numbers[9] = {-pose.center.x,
                                       -pose.center.y,
                                       -pose.center.z,
                                       pose.normal.x,
                                       pose.normal.y,
                                       pose.normal.z,
                                       v.x,
                                       v.y,
                                       v.z};
            for (std::size_t k = 0; k < 9; ++k)
                arrays[k][i] = static_cast<float>(numbers[k]);
        }
        shading::Surfaces surfaces;
        for (std::size_t k = 0; k < 3; ++k) {
            surfaces.position[k] = arrays[k].data();
            surfaces.normal[k] = arrays[3 + k].data();
            surfaces.view[k] = arrays[6 + k].data();
        }
        surfaces.count = group;
        const shading::LightConstants made = constants(light);
        const auto alpha = static_cast<float>(std::exp(random.uniform(std::log(1e-4), 0.0)));
        for (std::size_t m = 0; m < method_count; ++m)
            for (const simd::InstructionSet set : simd::available_sets()) {
                shading::specular_kernels(set).specular(surfaces, made, alpha, static_cast<SpecularMethod>(m),
                                                        scale.data(), grazing.data());
                const float most = m == 0 ? 1.0F : HUGE_VALF;
                for (std::size_t i = 0; i < group; ++i) {
                    const bool number = scale[i] >= 0.0F && scale[i] <= most && scale[i] < HUGE_VALF;
                    const bool share = grazing[i] >= 0.0F && grazing[i] <= 1.00001F;
                    broken += number && share ? 0U : 1U;
                    // On a light's surface a rounding decides whether it is all around.
                    const bool on = static_cast<area::Stratum>(i % area::stratum_count) == area::Stratum::on;
                    if (m == 0 && set != simd::InstructionSet::scalar && !on)
                        widest = std::max(widest, std::fabs(scale[i] - plain[i]));
                }
                if (set == simd::InstructionSet::scalar) plain = scale;
                values += group;
            }
    }
    (void)std::printf("%-9s %11zu values, %zu out of range; ltc differs between sets by %.1e at most\n", name, values,
                      broken, static_cast<double>(widest));
    (void)std::fflush(stdout);
    return broken;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'050'000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::size_t broken = sweep(Shape::sphere, "sphere", count, seed);
    broken += sweep(Shape::disk, "disk", count, seed + 1);
    broken += sweep(Shape::rectangle, "rectangle", count, seed + 2);
    broken += sweep(Shape::tube, "tube", count, seed + 3);
    (void)std::printf("%zu values out of range\n", broken);
    return broken == 0 ? 0 : 1;
}
