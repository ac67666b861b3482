#include <gonio/base/parallel.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/specular_named.hpp>
#include <gonio/simd/dispatch.hpp>

#include <string>
#include <type_traits>
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

template<class S>
vec3<S> vec(const float (&v)[3]) {
    return {static_cast<S>(v[0]), static_cast<S>(v[1]), static_cast<S>(v[2])};
}

template<class S>
vec3<S> at(const std::array<std::vector<float>, 3>& v, std::size_t i) {
    return {static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
}

// Calls work(light) with the light as its specific type, placed about the origin.
template<class S, class Work>
S with_light(const shading::LightConstants& light, const Work& work) {
    const vec3<S> zero{S(0), S(0), S(0)};
    const auto radius = static_cast<S>(light.radius);
    switch (light.kind) {
    case Kind::sphere:
        return work(shading::SphereLight<S>{zero, zero, radius, S(0)});
    case Kind::disk:
        return work(shading::DiskLight<S>{zero, zero, vec<S>(light.axis), radius, S(0), light.two_sided});
    case Kind::ellipse:
        return work(shading::EllipseLight<S>{zero, zero, vec<S>(light.axis), vec<S>(light.width_direction),
                                             S(0.5) * static_cast<S>(light.width),
                                             S(0.5) * static_cast<S>(light.height), S(0), light.two_sided});
    case Kind::rectangle:
        return work(shading::RectangleLight<S>{zero, zero, vec<S>(light.axis), vec<S>(light.width_direction),
                                               static_cast<S>(light.width), static_cast<S>(light.height), S(0),
                                               light.two_sided});
    case Kind::tube:
        return work(shading::TubeLight<S>{zero, zero, vec<S>(light.axis), radius, static_cast<S>(light.length), S(0)});
    default:
        return S(0);
    }
}

// Each case in turn.
template<class S, SpecularMethod method>
void one_by_one(const SpecularCases& cases, std::span<S> luminance) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::size_t group = i / SpecularCases::group_size;
        luminance[i] = with_light<S>(cases.area.lights[group], [&](const auto& light) {
            return shading::specular_by<method>(light, at<S>(cases.area.position, i) * S(-1),
                                                at<S>(cases.area.normal, i), at<S>(cases.view, i),
                                                static_cast<S>(cases.alpha[group]))
                .scale;
        });
    }
}

template<SpecularMethod method>
void in_floats(const SpecularCases& cases, std::span<float> luminance) {
    one_by_one<float, method>(cases, luminance);
}

constexpr void (*float_methods[])(const SpecularCases&,
                                  std::span<float>) = {in_floats<SpecularMethod::ltc>,
                                                       in_floats<SpecularMethod::representative_point>,
                                                       in_floats<SpecularMethod::dominant_direction>,
                                                       in_floats<SpecularMethod::specular_d>,
                                                       in_floats<SpecularMethod::spherical_hack>,
                                                       in_floats<SpecularMethod::sun_disk>};

SpecularMethodUnderTest kernel_method(const char* name, SpecularMethod method,
                                      const shading::SpecularKernels& kernels) {
    const auto work = [&kernels, method](const SpecularCases& cases, std::span<float> luminance) {
        std::array<float, SpecularCases::group_size> grazing{};
        for (std::size_t g = 0; g < cases.area.lights.size(); ++g)
            kernels.specular(cases.surfaces(g), cases.area.lights[g], cases.alpha[g], method,
                             luminance.data() + g * SpecularCases::group_size, grazing.data());
    };
    return {name, kernels.name, work, {}};
}

} // namespace

std::vector<SpecularMethodUnderTest> specular_methods(Kind kind) {
    std::vector<SpecularMethodUnderTest> methods;
    if (kind == Kind::punctual) return methods;
    methods.push_back({"ltc", "double", {}, one_by_one<double, SpecularMethod::ltc>});
    for (const auto& [name, method] : names) {
        methods.push_back({name, "float", float_methods[static_cast<std::size_t>(method)], {}});
        for (const simd::InstructionSet set : simd::available_sets())
            if (set != simd::InstructionSet::scalar)
                methods.push_back(kernel_method(name, method, shading::specular_kernels(set)));
    }
    return methods;
}

double specular_in_double(const shading::LightConstants& light, SpecularMethod method, vec3<double> center,
                          vec3<double> normal, vec3<double> view, double alpha) {
    return with_light<double>(light, [&](const auto& shape) {
        const auto by = [&]<SpecularMethod named>() {
            return shading::specular_by<named>(shape, center, normal, view, alpha).scale;
        };
        switch (method) {
        case SpecularMethod::ltc:
            return by.template operator()<SpecularMethod::ltc>();
        case SpecularMethod::representative_point:
            return by.template operator()<SpecularMethod::representative_point>();
        case SpecularMethod::dominant_direction:
            return by.template operator()<SpecularMethod::dominant_direction>();
        case SpecularMethod::specular_d:
            return by.template operator()<SpecularMethod::specular_d>();
        case SpecularMethod::spherical_hack:
            return by.template operator()<SpecularMethod::spherical_hack>();
        case SpecularMethod::sun_disk:
            return by.template operator()<SpecularMethod::sun_disk>();
        }
        return 0.0;
    });
}

std::vector<double> specular_truth(const SpecularCases& cases, unsigned threads) {
    std::vector<double> truth(cases.size());
    parallel_for(cases.size(), threads, [&](std::size_t i) {
        const std::size_t group = i / SpecularCases::group_size;
        truth[i] = specular_by_quadrature(cases.area.lights[group], at<double>(cases.area.position, i) * -1.0,
                                          at<double>(cases.area.normal, i), at<double>(cases.view, i),
                                          static_cast<double>(cases.alpha[group]));
    });
    return truth;
}

} // namespace gonio::measure
