// Specular luminance of lights with a size, by every method and instruction set: within its range on any input, and
// against double where the receiver is outside the light.
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/simd/dispatch.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio::measure::detail {

namespace {

using hostile::Pose;
using hostile::Shape;
using hostile::Stratum;
using shading::SpecularMethod;

constexpr std::size_t group = std::size_t{9} * 16; // receivers of one light
constexpr std::size_t method_count = 6;

// Any direction, above the surface or below it; some along the normal, some grazing.
hostile::Vec eye(hostile::Vec normal, std::size_t index, Random& random) {
    if (index % 7 == 0) return normal;
    if (index % 7 == 1) return hostile::tilted(normal, random.uniform(-1e-3, 1e-3), random);
    return hostile::random_direction(random);
}

// Finite, not negative, and for linearly transformed cosines not above 1, because F and the light are both 1.
template<Shape shape>
void specular(Random& random, std::uint64_t evaluations, StressTally& tally) {
    std::array<std::vector<float>, 9> columns;
    for (auto& each : columns)
        each.resize(group);
    std::vector<float> scale(group);
    std::vector<float> grazing(group);
    std::vector<Pose> poses(group);
    const std::size_t sets = simd::available_sets().size();
    for (std::uint64_t done = 0; done < evaluations; done += 2 * group * method_count * sets) {
        const Pose light = hostile::random_light(shape, random);
        for (std::size_t i = 0; i < group; ++i) {
            poses[i] = hostile::receiver(light, static_cast<Stratum>(i % hostile::stratum_count), random);
            const hostile::Vec v = eye(poses[i].normal, i, random);
            const double numbers[9] = {-poses[i].center.x,
                                       -poses[i].center.y,
                                       -poses[i].center.z,
                                       poses[i].normal.x,
                                       poses[i].normal.y,
                                       poses[i].normal.z,
                                       v.x,
                                       v.y,
                                       v.z};
            for (std::size_t k = 0; k < 9; ++k)
                columns[k][i] = static_cast<float>(numbers[k]);
        }
        shading::Surfaces surfaces;
        for (std::size_t k = 0; k < 3; ++k) {
            surfaces.position[k] = columns[k].data();
            surfaces.normal[k] = columns[3 + k].data();
            surfaces.view[k] = columns[6 + k].data();
        }
        surfaces.count = group;
        const shading::LightConstants constants = hostile::light_constants(light);
        const auto alpha = static_cast<float>(std::exp(random.uniform(std::log(1e-4), 0.0)));
        const auto any_alpha = [&] { return static_cast<float>(std::exp(random.uniform(std::log(1e-4), 0.0))); };
        const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
        const shading::AnisotropicLobeConstants grained{{any_alpha(), any_alpha()},
                                                        {0.0F, 0.0F, 1.0F},
                                                        static_cast<float>(std::cos(turn)),
                                                        static_cast<float>(std::sin(turn))};
        for (std::size_t m = 0; m < method_count; ++m)
            for (const simd::InstructionSet set : simd::available_sets())
                for (const bool is_even : {true, false}) {
                    const shading::SpecularKernels& kernels = shading::specular_kernels(set);
                    const auto method = static_cast<SpecularMethod>(m);
                    if (is_even)
                        kernels.specular(surfaces, constants, alpha, method, scale.data(), grazing.data());
                    else
                        kernels.specular_anisotropic(surfaces, constants, grained, method, scale.data(),
                                                     grazing.data());
                    const float most = m == 0 ? 1.0F : HUGE_VALF;
                    tally.looked_at(group);
                    for (std::size_t i = 0; i < group; ++i) {
                        const bool number = scale[i] >= 0.0F && scale[i] <= most && scale[i] < HUGE_VALF;
                        const bool share = grazing[i] >= 0.0F && grazing[i] <= 1.00001F;
                        tally.require(number && share, [&] {
                            return fmt::format("method {} {}: {} and {}, alpha {:a}{} view {:a} {:a} {:a} {}", m,
                                               kernels.name, scale[i], grazing[i], alpha,
                                               is_even ? ""
                                                       : fmt::format(" (anisotropic {:a} {:a}, turned {:a})",
                                                                     grained.alpha[0], grained.alpha[1], turn),
                                               columns[6][i], columns[7][i], columns[8][i], hostile::to_text(poses[i]));
                        });
                    }
                }
    }
}

// Receivers farther from the light than its size. Closer than that, rounding decides whether a point is inside the
// light or in front of it.
constexpr std::array outside{Stratum::above, Stratum::straddling, Stratum::below, Stratum::grazing, Stratum::far};

// One pose in doubles that are all floats: centre, normal, view, axis, across.
using Asked = std::array<double, 15>;

double in_double(const Asked& at, shading::LightConstants light, SpecularMethod method, double alpha) {
    const auto vec = [&](std::size_t first) { return hostile::Vec{at[first], at[first + 1], at[first + 2]}; };
    for (std::size_t k = 0; k < 3; ++k) {
        light.axis[k] = static_cast<float>(at[9 + k]);
        light.width_direction[k] = static_cast<float>(at[12 + k]);
    }
    return specular_in_double(light, method, vec(0), vec(3), vec(6), alpha);
}

// The greatest change of the double result, summed over its inputs, when each moves by a unit in the last place (of the
// distance for the centre, of 1 for directions).
double sensitivity(const Asked& at, const shading::LightConstants& light, SpecularMethod method, double alpha,
                   double value) {
    constexpr double ulp = 0x1p-23;
    const double distance = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    double sum = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double step = i < 3 ? distance * ulp : ulp;
        Asked up = at;
        Asked down = at;
        up[i] += step;
        down[i] -= step;
        sum += std::fmax(std::fabs(in_double(up, light, method, alpha) - value),
                         std::fabs(in_double(down, light, method, alpha) - value));
    }
    for (float shading::LightConstants::*const size :
         {&shading::LightConstants::radius, &shading::LightConstants::width, &shading::LightConstants::height,
          &shading::LightConstants::length}) {
        shading::LightConstants larger = light;
        larger.*size = std::nextafter(larger.*size, HUGE_VALF);
        sum += std::fabs(in_double(at, larger, method, alpha) - value);
    }
    return sum + std::fabs(in_double(at, light, method, alpha * (1.0 + ulp)) - value);
}

// Every set's kernel against the formula in double. α from 1e-2 on: for narrower lobes, which scale with α², the effect
// of a rounding is no longer its slope times the rounding.
template<Shape shape>
void against_double(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t of_one_light = outside.size() * 3;
    const std::size_t sets = simd::available_sets().size();
    std::array<std::vector<float>, 9> columns;
    for (auto& each : columns)
        each.resize(of_one_light);
    std::vector<float> scale(of_one_light);
    std::vector<float> grazing(of_one_light);
    std::vector<Asked> asked(of_one_light);
    std::vector<Pose> poses(of_one_light);
    for (std::uint64_t done = 0; done < evaluations; done += of_one_light * sets) {
        const Pose light = hostile::as_float(hostile::random_light(shape, random));
        for (std::size_t i = 0; i < of_one_light; ++i) {
            poses[i] = hostile::as_float(hostile::receiver(light, outside[i % outside.size()], random));
            const Pose& p = poses[i];
            const hostile::Vec v = eye(p.normal, i, random);
            const auto narrow = [](double x) { return static_cast<double>(static_cast<float>(x)); };
            asked[i] = {p.center.x, p.center.y,  p.center.z,  p.normal.x,  p.normal.y,
                        p.normal.z, narrow(v.x), narrow(v.y), narrow(v.z), p.axis.x,
                        p.axis.y,   p.axis.z,    p.across.x,  p.across.y,  p.across.z};
            for (std::size_t k = 0; k < 9; ++k)
                columns[k][i] = static_cast<float>(k < 3 ? -asked[i][k] : asked[i][k]);
        }
        shading::Surfaces surfaces;
        for (std::size_t k = 0; k < 3; ++k) {
            surfaces.position[k] = columns[k].data();
            surfaces.normal[k] = columns[3 + k].data();
            surfaces.view[k] = columns[6 + k].data();
        }
        surfaces.count = of_one_light;
        const shading::LightConstants constants = hostile::light_constants(light);
        const auto alpha = static_cast<float>(std::exp(random.uniform(std::log(1e-2), 0.0)));
        const auto method = static_cast<SpecularMethod>(random.bits() % method_count);
        std::vector<std::pair<double, double>> truth; // and its tolerance
        for (const Asked& at : asked) {
            const double value = in_double(at, constants, method, static_cast<double>(alpha));
            truth.emplace_back(value, 1e-5 * value + 5e-3 +
                                          8.0 * sensitivity(at, constants, method, static_cast<double>(alpha), value));
        }
        for (const simd::InstructionSet set : simd::available_sets()) {
            const shading::SpecularKernels& kernels = shading::specular_kernels(set);
            kernels.specular(surfaces, constants, alpha, method, scale.data(), grazing.data());
            for (std::size_t i = 0; i < of_one_light; ++i) {
                const Asked& at = asked[i];
                // Below 1e-6 floats cannot tell which side of the surface is visible.
                if (std::fabs(at[3] * at[6] + at[4] * at[7] + at[5] * at[8]) < 1e-6) {
                    tally.looked_at(1);
                    continue;
                }
                tally.hold(std::fabs(static_cast<double>(scale[i]) - truth[i].first) / truth[i].second, [&] {
                    return fmt::format("method {} {}: {:.9g} for {:.9g}, alpha {:a} view {:a} {:a} {:a} {}",
                                       static_cast<int>(method), kernels.name, scale[i], truth[i].first, alpha, at[6],
                                       at[7], at[8], hostile::to_text(poses[i]));
                });
            }
        }
    }
}

constexpr const char* double_bar = "5e-3 of the light's luminance, 1e-5 of the value, 8 times what 1 ulp changes";
constexpr const char* bar = "finite and not negative; ltc not above 1; the share of grazing light in [0, 1]";

} // namespace

std::span<const StressSubject> specular_stress() {
    static constexpr std::array subjects{
        StressSubject{"specular of a sphere", bar, 1.0, specular<Shape::sphere>},
        StressSubject{"specular of a disk", bar, 1.0, specular<Shape::disk>},
        StressSubject{"specular of a rectangle", bar, 1.0, specular<Shape::rectangle>},
        StressSubject{"specular of a tube", bar, 1.0, specular<Shape::tube>},
        StressSubject{"specular of a sphere to double", double_bar, 0.05, against_double<Shape::sphere>},
        StressSubject{"specular of a disk to double", double_bar, 0.05, against_double<Shape::disk>},
        StressSubject{"specular of a rectangle to double", double_bar, 0.05, against_double<Shape::rectangle>},
        StressSubject{"specular of a tube to double", double_bar, 0.05, against_double<Shape::tube>},
    };
    return subjects;
}

} // namespace gonio::measure::detail
