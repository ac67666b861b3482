#include <gonio/base/parallel.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/specular_by_share.hpp>
#include <gonio/shading/specular_in_double.hpp>
#include <gonio/simd/dispatch.hpp>

#include <algorithm>
#include <string>
#include <utility>

namespace gonio::measure {

namespace {

using Kind = shading::LightConstants::Kind;
using shading::SpecularMethod;
using shading::vec3;

constexpr std::pair<const char*, SpecularMethod> names[] = {
    {"ltc", SpecularMethod::ltc},
    {"representative-point", SpecularMethod::representative_point},
    {"dominant-direction", SpecularMethod::dominant_direction},
    {"specular-d", SpecularMethod::specular_d},
    {"spherical-hack", SpecularMethod::spherical_hack},
    {"sun-disk", SpecularMethod::sun_disk}};

vec3<double> vec(const float (&v)[3]) {
    return {v[0], v[1], v[2]};
}

vec3<double> at(const std::array<std::vector<float>, 3>& v, std::size_t i) {
    return {v[0][i], v[1][i], v[2][i]};
}

// Calls work(light) with the light as its specific type, placed about the origin.
template<class Work>
double with_light(const shading::LightConstants& light, const Work& work) {
    const vec3<double> zero{0.0, 0.0, 0.0};
    const double radius = light.radius;
    const double width = light.width;
    const double height = light.height;
    switch (light.kind) {
    case Kind::sphere:
        return work(shading::SphereLight<double>{zero, zero, radius, 0.0});
    case Kind::disk:
        return work(shading::DiskLight<double>{zero, zero, vec(light.axis), radius, 0.0, light.two_sided});
    case Kind::ellipse:
        return work(shading::EllipseLight<double>{zero, zero, vec(light.axis), vec(light.width_direction), 0.5 * width,
                                                  0.5 * height, 0.0, light.two_sided});
    case Kind::rectangle:
        return work(shading::RectangleLight<double>{zero, zero, vec(light.axis), vec(light.width_direction), width,
                                                    height, 0.0, light.two_sided});
    case Kind::tube:
        return work(shading::TubeLight<double>{zero, zero, vec(light.axis), radius, light.length, 0.0});
    case Kind::cylinder:
        return work(shading::CylinderLight<double>{zero, zero, vec(light.axis), radius, light.length, 0.0});
    default:
        return 0.0;
    }
}

void ltc_in_double(const SpecularCases& cases, std::span<double> luminance) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::size_t group = i / SpecularCases::group_size;
        luminance[i] =
            specular_in_double(cases.area.lights[group], SpecularMethod::ltc, at(cases.area.position, i) * -1.0,
                               at(cases.area.normal, i), at(cases.view, i), cases.alpha[group]);
    }
}

// Once for all lights that are seen as the same.
template<class S, class Seen>
[[gnu::noinline]] S by_share_of(const Seen& light, vec3<S> to_center, vec3<S> normal, vec3<S> view, S alpha) {
    return specular_by_share(light, to_center, normal, view, shading::GgxLobe<S>{alpha}).scale;
}

// The former default, which no kernel has: one number at a time.
template<class S>
void by_share(const SpecularCases& cases, std::span<S> luminance) {
    for (std::size_t g = 0; g < cases.area.lights.size(); ++g)
        shading::detail::with_light<S>(cases.area.lights[g], [&](const auto& light) {
            const std::size_t end = std::min((g + 1) * SpecularCases::group_size, cases.size());
            for (std::size_t i = g * SpecularCases::group_size; i < end; ++i) {
                const auto of = [i](const std::array<std::vector<float>, 3>& v) {
                    return vec3<S>{static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
                };
                const auto seen = shading::seen_from(light, of(cases.area.position) * S(-1));
                luminance[i] = by_share_of(seen.light, seen.to_center, of(cases.area.normal), of(cases.view),
                                           static_cast<S>(cases.alpha[g]));
            }
        });
}

// One float at a time is a set of its own.
SpecularMethodUnderTest kernel_method(const char* name, SpecularMethod method, simd::InstructionSet set) {
    const shading::SpecularKernels& kernels = shading::specular_kernels(set);
    const auto work = [&kernels, method](const SpecularCases& cases, std::span<float> luminance) {
        std::array<float, SpecularCases::group_size> grazing{};
        for (std::size_t g = 0; g < cases.area.lights.size(); ++g)
            kernels.specular(cases.surfaces(g), cases.area.lights[g], cases.alpha[g], method,
                             luminance.data() + g * SpecularCases::group_size, grazing.data());
    };
    return {name, set == simd::InstructionSet::scalar ? "float" : kernels.name, work, {}};
}

} // namespace

std::vector<SpecularMethodUnderTest> specular_methods(Kind kind) {
    std::vector<SpecularMethodUnderTest> methods;
    if (kind == Kind::punctual) return methods;
    methods.push_back({"ltc", "double", {}, ltc_in_double});
    for (const auto& [name, method] : names)
        for (const simd::InstructionSet set : simd::available_sets())
            methods.push_back(kernel_method(name, method, set));
    methods.push_back({"ltc-share", "double", {}, by_share<double>});
    methods.push_back({"ltc-share", "float", by_share<float>, {}});
    return methods;
}

double specular_in_double(const shading::LightConstants& light, SpecularMethod method, vec3<double> center,
                          vec3<double> normal, vec3<double> view, double alpha) {
    return with_light(light, [&](const auto& shape) {
        return shading::specular_in_double(method, shape, center, normal, view, alpha).scale;
    });
}

std::vector<double> specular_truth(const SpecularCases& cases, unsigned threads) {
    std::vector<double> truth(cases.size());
    parallel_for(cases.size(), threads, [&](std::size_t i) {
        const std::size_t group = i / SpecularCases::group_size;
        truth[i] = specular_by_quadrature(cases.area.lights[group], at(cases.area.position, i) * -1.0,
                                          at(cases.area.normal, i), at(cases.view, i),
                                          static_cast<double>(cases.alpha[group]));
    });
    return truth;
}

} // namespace gonio::measure
