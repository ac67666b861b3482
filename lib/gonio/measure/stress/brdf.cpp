// Reflectances in float, in packs and by the kernels of every instruction set: values, samples and densities. Values
// and densities are also compared with double.
#include <gonio/measure/brdf_cases.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/shading/kernels.hpp>
#include <gonio/simd/baseline.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace gonio::measure::detail {

namespace {

using shading::vec3;

using Pack = simd::Baseline;

template<class S>
constexpr std::size_t lanes = sizeof(S) / sizeof(float);

bool good(float x) {
    return x >= 0.0F && x <= std::numeric_limits<float>::max();
}

// The results for a pose: f, a sampled l, its density, the density of l, f at the sampled l (one channel).
using Values = std::array<float, 9>;

bool good(const Values& values) {
    const float length2 = values[3] * values[3] + values[4] * values[4] + values[5] * values[5];
    return good(values[0]) && good(values[1]) && good(values[2]) && std::fabs(length2 - 1.0F) < 1e-5F &&
           good(values[6]) && good(values[7]) && good(values[8]);
}

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

std::string text(const BrdfParameters& parameters, const BrdfPose& pose) {
    std::string out = "n l v u";
    for (const vec3<float>& v : {pose.n, pose.l, pose.v, pose.u})
        out += fmt::format(" {:a} {:a} {:a}", v.x, v.y, v.z);
    out += "; parameters";
    for (const double p : parameters.p)
        out += fmt::format(" {:a}", p);
    return out;
}

// Each pose as a single float and as a lane of a pack.
template<class M, bool simple>
void reflectance(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t of_one_material = 16;
    constexpr std::size_t width = lanes<Pack>;
    for (std::uint64_t done = 0; done < evaluations; done += 2 * of_one_material) {
        const BrdfParameters parameters(random, true);
        const auto one = make<M, float, simple>(parameters);
        const auto many = make<M, Pack, simple>(parameters);
        for (std::size_t first = 0; first < of_one_material; first += width) {
            std::array<BrdfPose, width> poses;
            float columns[12][width];
            for (std::size_t k = 0; k < width; ++k) {
                poses[k] = hostile_brdf_pose(random);
                const BrdfPose& p = poses[k];
                const float values[12] = {p.n.x, p.n.y, p.n.z, p.l.x, p.l.y, p.l.z,
                                          p.v.x, p.v.y, p.v.z, p.u.x, p.u.y, p.u.z};
                for (std::size_t j = 0; j < 12; ++j)
                    columns[j][k] = values[j];
                tally.require(good(evaluate<float>(one, p.n, p.l, p.v, p.u)),
                              [&] { return "float: " + text(parameters, p); });
            }
            Pack in[12];
            for (std::size_t j = 0; j < 12; ++j)
                simd::load(&columns[j][0], in[j]);
            const std::array<Pack, 9> out = evaluate<Pack>(many, {in[0], in[1], in[2]}, {in[3], in[4], in[5]},
                                                           {in[6], in[7], in[8]}, {in[9], in[10], in[11]});
            std::array<Values, width> answers;
            for (std::size_t j = 0; j < 9; ++j) {
                float lane[width];
                simd::store(out[j], &lane[0]);
                for (std::size_t k = 0; k < width; ++k)
                    answers[k][j] = lane[k];
            }
            for (std::size_t k = 0; k < width; ++k)
                tally.require(good(answers[k]), [&] { return "pack: " + text(parameters, poses[k]); });
            tally.looked_at(2 * width);
        }
    }
}

// One material for a batch, lit from 1 m by 1 cd.
void by_kernels(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t batch = 251; // leaves a packet partly filled
    constexpr std::size_t kinds = std::variant_size_v<Material>;
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
    std::vector<BrdfPose> poses(batch);
    for (std::uint64_t done = 0; done < evaluations; done += batch * simd::available_sets().size()) {
        for (std::size_t i = 0; i < batch; ++i) {
            const BrdfPose& p = poses[i] = hostile_brdf_pose(random);
            const float values[9] = {-p.l.x, -p.l.y, -p.l.z, p.n.x, p.n.y, p.n.z, p.v.x, p.v.y, p.v.z};
            for (std::size_t k = 0; k < 9; ++k)
                columns[k][i] = values[k];
        }
        const BrdfParameters parameters(random, true);
        const std::size_t kind = random.bits() % kinds;
        const auto constants = material_constants(scene_material(kind, parameters));
        for (const simd::InstructionSet set : simd::available_sets()) {
            float* const channels[3] = {out[0].data(), out[1].data(), out[2].data()};
            shading::kernels(set).shade(surfaces, light, constants, channels);
            tally.looked_at(batch);
            for (std::size_t i = 0; i < batch; ++i)
                tally.require(good(out[0][i]) && good(out[1][i]) && good(out[2][i]), [&] {
                    return fmt::format("{}, material {}: {}", shading::kernels(set).name, kind,
                                       text(parameters, poses[i]));
                });
        }
    }
}

// The input of a reflectance: n, l, v and the material's parameters, all floats. The answer is three channels and the
// density of l.
using Asked = std::array<double, 17>;
using Answer = std::array<double, 4>;

template<class M, class S, bool simple>
Answer answer(const Asked& asked, BrdfParameters parameters) {
    const auto vec = [&](std::size_t first) {
        return vec3<S>{S(asked[first]), S(asked[first + 1]), S(asked[first + 2])};
    };
    std::copy(asked.begin() + 9, asked.end(), parameters.p.begin());
    const auto material = make<M, S, simple>(parameters);
    const vec3<S> f = brdf(material, vec(0), vec(3), vec(6));
    return {double(f.x), double(f.y), double(f.z), double(pdf_brdf(material, vec(0), vec(6), vec(3)))};
}

// The tolerance is eight times the change of the double result when each input moves by half a unit in the last place
// (of 1 for directions), plus eight such units of the greatest channel. Where a cosine is below 1e-6, floats cannot
// tell the two sides of the surface apart, so these cases are skipped.
template<class M, bool simple>
void against_double(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr double half_ulp = 0x1p-24;
    // The energy that a lobe loses comes from a table with an error of 6e-5: where its polynomial crosses 0, the last
    // digits depend on rounding.
    constexpr bool of_table = std::is_same_v<M, KullaContyMaterial>;
    constexpr double off = of_table ? 1e-3 : 0.0;
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        BrdfParameters parameters(random, true);
        for (double& p : parameters.p)
            p = static_cast<double>(static_cast<float>(p));
        const BrdfPose pose = hostile_brdf_pose(random);
        Asked asked{};
        std::size_t next = 0;
        for (const vec3<float>& d : {pose.n, pose.l, pose.v})
            for (const float x : {d.x, d.y, d.z})
                asked[next++] = static_cast<double>(x);
        std::copy(parameters.p.begin(), parameters.p.end(), asked.begin() + 9);
        const auto cosine = [&](std::size_t to) {
            return asked[0] * asked[to] + asked[1] * asked[to + 1] + asked[2] * asked[to + 2];
        };
        if (std::fabs(cosine(3)) < 1e-6 || std::fabs(cosine(6)) < 1e-6) {
            tally.looked_at(1);
            continue;
        }
        const Answer truth = answer<M, double, simple>(asked, parameters);
        Answer moved{};
        for (std::size_t i = 0; i < asked.size(); ++i) {
            Asked beside = asked;
            beside[i] += i < 9 ? half_ulp : half_ulp * asked[i];
            if (i >= 9 && beside[i] > 1.0) beside[i] = asked[i] * (1.0 - half_ulp);
            const Answer there = answer<M, double, simple>(beside, parameters);
            for (std::size_t k = 0; k < moved.size(); ++k)
                moved[k] += std::fabs(there[k] - truth[k]);
        }
        const Answer found = answer<M, float, simple>(asked, parameters);
        const double greatest = *std::max_element(truth.begin(), truth.begin() + 3);
        double worst = 0.0;
        for (std::size_t k = 0; k < truth.size(); ++k) {
            const double size = k < 3 ? greatest : truth[k];
            const double bar = 8.0 * (moved[k] + half_ulp * size) + off * size + 1e-30;
            worst = std::fmax(worst, std::fabs(found[k] - truth[k]) / bar);
        }
        tally.hold(worst, [&] {
            return fmt::format("{} {} {} density {} for {} {} {} {}: {}", found[0], found[1], found[2], found[3],
                               truth[0], truth[1], truth[2], truth[3], text(parameters, pose));
        });
    }
}

// Checks a material in float, and against double.
template<class M, bool simple>
void material(Random& random, std::uint64_t evaluations, StressTally& tally) {
    reflectance<M, simple>(random, evaluations - evaluations / 8, tally);
    against_double<M, simple>(random, evaluations / 8, tally);
}

constexpr const char* bar =
    "8 times what double changes by under roundings of the input, and 8 roundings; samples unit, nothing negative";

} // namespace

std::span<const StressSubject> brdf_stress() {
    static const std::vector<StressSubject> subjects = [] {
        std::vector<StressSubject> made;
        for_each_material([&]<class M>() {
            constexpr bool of_table = std::is_same_v<M, KullaContyMaterial>;
            constexpr const char* bound = of_table ? "the same and 1e-3 of the value" : bar;
            made.push_back({MaterialDescription<M>::kind, bound, 0.3, material<M, false>});
            if constexpr (HasSimpleForm<M>) {
                static const std::string name = fmt::format("{} in its simple form", MaterialDescription<M>::kind);
                made.push_back({name, bound, 0.3, material<M, true>});
            }
        });
        made.push_back({"materials by the kernels", "finite and not negative", 1.0, by_kernels});
        return made;
    }();
    return subjects;
}

} // namespace gonio::measure::detail
