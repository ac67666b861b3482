// A hundred million poses of every reflectance, in float and in packs: values, samples and densities are numbers,
// finite and not negative, and samples unit. Too long for a test.
//
//   gonio-brdf-sweep [POSES [SEED]]
//
// Default 10'000'000 poses, one material and one view and light each: evaluated as one float and as a pack of the
// processor's base instruction set, and shaded by the kernels of every set under a light in that direction. Parameters
// are corners (0, 1e-4, 1) as often as not; directions are even, as close to the surface as floats are, near the
// mirror, near the eye and opposite to it, in the surface and below. Prints the count of each material; exit 1 where
// one is no number.
#include <gonio/measure/random.hpp>
#include <gonio/preview/shading_constants.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/dispatch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

namespace {

using namespace gonio;
using measure::Random;
using shading::vec3;

#if defined(__x86_64__)
using Pack = simd::pack<float, simd::sse2>;
#elif defined(__aarch64__)
using Pack = simd::pack<float, simd::neon>;
#endif
constexpr std::size_t lanes = Pack::lanes;

float narrow(double x) {
    return static_cast<float>(x);
}

vec3<double> about(const vec3<double>& n, double cosine, double phi) {
    const shading::TangentFrame<double> frame(n);
    const double sine = std::sqrt(std::fmax((1.0 - cosine) * (1.0 + cosine), 0.0));
    return frame.to_world({sine * std::cos(phi), sine * std::sin(phi), cosine});
}

vec3<double> even(Random& random) {
    const double z = random.uniform(-1.0, 1.0);
    return about({0.0, 0.0, 1.0}, z, random.uniform(0.0, 2.0 * std::numbers::pi));
}

double shallow(Random& random) {
    const double magnitude = std::exp(random.uniform(std::log(1e-40), 0.0));
    return random.uniform() < 0.1 ? -magnitude : magnitude;
}

struct Pose {
    vec3<float> n, l, v, u;
};

vec3<float> as_float(const vec3<double>& a) {
    return {narrow(a.x), narrow(a.y), narrow(a.z)};
}

Pose random_pose(Random& random) {
    const vec3<double> n =
        random.uniform() < 0.3 ? vec3<double>{0.0, 0.0, random.uniform() < 0.5 ? 1.0 : -1.0} : even(random);
    const auto turn = [&] { return random.uniform(0.0, 2.0 * std::numbers::pi); };
    const vec3<double> v = about(n, random.uniform() < 0.5 ? shallow(random) : random.uniform(), turn());
    const vec3<double> mirrored = n * (2.0 * dot(n, v)) - v;
    vec3<double> l{0.0, 0.0, 0.0};
    switch (random.bits() % 6) {
    case 0:
        l = even(random);
        break;
    case 1:
        l = about(n, shallow(random), turn());
        break;
    case 2:
        l = about(mirrored, 1.0 - std::exp(random.uniform(std::log(1e-16), std::log(0.5))), turn());
        break;
    case 3:
        l = about(v, 1.0 - std::exp(random.uniform(std::log(1e-16), std::log(0.5))), turn());
        break;
    case 4:
        l = random.uniform() < 0.5 ? v : mirrored;
        break;
    default:
        l = v * -1.0;
        break;
    }
    const auto uniform = [&] {
        return random.uniform() < 0.05 ? (random.uniform() < 0.5 ? 0.0 : 1.0 - 6e-8) : random.uniform();
    };
    return {as_float(n), as_float(l), as_float(v), as_float({uniform(), uniform(), uniform()})};
}

struct Parameters {
    std::array<double, 8> p;

