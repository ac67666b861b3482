// A hundred million poses in float and packs against double: never NaN, infinite, negative or above π, and within
// 1e-5·E/L + 1e-6·δ, δ the angle that the light subtends. Too long for a test.
//
//   gonio-irradiance-sweep [POSES_PER_SHAPE [SEED]]
//
// Default 5'000'000 poses before each of four shapes, each evaluated by every instruction set of this machine, `scalar`
// among them. Prints, for each shape and stratum, the worst share of the bar and the pose that has it, in hexadecimal
// floats (center and normal as the receiver sees them). Exit 1 where the bar is broken.
#include <gonio/measure/random.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../unit/shading/stratified_poses.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using area::Pose;
using area::Shape;
using area::Stratum;
using Kind = shading::LightConstants::Kind;

constexpr std::size_t group = 9 * 16; // receivers of one light

struct Worst {
    double share = 0.0;
    std::size_t poses = 0;
    std::size_t broken = 0;
    Pose pose;
    double truth = 0.0;
    double value = 0.0;
    const char* set = "";
};

float narrow(double x) {
    return static_cast<float>(x);
}

poses::Vec as_float(poses::Vec v) {
    return {static_cast<double>(narrow(v.x)), static_cast<double>(narrow(v.y)), static_cast<double>(narrow(v.z))};
}

// Every number of it a float.
Pose as_float(Pose pose) {
    pose.center = as_float(pose.center);
    pose.axis = as_float(pose.axis);
    pose.across = as_float(pose.across);
    pose.normal = as_float(pose.normal);
    pose.p = static_cast<double>(narrow(pose.p));
    pose.q = static_cast<double>(narrow(pose.q));
    return pose;
}

shading::LightConstants constants(const Pose& light) {
    shading::LightConstants made;
    constexpr Kind kinds[] = {Kind::disk, Kind::rectangle, Kind::tube, Kind::sphere};
    made.kind = kinds[static_cast<std::size_t>(light.shape)];
    made.radius = narrow(light.p);
    made.width = narrow(light.p);
    made.height = narrow(light.q);
    made.length = narrow(light.q);
    const double axis[3] = {light.axis.x, light.axis.y, light.axis.z};
    const double across[3] = {light.across.x, light.across.y, light.across.z};
    for (std::size_t k = 0; k < 3; ++k) {
        made.axis[k] = narrow(axis[k]);
        made.width_direction[k] = narrow(across[k]);
    }
    return made;
}

void print(const char* shape, std::size_t stratum, const Worst& worst) {
    const Pose& p = worst.pose;
    (void)std::printf("%-9s %-10s %10zu poses, worst %.3f of the bar (%s: %.9g for %.9g), broken %zu\n"
                      "    center %a %a %a normal %a %a %a axis %a %a %a across %a %a %a sizes %a %a\n",
                      shape, area::stratum_names[stratum], worst.poses, worst.share, worst.set, worst.value,
                      worst.truth, worst.broken, p.center.x, p.center.y, p.center.z, p.normal.x, p.normal.y, p.normal.z,
                      p.axis.x, p.axis.y, p.axis.z, p.across.x, p.across.y, p.across.z, p.p, p.q);
}

std::size_t sweep(Shape shape, const char* name, std::size_t count, std::uint64_t seed) {
    measure::Random random(seed);
    std::array<Worst, area::stratum_count> worst{};
    std::array<std::vector<float>, 6> arrays;
    for (auto& each : arrays)
        each.resize(group);
    std::vector<Pose> poses(group);
    std::vector<double> truth(group);
    std::vector<float> lx(group);
    for (std::size_t done = 0; done < count; done += group) {
        const Pose light = as_float(area::random_light(shape, random));
        for (std::size_t i = 0; i < group; ++i) {
            // Now all strata beside each other, now one for many packets.
            const std::size_t stratum = done / group % 2 == 0 ? i % area::stratum_count : i / 16;
            poses[i] = as_float(area::receiver(light, static_cast<Stratum>(stratum), random));
            truth[i] = area::exact<double>(poses[i]);
            const double values[6] = {-poses[i].center.x, -poses[i].center.y, -poses[i].center.z,
                                      poses[i].normal.x,  poses[i].normal.y,  poses[i].normal.z};
            for (std::size_t k = 0; k < 6; ++k)
                arrays[k][i] = narrow(values[k]);
        }
        const shading::LightConstants made = constants(light);
        shading::Surfaces surfaces;
        for (std::size_t k = 0; k < 3; ++k) {
            surfaces.position[k] = arrays[k].data();
            surfaces.normal[k] = arrays[3 + k].data();
        }
        surfaces.count = group;
        for (const simd::InstructionSet set : simd::available_sets()) {
            const shading::Kernels& kernels = shading::kernels(set);
            kernels.irradiance(surfaces, made, lx.data());
            for (std::size_t i = 0; i < group; ++i) {
                Worst& w = worst[done / group % 2 == 0 ? i % area::stratum_count : i / 16];
                const auto value = static_cast<double>(lx[i]);
                const bool number = lx[i] >= 0.0F && lx[i] <= std::numbers::pi_v<float>;
                const double share =
                    number ? std::fabs(value - truth[i]) / (1e-5 * truth[i] + 1e-6 * area::subtended(poses[i]))
                           : HUGE_VAL;
                ++w.poses;
                w.broken += share > 1.0 ? 1U : 0U;
                if (share > w.share) w = {share, w.poses, w.broken, poses[i], truth[i], value, kernels.name};
            }
        }
    }
    std::size_t broken = 0;
    for (std::size_t s = 0; s < area::stratum_count; ++s) {
        print(name, s, worst[s]);
        broken += worst[s].broken;
    }
    (void)std::fflush(stdout);
    return broken;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5'000'000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::size_t broken = sweep(Shape::sphere, "sphere", count, seed);
    broken += sweep(Shape::disk, "disk", count, seed + 1);
    broken += sweep(Shape::rectangle, "rectangle", count, seed + 2);
    broken += sweep(Shape::tube, "tube", count, seed + 3);
    (void)std::printf("%zu evaluations out of the bar\n", broken);
    return broken == 0 ? 0 : 1;
}
