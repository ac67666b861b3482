#include <gonio/base/parallel.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/measure/sphere_truth.hpp>
#include <gonio/shading/irradiance_sphere.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/simd/dispatch.hpp>

#include <cmath>
#include <type_traits>
#include <utility>

namespace gonio::measure {

namespace {

using shading::vec3;

// A method that calls function(vector to the centre, radius, normal) for each case in turn, all in S.
template<class S, class Function>
SphereMethod scalar_method(std::string name, Function function) {
    const auto one_by_one = [function](const SphereCases& cases, std::span<S> e_over_l) {
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const auto at = [i](const std::array<std::vector<float>, 3>& v) {
                return vec3<S>{static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
            };
            e_over_l[i] = function(vec3<S>{S(0), S(0), S(0)} - at(cases.position), S(1), at(cases.normal));
        }
    };
    if constexpr (std::is_same_v<S, double>) {
        return {std::move(name), "double", {}, one_by_one};
    } else {
        return {std::move(name), "float", one_by_one, {}};
    }
}

SphereMethod kernel_method(const shading::Kernels& kernels) {
    return {"exact",
            kernels.name,
            [&kernels](const SphereCases& cases, std::span<float> e_over_l) {
                kernels.irradiance(cases.surfaces(), SphereCases::light(), e_over_l.data());
            },
            {}};
}

SphereMethod frostbite_kernel(const shading::Kernels& kernels) {
    return {"frostbite",
            kernels.name,
            [&kernels](const SphereCases& cases, std::span<float> e_over_l) {
                kernels.approximate_irradiance(cases.surfaces(), SphereCases::light(),
                                               shading::Approximation::frostbite, e_over_l.data());
            },
            {}};
}

} // namespace

std::vector<SphereMethod> sphere_methods() {
    std::vector<SphereMethod> methods;
    methods.push_back(scalar_method<double>(
        "exact", [](vec3<double> c, double r, vec3<double> n) { return shading::irradiance_sphere(c, r, n); }));
    methods.push_back(scalar_method<float>(
        "exact", [](vec3<float> c, float r, vec3<float> n) { return shading::irradiance_sphere(c, r, n); }));
    for (const simd::InstructionSet set : simd::available_sets())
        if (set != simd::InstructionSet::scalar) methods.push_back(kernel_method(shading::kernels(set)));
    methods.push_back(scalar_method<float>("frostbite", [](vec3<float> c, float r, vec3<float> n) {
        return shading::irradiance_sphere_frostbite(c, r, n);
    }));
    for (const simd::InstructionSet set : simd::available_sets())
        if (set != simd::InstructionSet::scalar) methods.push_back(frostbite_kernel(shading::kernels(set)));
    methods.push_back(scalar_method<float>(
        "point", [](vec3<float> c, float r, vec3<float> n) { return shading::irradiance_sphere_point(c, r, n); }));
    return methods;
}

std::vector<double> sphere_truth(const SphereCases& cases, unsigned threads) {
    std::vector<double> truth(cases.size());
    parallel_for(cases.size(), threads, [&](std::size_t i) {
        const double center[3] = {-static_cast<double>(cases.position[0][i]),
                                  -static_cast<double>(cases.position[1][i]),
                                  -static_cast<double>(cases.position[2][i])};
        const double normal[3] = {cases.normal[0][i], cases.normal[1][i], cases.normal[2][i]};
        // The methods assume a unit normal, but its floats are not exactly that: E/L grows with its length.
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        truth[i] = length * sphere_irradiance_by_quadrature(center, 1.0, normal);
    });
    return truth;
}

} // namespace gonio::measure
