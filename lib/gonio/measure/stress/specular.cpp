// Specular luminance of lights with a size, by every method and instruction set.
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/simd/dispatch.hpp>

#include <fmt/format.h>

#include <array>
#include <vector>

namespace gonio::measure::detail {

namespace {

using hostile::Pose;
using hostile::Shape;
using hostile::Stratum;
using shading::SpecularMethod;

constexpr std::size_t group = 9 * 16; // receivers of one light
constexpr std::size_t method_count = 6;

// Any direction, above the surface or below it; some along the normal, some grazing.
hostile::Vec eye(hostile::Vec normal, std::size_t index, Random& random) {
    if (index % 7 == 0) return normal;
    if (index % 7 == 1) return hostile::tilted(normal, random.uniform(-1e-3, 1e-3), random);
    return hostile::random_direction(random);
}

// Numbers, not negative, and for linearly transformed cosines not above 1: F is 1 and so is the light.
template<Shape shape>
void specular(Random& random, std::uint64_t evaluations, StressTally& tally) {
    std::array<std::vector<float>, 9> columns;
    for (auto& each : columns)
        each.resize(group);
    std::vector<float> scale(group);
    std::vector<float> grazing(group);
    std::vector<Pose> poses(group);
    const std::size_t sets = simd::available_sets().size();
    for (std::uint64_t done = 0; done < evaluations; done += group * method_count * sets) {
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
        for (std::size_t m = 0; m < method_count; ++m)
            for (const simd::InstructionSet set : simd::available_sets()) {
                const shading::SpecularKernels& kernels = shading::specular_kernels(set);
                kernels.specular(surfaces, constants, alpha, static_cast<SpecularMethod>(m), scale.data(),
                                 grazing.data());
                const float most = m == 0 ? 1.0F : HUGE_VALF;
                tally.looked_at(group);
                for (std::size_t i = 0; i < group; ++i) {
                    const bool number = scale[i] >= 0.0F && scale[i] <= most && scale[i] < HUGE_VALF;
                    const bool share = grazing[i] >= 0.0F && grazing[i] <= 1.00001F;
                    tally.require(number && share, [&] {
                        return fmt::format("method {} {}: {} and {}, alpha {:a} view {:a} {:a} {:a} {}", m,
                                           kernels.name, scale[i], grazing[i], alpha, columns[6][i], columns[7][i],
                                           columns[8][i], hostile::to_text(poses[i]));
                    });
                }
            }
    }
}

constexpr const char* bar = "finite and not negative; ltc not above 1; the share of grazing light in [0, 1]";

} // namespace

std::span<const StressSubject> specular_stress() {
    static constexpr std::array subjects{
        StressSubject{"specular of a sphere", bar, 1.0, specular<Shape::sphere>},
        StressSubject{"specular of a disk", bar, 1.0, specular<Shape::disk>},
        StressSubject{"specular of a rectangle", bar, 1.0, specular<Shape::rectangle>},
        StressSubject{"specular of a tube", bar, 1.0, specular<Shape::tube>},
    };
    return subjects;
}

} // namespace gonio::measure::detail
