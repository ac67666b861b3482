#include <gonio/base/parallel.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/measure/sphere_truth.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/simd/dispatch.hpp>

#include <utility>

namespace gonio::measure {

namespace {

using shading::vec3;

// Calls function(vector to the centre, radius, normal) for one case after the other.
template<class S, class Function>
void one_by_one(const SphereCases& cases, std::span<float> e_over_l, const Function& function) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto at = [i](const std::array<std::vector<float>, 3>& v) {
            return vec3<S>{static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
        };
        const vec3<S> to_center = vec3<S>{S(0), S(0), S(0)} - at(cases.position);
        e_over_l[i] = static_cast<float>(function(to_center, S(1), at(cases.normal)));
    }
}

template<class S, class Function>
SphereMethod scalar_method(std::string name, std::string precision, Function function) {
    return {std::move(name), std::move(precision), [function](const SphereCases& cases, std::span<float> e_over_l) {
                one_by_one<S>(cases, e_over_l, function);
            }};
}

SphereMethod kernel_method(const shading::Kernels& kernels) {
    return {"exact", kernels.name, [&kernels](const SphereCases& cases, std::span<float> e_over_l) {
                kernels.irradiance(cases.surfaces(), SphereCases::light(), e_over_l.data());
            }};
}

} // namespace

std::vector<SphereMethod> sphere_methods() {
    std::vector<SphereMethod> methods;
    methods.push_back(scalar_method<double>("exact", "double", [](vec3<double> c, double r, vec3<double> n) {
        return shading::irradiance_sphere(c, r, n);
    }));
    methods.push_back(scalar_method<float>(
        "exact", "float", [](vec3<float> c, float r, vec3<float> n) { return shading::irradiance_sphere(c, r, n); }));
    for (const simd::InstructionSet set : simd::available_sets())
        if (set != simd::InstructionSet::scalar) methods.push_back(kernel_method(shading::kernels(set)));
    methods.push_back(scalar_method<float>("frostbite", "float", [](vec3<float> c, float r, vec3<float> n) {
        return shading::irradiance_sphere_frostbite(c, r, n);
    }));
    methods.push_back(scalar_method<float>("point", "float", [](vec3<float> c, float r, vec3<float> n) {
        return shading::irradiance_sphere_point(c, r, n);
    }));
    return methods;
}

std::vector<double> sphere_truth(const SphereCases& cases, unsigned threads) {
    std::vector<double> truth(cases.size());
    parallel_for(cases.size(), threads, [&](std::size_t i) {
        const double center[3] = {-static_cast<double>(cases.position[0][i]),
                                  -static_cast<double>(cases.position[1][i]),
                                  -static_cast<double>(cases.position[2][i])};
        const double normal[3] = {cases.normal[0][i], cases.normal[1][i], cases.normal[2][i]};
        truth[i] = sphere_irradiance_by_quadrature(center, 1.0, normal);
    });
    return truth;
}

void fill_errors(SphereMeasurement& measured, std::span<const float> values, std::span<const double> truth,
                 std::span<const Stratum> strata, double relative_floor) {
    const std::vector<double> wide(values.begin(), values.end());
    measured.error = compare(wide, truth, relative_floor);
    for (std::size_t s = 0; s < stratum_count; ++s) {
        std::vector<double> some_values;
        std::vector<double> some_truth;
        for (std::size_t i = 0; i < wide.size(); ++i) {
            if (strata[i] != static_cast<Stratum>(s)) continue;
            some_values.push_back(wide[i]);
            some_truth.push_back(truth[i]);
        }
        measured.error_by_stratum[s] = compare(some_values, some_truth, relative_floor);
    }
}

Result<std::vector<SphereMeasurement>> compare_sphere_methods(const SphereComparison& options) {
    const SphereCases cases = sphere_cases(options.cases, options.seed);
    const std::vector<double> truth = sphere_truth(cases);
    std::vector<SphereMeasurement> measurements;
    std::vector<float> values(cases.size());
    for (const SphereMethod& method : sphere_methods()) {
        SphereMeasurement measured{method.name, method.precision, {}, {}, {}};
        Result<Timing> timing = time_work([&] { method.evaluate(cases, values); }, cases.size(), options.timing);
        if (!timing) return pass_on(timing);
        measured.timing = *timing;
        fill_errors(measured, values, truth, cases.stratum, options.relative_floor);
        measurements.push_back(std::move(measured));
    }
    return measurements;
}

} // namespace gonio::measure