    explicit Parameters(Random& random) {
        static constexpr double corners[] = {0.0, 1e-4, 1.0, 1.0};
        for (double& value : p)
            value = random.uniform() < 0.5 ? corners[random.bits() % 4] : random.uniform();
    }
};

template<class S>
vec3<S> color(const Parameters& from, std::size_t first) {
    return {S(from.p[first]), S(from.p[first + 1]), S(from.p[first + 2])};
}
template<class S>
void make(const Parameters& from, shading::Lambert<S>& to) {
    to = {color<S>(from, 0)};
}
template<class S>
void make(const Parameters& from, shading::Eon<S>& to) {
    to = {color<S>(from, 0), S(from.p[3])};
}
template<class S>
void make(const Parameters& from, shading::Ggx<S>& to) {
    to = {color<S>(from, 0), S(from.p[3])};
}
template<class S>
void make(const Parameters& from, shading::KullaConty<S>& to) {
    to = shading::kulla_conty_material(color<S>(from, 0), S(from.p[3]));
}
template<class S>
void make(const Parameters& from, shading::Frostbite<S>& to) {
    to = shading::frostbite_material(color<S>(from, 0), S(from.p[3]), S(from.p[4]), S(from.p[5]));
}
template<class S>
void make(const Parameters& from, shading::Ue4<S>& to) {
    to = shading::ue4_material(color<S>(from, 0), S(from.p[3]), S(from.p[4]), S(from.p[5]), S(from.p[6]));
}
template<class S>
void make(const Parameters& from, shading::RememberMe<S>& to) {
    to = shading::remember_me_material(color<S>(from, 0), color<S>(from, 3), S(from.p[6]), S(from.p[7]));
}

bool good(float x) {
    return x >= 0.0F && x <= std::numeric_limits<float>::max();
}

// The eight numbers that a pose gives, and whether they are numbers.
struct Answer {
    std::array<float, 9> values; // f, sampled l, its density, density of l, f at the sampled l (one channel)

