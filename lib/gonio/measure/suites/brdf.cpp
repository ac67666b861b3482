// Reflectances: each material's codes against its formula in double, and the share of light that each material
// reflects.
#include <gonio/measure/brdf_cases.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/shading/furnace.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/shading_constants.hpp>

#include <array>
#include <cmath>
#include <utility>

namespace gonio::measure::detail {

namespace {

using shading::vec3;

// One material for each group, as the kernels take them.
struct Cases {
    static constexpr std::size_t group_size = 128;

    std::vector<BrdfParameters> parameters;
    std::array<std::vector<float>, 9> columns; // position (of a light at the origin: −l), normal, view
    std::vector<float> candela;

    [[nodiscard]] std::size_t size() const { return candela.size(); }
    template<class S>
    [[nodiscard]] vec3<S> at(std::size_t first, std::size_t i) const {
        return {static_cast<S>(columns[first][i]), static_cast<S>(columns[first + 1][i]),
                static_cast<S>(columns[first + 2][i])};
    }
};

Cases make_cases(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Cases cases;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % Cases::group_size == 0) cases.parameters.emplace_back(random);
        const BrdfPose pose = ordinary_brdf_pose(random);
        const float values[9] = {-pose.l.x, -pose.l.y, -pose.l.z, pose.n.x, pose.n.y,
                                 pose.n.z,  pose.v.x,  pose.v.y,  pose.v.z};
        for (std::size_t k = 0; k < 9; ++k)
            cases.columns[k].push_back(values[k]);
        cases.candela.push_back(1.0F);
    }
    return cases;
}

// Luminance of the green channel under 1 cd at the distance |l|, about 1.
template<class M, class S>
void one_by_one(const Cases& cases, std::span<S> luminance) {
    auto material = make<M, S>(cases.parameters.front());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (i % Cases::group_size == 0) material = make<M, S>(cases.parameters[i / Cases::group_size]);
        const vec3<S> to_light = cases.at<S>(0, i) * S(-1);
        const vec3<S> n = cases.at<S>(3, i);
        const S d2 = dot(to_light, to_light);
        const S inverse = S(1) / std::sqrt(d2);
        const vec3<S> l = to_light * inverse;
        luminance[i] = brdf(material, n, l, cases.at<S>(6, i)).y * dot(n, l) / d2;
    }
}

Method<Cases> kernel_method(const std::string& name, std::size_t kind, const shading::Kernels& kernels) {
    const auto work = [&kernels, kind](const Cases& cases, std::span<float> luminance) {
        std::array<float, Cases::group_size> red{};
        std::array<float, Cases::group_size> blue{};
        shading::LightConstants light;
        for (std::size_t g = 0; g < cases.parameters.size(); ++g) {
            const std::size_t first = g * Cases::group_size;
            shading::Surfaces surfaces;
            for (std::size_t k = 0; k < 3; ++k) {
                surfaces.position[k] = cases.columns[k].data() + first;
                surfaces.normal[k] = cases.columns[3 + k].data() + first;
                surfaces.view[k] = cases.columns[6 + k].data() + first;
            }
            surfaces.count = std::min(Cases::group_size, cases.size() - first);
            light.intensity_cd = cases.candela.data() + first;
            float* const rgb[3] = {red.data(), luminance.data() + first, blue.data()};
            kernels.shade(surfaces, light, material_constants(scene_material(kind, cases.parameters[g])), rgb);
        }
    };
    return {name, kernels.name, work, {}};
}

// A material by its name, its index among the alternatives of a scene's Material, and its scalar codes.
struct Subject {
    std::string name;
    std::size_t kind;
    void (*in_double)(const Cases&, std::span<double>);
    void (*in_float)(const Cases&, std::span<float>);
    double (*white)(double roughness, double mu); // albedo of a material that should reflect all light
};

// The albedo of the white surface or the mirror (f0 = 1), which should lose no light.
template<class M>
double white_albedo(double roughness, double mu) {
    const auto core = core_material(white<M>(roughness));
    return directional_albedo(core, mu, lobe_alpha(core), 300, 120).y;
}

const std::vector<Subject>& subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> made;
        for_each_material([&]<class M>() {
            made.push_back({std::string(MaterialDescription<M>::kind), made.size(), one_by_one<M, double>,
                            one_by_one<M, float>, white_albedo<M>});
        });
        return made;
    }();
    return all;
}

std::vector<Method<Cases>> codes_of(const Subject& subject) {
    std::vector<Method<Cases>> methods{{subject.name, "double", {}, subject.in_double},
                                       {subject.name, "float", subject.in_float, {}}};
    for (const simd::InstructionSet set : simd::available_sets())
        if (set != simd::InstructionSet::scalar)
            methods.push_back(kernel_method(subject.name, subject.kind, shading::kernels(set)));
    return methods;
}

Result<Contest> of_material(const Subject& subject, const SuiteOptions& options) {
    Cases cases = make_cases(options.quick ? 1024 : 4096, options.seed);
    std::vector<double> truth(cases.size());
    subject.in_double(cases, truth);
    const auto methods = codes_of(subject);
    return contest_of({"brdf", subject.name, "all", "relative to the luminance under a point light", "surface point",
                       "the formula in double"},
                      methods, place_of(methods, subject.name, "float"), std::move(cases), std::move(truth), 1e-6);
}

// How far the albedo of a white surface, or of a perfect mirror, is from 1.
Result<Contest> of_white(const SuiteOptions& options) {
    Contest contest{{"brdf", "white furnace", "all", "|albedo − 1| over 5 roughnesses and 5 views, of white or f0 = 1",
                     "evaluation, one float at a time", "1: nothing is lost, nothing comes of nothing"},
                    0,
                    {}};
    const Cases cases = make_cases(1024, options.seed);
    for (const Subject& subject : subjects()) {
        const auto values = std::make_shared<std::vector<float>>(cases.size());
        const auto errors = [&subject] {
            std::vector<double> off;
            for (const double roughness : {0.1, 0.3, 0.5, 0.7, 1.0})
                for (const double mu : {0.02, 0.1, 0.3, 0.6, 1.0})
                    off.push_back(std::fabs(subject.white(roughness, mu) - 1.0));
            return off;
        };
        contest.contestants.push_back({subject.name,
                                       "float",
                                       {[&subject, values, cases] { subject.in_float(cases, *values); }, cases.size()},
                                       errors});
    }
    return contest;
}

} // namespace

std::vector<std::string> brdf_methods() {
    std::vector<std::string> names;
    for (const Subject& subject : subjects())
        names.emplace_back(subject.name);
    return names;
}

std::vector<ContestMaker> brdf_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const Subject& subject : subjects())
        makers.push_back({subject.name, "all", [&subject, options] { return of_material(subject, options); }});
    makers.push_back({"white furnace", "all", [options] { return of_white(options); }});
    return makers;
}

} // namespace gonio::measure::detail
