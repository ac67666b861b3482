// Irradiance and shading by the kernels of every instruction set: against double where there is a tolerance, and on
// numbers at the ends of the float range, where only a finite number is promised.
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/shading/occlusion.hpp>
#include <gonio/simd/dispatch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace gonio::measure::detail {

namespace {

using hostile::Pose;
using hostile::Shape;
using hostile::Stratum;
using Kind = shading::LightConstants::Kind;

constexpr std::size_t group = std::size_t{9} * 16; // receivers of one light

// Positions and normals, or views too.
template<std::size_t count>
struct Columns {
    std::array<std::vector<float>, count> column;

    explicit Columns(std::size_t size) {
        for (std::vector<float>& each : column)
            each.resize(size);
    }
    [[nodiscard]] shading::Surfaces surfaces() const {
        shading::Surfaces made;
        for (std::size_t k = 0; k < 3; ++k) {
            made.position[k] = column[k].data();
            made.normal[k] = column[3 + k].data();
            if constexpr (count == 9) made.view[k] = column[6 + k].data();
        }
        made.count = column[0].size();
        return made;
    }
};

// Within 1e-5·E/L + 1e-6·δ of the closed form in double on the same floats, δ the angle that the light subtends.
template<Shape shape>
void irradiance(Random& random, std::uint64_t evaluations, StressTally& tally) {
    Columns<6> columns(group);
    std::vector<Pose> poses(group);
    std::vector<double> truth(group);
    std::vector<float> lx(group);
    const std::size_t sets = simd::available_sets().size();
    bool mixed = false;
    for (std::uint64_t done = 0; done < evaluations; done += group * sets) {
        const Pose light = hostile::as_float(hostile::random_light(shape, random));
        mixed = !mixed; // alternates between all strata mixed and a single stratum for many packets
        for (std::size_t i = 0; i < group; ++i) {
            const auto stratum = static_cast<Stratum>(mixed ? i % hostile::stratum_count : i / 16);
            poses[i] = hostile::as_float(hostile::receiver(light, stratum, random));
            truth[i] = hostile::exact<double>(poses[i]);
            const double values[6] = {-poses[i].center.x, -poses[i].center.y, -poses[i].center.z,
                                      poses[i].normal.x,  poses[i].normal.y,  poses[i].normal.z};
            for (std::size_t k = 0; k < 6; ++k)
                columns.column[k][i] = static_cast<float>(values[k]);
        }
        const shading::LightConstants constants = hostile::light_constants(light);
        for (const simd::InstructionSet set : simd::available_sets()) {
            const shading::Kernels& kernels = shading::kernels(set);
            kernels.irradiance(columns.surfaces(), constants, lx.data());
            for (std::size_t i = 0; i < group; ++i) {
                const auto value = static_cast<double>(lx[i]);
                const bool number = lx[i] >= 0.0F && lx[i] <= std::numbers::pi_v<float>;
                const double share =
                    number ? std::fabs(value - truth[i]) / (1e-5 * truth[i] + 1e-6 * hostile::subtended(poses[i]))
                           : HUGE_VAL;
                tally.hold(share, [&] {
                    return fmt::format("{}: {:.9g} for {:.9g}, {}", kernels.name, value, truth[i],
                                       hostile::to_text(poses[i]));
                });
            }
        }
        // The approximations of renderers, for which only a finite number can be required.
        for (const auto method :
             {shading::Approximation::point, shading::Approximation::frostbite, shading::Approximation::ue4}) {
            const shading::Kernels& kernels = shading::kernels(simd::best_available());
            kernels.approximate_irradiance(columns.surfaces(), constants, method, lx.data());
            tally.looked_at(group);
            for (std::size_t i = 0; i < group; ++i)
                tally.require(is_amount(static_cast<double>(lx[i])), [&] {
                    return fmt::format("approximation {}: {}, {}", static_cast<int>(method), lx[i],
                                       hostile::to_text(poses[i]));
                });
        }
        for (std::size_t i = 0; i < group && (shape == Shape::sphere || shape == Shape::tube); ++i) {
            const Pose& p = poses[i];
            const double left = shape == Shape::sphere
                                    ? shading::sky_visibility_sphere(p.center, p.p, p.normal)
                                    : shading::sky_visibility_tube(p.center, p.axis, p.p, p.q, p.normal);
            tally.looked_at(1);
            tally.require(left >= 0.0 && left <= 1.0,
                          [&] { return fmt::format("sky left {}, {}", left, hostile::to_text(p)); });
        }
    }
}

float narrow_number(Random& random) {
    return static_cast<float>(hostile::number(random));
}

shading::LightConstants any_light(Random& random) {
    shading::LightConstants light;
    light.kind = static_cast<Kind>(random.bits() % 5);
    const hostile::Vec axis = hostile::random_direction(random);
    const hostile::Vec across = hostile::tilted(axis, 0.0, random);
    const double axes[6] = {axis.x, axis.y, axis.z, across.x, across.y, across.z};
    for (std::size_t k = 0; k < 3; ++k) {
        light.position[k] = narrow_number(random);
        light.color[k] = std::fabs(narrow_number(random));
        light.axis[k] = static_cast<float>(axes[k]);
        light.width_direction[k] = static_cast<float>(axes[3 + k]);
    }
    light.radius = std::fabs(narrow_number(random));
    light.width = std::fabs(narrow_number(random));
    light.height = std::fabs(narrow_number(random));
    light.length = std::fabs(narrow_number(random));
    light.two_sided = random.bits() % 2 == 0;
    light.inverse_range = random.bits() % 3 == 0 ? std::fabs(narrow_number(random)) : 0.0F;
    return light;
}

shading::MaterialConstants any_material(Random& random) {
    const bool matte = random.bits() % 2 == 0;
    const auto share = [&] {
        return random.bits() % 3 == 0 ? static_cast<float>(random.bits() % 2) : static_cast<float>(random.uniform());
    };
    shading::Frostbite<float> material{};
    for (float* channel :
         {&material.albedo.x, &material.f0.x, &material.albedo.y, &material.f0.y, &material.albedo.z, &material.f0.z})
        *channel = share();
    material.f90 = share();
    material.linear_roughness = share();
    material.alpha = material.linear_roughness * material.linear_roughness;
    return matte ? constants_of(shading::Lambert<float>{material.albedo}) : constants_of(material);
}

// Any finite floats: coordinates, sizes and colours up to the greatest, zeros and denormals. Results must be finite and
// not negative.
void any_floats(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t points = 251; // leaves a packet partly filled
    Columns<9> columns(points);
    std::vector<float> candela(points);
    std::vector<float> lx(points);
    std::array<std::vector<float>, 3> rgb;
    for (std::vector<float>& channel : rgb)
        channel.resize(points);
    for (std::uint64_t done = 0; done < evaluations; done += 4 * points * simd::available_sets().size()) {
        shading::LightConstants light = any_light(random);
        for (std::size_t i = 0; i < points; ++i) {
            const hostile::Vec n =
                random.bits() % 4 == 0 ? hostile::Vec{0.0, 0.0, 1.0} : hostile::random_direction(random);
            const std::uint64_t choice = random.bits() % 5;
            const hostile::Vec v = choice == 0 ? n * -1.0 : choice == 1 ? n : hostile::random_direction(random);
            const bool on_light = random.bits() % 16 == 0;
            const double directions[6] = {n.x, n.y, n.z, v.x, v.y, v.z};
            for (std::size_t k = 0; k < 3; ++k)
                columns.column[k][i] = on_light ? light.position[k] : narrow_number(random);
            for (std::size_t k = 0; k < 6; ++k)
                columns.column[3 + k][i] = static_cast<float>(directions[k]);
            candela[i] = std::fabs(narrow_number(random));
        }
        light.intensity_cd = candela.data();
        const shading::MaterialConstants material = any_material(random);
        for (const simd::InstructionSet set : simd::available_sets()) {
            const shading::Kernels& kernels = shading::kernels(set);
            float* const out[3] = {rgb[0].data(), rgb[1].data(), rgb[2].data()};
            kernels.irradiance(columns.surfaces(), light, lx.data());
            kernels.shade(columns.surfaces(), light, material, out);
            tally.looked_at(4 * points);
            for (std::size_t i = 0; i < points; ++i)
                for (const float value : {lx[i], rgb[0][i], rgb[1][i], rgb[2][i]})
                    tally.require(is_amount(static_cast<double>(value)), [&] {
                        std::string text = fmt::format(
                            "{}: {} of light kind {} at {:a} {:a} {:a} radius {:a} width {:a} height {:a} length {:a} "
                            "inverse range {:a} axis {:a} {:a} {:a} across {:a} {:a} {:a}; point, normal, view",
                            kernels.name, value, static_cast<int>(light.kind), light.position[0], light.position[1],
                            light.position[2], light.radius, light.width, light.height, light.length,
                            light.inverse_range, light.axis[0], light.axis[1], light.axis[2], light.width_direction[0],
                            light.width_direction[1], light.width_direction[2]);
                        for (const std::vector<float>& column : columns.column)
                            text += fmt::format(" {:a}", column[i]);
                        return text;
                    });
        }
    }
}

constexpr const char* bar = "1e-5 E/L + 1e-6 δ of double, [0, π]; approximations finite, sky left in [0, 1]";

} // namespace

std::span<const StressSubject> irradiance_stress() {
    static constexpr std::array subjects{
        StressSubject{"irradiance of a sphere", bar, 1.0, irradiance<Shape::sphere>},
        StressSubject{"irradiance of a disk", bar, 1.0, irradiance<Shape::disk>},
        StressSubject{"irradiance of a rectangle", bar, 1.0, irradiance<Shape::rectangle>},
        StressSubject{"irradiance of a tube", bar, 1.0, irradiance<Shape::tube>},
        StressSubject{"shading of any floats", "finite and not negative", 1.0, any_floats},
    };
    return subjects;
}

} // namespace gonio::measure::detail