    [[nodiscard]] bool ok() const {
        const float length2 = values[3] * values[3] + values[4] * values[4] + values[5] * values[5];
        return good(values[0]) && good(values[1]) && good(values[2]) && std::fabs(length2 - 1.0F) < 1e-5F &&
               good(values[6]) && good(values[7]) && good(values[8]);
    }
};

template<class S, class Material>
std::array<S, 9> evaluate(const Material& material, const vec3<S>& n, const vec3<S>& l, const vec3<S>& v,
                          const vec3<S>& u) {
    const vec3<S> f = brdf(material, n, l, v);
    const shading::BrdfSample<S> sample = sample_brdf(material, n, v, u);
    return {f.x,
            f.y,
            f.z,
            sample.l.x,
            sample.l.y,
            sample.l.z,
            sample.pdf,
            pdf_brdf(material, n, v, l),
            brdf(material, n, sample.l, v).y};
}

void report(const char* name, const char* code, const Parameters& p, const Pose& pose, const Answer& answer) {
    (void)std::printf("%s (%s) is no number at\n  n %a %a %a l %a %a %a v %a %a %a u %a %a %a\n  parameters", name,
                      code, pose.n.x, pose.n.y, pose.n.z, pose.l.x, pose.l.y, pose.l.z, pose.v.x, pose.v.y, pose.v.z,
                      pose.u.x, pose.u.y, pose.u.z);
    for (const double value : p.p)
        (void)std::printf(" %g", value);
    (void)std::printf("\n  gives");
    for (const float value : answer.values)
        (void)std::printf(" %g", static_cast<double>(value));
    (void)std::printf("\n");
}

template<template<class> class Material>
std::size_t sweep(const char* name, std::size_t count, std::uint64_t seed) {
    constexpr std::size_t of_one_material = 16;
    Random random(seed);
    std::size_t broken = 0;
    for (std::size_t done = 0; done < count; done += of_one_material) {
        const Parameters parameters(random);
        Material<float> one;
        Material<Pack> many;
        make(parameters, one);
        make(parameters, many);
        for (std::size_t group = 0; group < of_one_material; group += lanes) {
            std::array<Pose, lanes> poses;
            float columns[12][lanes];
            for (std::size_t k = 0; k < lanes; ++k) {
                poses[k] = random_pose(random);
                const float values[12] = {poses[k].n.x, poses[k].n.y, poses[k].n.z, poses[k].l.x,
                                          poses[k].l.y, poses[k].l.z, poses[k].v.x, poses[k].v.y,
                                          poses[k].v.z, poses[k].u.x, poses[k].u.y, poses[k].u.z};
                for (std::size_t j = 0; j < 12; ++j)
                    columns[j][k] = values[j];
                const Answer answer{evaluate<float>(one, poses[k].n, poses[k].l, poses[k].v, poses[k].u)};
                if (answer.ok()) continue;
                if (broken++ < 3) report(name, "float", parameters, poses[k], answer);
            }
            Pack in[12];
            for (std::size_t j = 0; j < 12; ++j)
                simd::load(&columns[j][0], in[j]);
            const std::array<Pack, 9> out = evaluate<Pack>(many, {in[0], in[1], in[2]}, {in[3], in[4], in[5]},
                                                           {in[6], in[7], in[8]}, {in[9], in[10], in[11]});
            std::array<Answer, lanes> answers;
            for (std::size_t j = 0; j < 9; ++j) {
                float lane[lanes];
                simd::store(out[j], &lane[0]);
                for (std::size_t k = 0; k < lanes; ++k)
                    answers[k].values[j] = lane[k];
            }
            for (std::size_t k = 0; k < lanes; ++k) {
                if (answers[k].ok()) continue;
                if (broken++ < 3) report(name, "pack", parameters, poses[k], answers[k]);
            }
        }
    }
    (void)std::printf("%-12s %11zu poses, %zu no numbers\n", name, count, broken);
    (void)std::fflush(stdout);
    return broken;
}

glm::dvec3 rgb(const Parameters& from, std::size_t first) {
    return {from.p[first], from.p[first + 1], from.p[first + 2]};
}
Material scene_material(std::size_t kind, const Parameters& p) {
    switch (kind) {
    case 0:
        return LambertMaterial{rgb(p, 0)};
    case 1:
        return EonMaterial{rgb(p, 0), p.p[3]};
    case 2:
        return FrostbiteMaterial{rgb(p, 0), p.p[3], p.p[4], p.p[5]};
    case 3:
        return Ue4Material{rgb(p, 0), p.p[4], p.p[3], p.p[5], p.p[6]};
    case 4:
        return BlinnMaterial{rgb(p, 0), rgb(p, 3), p.p[6], p.p[7]};
    case 5:
        return GgxMaterial{rgb(p, 0), p.p[3]};
    default:
        return KullaContyMaterial{rgb(p, 0), p.p[3]};
    }
}

// One material for a batch, lit from 1 m by 1 cd.
std::size_t sweep_kernels(std::size_t count, std::uint64_t seed) {
    constexpr std::size_t batch = 251; // leaves a packet partly filled
    constexpr std::size_t kinds = std::variant_size_v<Material>;
    Random random(seed);
    std::size_t broken = 0;
    std::array<std::vector<float>, 9> columns;
    for (auto& column : columns)
        column.resize(batch);
    std::array<std::vector<float>, 3> out;
    for (auto& channel : out)
        channel.resize(batch);
    const std::vector<float> candela(batch, 1.0F);
    shading::LightConstants light;
    light.intensity_cd = candela.data();
    shading::Surfaces surfaces;
    for (std::size_t k = 0; k < 3; ++k) {
        surfaces.position[k] = columns[k].data();
        surfaces.normal[k] = columns[3 + k].data();
        surfaces.view[k] = columns[6 + k].data();
    }
    surfaces.count = batch;
    std::size_t poses = 0;
    for (; poses < count; poses += batch) {
        for (std::size_t i = 0; i < batch; ++i) {
            const Pose pose = random_pose(random);
            const float values[9] = {-pose.l.x, -pose.l.y, -pose.l.z, pose.n.x, pose.n.y,
                                     pose.n.z,  pose.v.x,  pose.v.y,  pose.v.z};
            for (std::size_t k = 0; k < 9; ++k)
                columns[k][i] = values[k];
        }
        const Parameters parameters(random);
        const auto constants = material_constants(scene_material(poses / batch % kinds, parameters));
        for (const simd::InstructionSet set : simd::available_sets()) {
            float* const channels[3] = {out[0].data(), out[1].data(), out[2].data()};
            shading::kernels(set).shade(surfaces, light, constants, channels);
            for (const std::vector<float>& channel : out)
                for (const float value : channel)
                    if (!good(value) && broken++ < 3)
                        (void)std::printf("material %zu is no number by %s\n", poses / batch % kinds,
                                          shading::kernels(set).name);
        }
    }
    (void)std::printf("%-12s %11zu poses by each of %zu sets, %zu no numbers\n", "kernels", poses,
                      simd::available_sets().size(), broken);
    return broken;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t poses = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000'000;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    const std::size_t each = poses / 7 + 1;
    std::size_t broken = sweep<shading::Lambert>("lambert", each, seed);
    broken += sweep<shading::Eon>("eon", each, seed + 1);
    broken += sweep<shading::Frostbite>("frostbite", each, seed + 2);
    broken += sweep<shading::Ue4>("ue4", each, seed + 3);
    broken += sweep<shading::RememberMe>("blinn", each, seed + 4);
    broken += sweep<shading::Ggx>("ggx", each, seed + 5);
    broken += sweep<shading::KullaConty>("kulla-conty", each, seed + 6);
    broken += sweep_kernels(poses, seed + 7);
    return broken == 0 ? 0 : 1;
}
