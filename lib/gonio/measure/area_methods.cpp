#include <gonio/measure/area_methods.hpp>
#include <gonio/shading/irradiance_cylinder.hpp>
#include <gonio/shading/irradiance_disk.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>
#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/irradiance_rectangle.hpp>
#include <gonio/shading/irradiance_tube.hpp>
#include <gonio/simd/dispatch.hpp>

#include <string>
#include <type_traits>
#include <utility>

namespace gonio::measure {

namespace {

using Kind = shading::LightConstants::Kind;
using shading::vec3;

template<class S>
struct Arguments {
    vec3<S> center, axis, width_direction, normal;
    S radius, width, height, length;
};

template<class S>
vec3<S> vec(const float (&v)[3]) {
    return {static_cast<S>(v[0]), static_cast<S>(v[1]), static_cast<S>(v[2])};
}

// Calls function(arguments) for each case in turn.
template<class S, class Function>
void one_by_one(const AreaCases& cases, std::span<S> e_over_l, const Function& function) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const shading::LightConstants& light = cases.lights[i / AreaCases::group_size];
        const auto at = [i](const std::array<std::vector<float>, 3>& v) {
            return vec3<S>{static_cast<S>(v[0][i]), static_cast<S>(v[1][i]), static_cast<S>(v[2][i])};
        };
        const Arguments<S> a{vec3<S>{S(0), S(0), S(0)} - at(cases.position),
                             vec<S>(light.axis),
                             vec<S>(light.width_direction),
                             at(cases.normal),
                             static_cast<S>(light.radius),
                             static_cast<S>(light.width),
                             static_cast<S>(light.height),
                             static_cast<S>(light.length)};
        e_over_l[i] = function(a);
    }
}

template<class S, class Function>
AreaMethod scalar_method(std::string name, Function function) {
    const auto work = [function](const AreaCases& cases, std::span<S> e_over_l) {
        one_by_one<S>(cases, e_over_l, function);
    };
    if constexpr (std::is_same_v<S, double>) {
        return {std::move(name), "double", {}, work};
    } else {
        return {std::move(name), "float", work, {}};
    }
}

// A method that passes each light with its receivers to call(kernels, surfaces, light, output).
template<class Call>
void add_kernels(std::vector<AreaMethod>& methods, const std::string& name, Call call) {
    for (const simd::InstructionSet set : simd::available_sets()) {
        if (set == simd::InstructionSet::scalar) continue;
        const shading::Kernels& kernels = shading::kernels(set);
        methods.push_back({name,
                           kernels.name,
                           [&kernels, call](const AreaCases& cases, std::span<float> e_over_l) {
                               for (std::size_t g = 0; g < cases.lights.size(); ++g)
                                   call(kernels, cases.surfaces(g), cases.lights[g],
                                        e_over_l.data() + g * AreaCases::group_size);
                           },
                           {}});
    }
}

void add_approximation(std::vector<AreaMethod>& methods, const std::string& name, shading::Approximation method) {
    add_kernels(methods, name,
                [method](const shading::Kernels& kernels, const shading::Surfaces& surfaces,
                         const shading::LightConstants& light,
                         float* lx) { kernels.approximate_irradiance(surfaces, light, method, lx); });
}

// The functions of one shape, named after the methods.
struct Disk {
    template<class S>
    static S exact(const Arguments<S>& a) {
        return shading::irradiance_disk(a.center, a.axis, a.radius, a.normal);
    }
    static float frostbite(const Arguments<float>& a) {
        return shading::irradiance_disk_frostbite(a.center, a.axis, a.radius, a.normal);
    }
    static float point(const Arguments<float>& a) {
        return shading::irradiance_disk_point(a.center, a.axis, a.radius, a.normal);
    }
};

struct Ellipse {
    template<class S>
    static shading::EllipseLight<S> light(const Arguments<S>& a) {
        const vec3<S> white{S(1), S(1), S(1)};
        return {a.center, white, a.axis, a.width_direction, S(0.5) * a.width, S(0.5) * a.height, S(0), false};
    }
    template<class S>
    static S exact(const Arguments<S>& a) {
        return shading::irradiance_ellipse(light(a), a.center, a.normal);
    }
    // The sources have no formula for an ellipse; this uses the disk of the same area.
    static float frostbite(const Arguments<float>& a) {
        return shading::irradiance_disk_frostbite(a.center, a.axis, light(a).approximated().radius, a.normal);
    }
    static float point(const Arguments<float>& a) {
        return shading::irradiance_disk_point(a.center, a.axis, light(a).approximated().radius, a.normal);
    }
};

struct Rectangle {
    template<class S>
    static S exact(const Arguments<S>& a) {
        return shading::irradiance_rectangle(a.center, a.axis, a.width_direction, a.width, a.height, a.normal);
    }
    static float frostbite(const Arguments<float>& a) {
        return shading::irradiance_rectangle_frostbite(a.center, a.axis, a.width_direction, a.width, a.height,
                                                       a.normal);
    }
    static float point(const Arguments<float>& a) {
        return shading::irradiance_rectangle_point(a.center, a.axis, a.width_direction, a.width, a.height, a.normal);
    }
};

struct Tube {
    template<class S>
    static S exact(const Arguments<S>& a) {
        return shading::irradiance_tube(a.center, a.axis, a.radius, a.length, a.normal);
    }
    static float frostbite(const Arguments<float>& a) {
        return shading::irradiance_tube_frostbite(a.center, a.axis, a.radius, a.length, a.normal);
    }
    static float point(const Arguments<float>& a) {
        return shading::irradiance_tube_point(a.center, a.axis, a.radius, a.length, a.normal);
    }
    static float ue4(const Arguments<float>& a) {
        return shading::irradiance_tube_ue4(a.center, a.axis, a.radius, a.length, a.normal);
    }
};

// The sources have no formula for the side alone: a point.
struct Cylinder {
    template<class S>
    static S exact(const Arguments<S>& a) {
        return shading::irradiance_cylinder(a.center, a.axis, a.radius, a.length, a.normal);
    }
    static float frostbite(const Arguments<float>& a) { return point(a); }
    static float point(const Arguments<float>& a) {
        return shading::irradiance_cylinder_point(a.center, a.axis, a.radius, a.length, a.normal);
    }
};

template<class Shape>
std::vector<AreaMethod> methods_of() {
    std::vector<AreaMethod> methods;
    const auto exact = [](const auto& a) { return Shape::exact(a); };
    methods.push_back(scalar_method<double>("exact", exact));
    methods.push_back(scalar_method<float>("exact", exact));
    add_kernels(methods, "exact",
                [](const shading::Kernels& kernels, const shading::Surfaces& surfaces,
                   const shading::LightConstants& light, float* lx) { kernels.irradiance(surfaces, light, lx); });
    methods.push_back(scalar_method<float>("frostbite", [](const auto& a) { return Shape::frostbite(a); }));
    add_approximation(methods, "frostbite", shading::Approximation::frostbite);
    methods.push_back(scalar_method<float>("point", [](const auto& a) { return Shape::point(a); }));
    return methods;
}

template<class Shape>
void truth_of(const AreaCases& cases, std::span<double> truth) {
    one_by_one<double>(cases, truth, [](const auto& a) { return Shape::exact(a); });
}

} // namespace

std::vector<AreaMethod> area_methods(Kind kind) {
    switch (kind) {
    case Kind::disk:
        return methods_of<Disk>();
    case Kind::ellipse:
        return methods_of<Ellipse>();
    case Kind::rectangle:
        return methods_of<Rectangle>();
    case Kind::tube: {
        auto methods = methods_of<Tube>();
        methods.push_back(scalar_method<float>("ue4", [](const auto& a) { return Tube::ue4(a); }));
        add_approximation(methods, "ue4", shading::Approximation::ue4);
        return methods;
    }
    case Kind::cylinder:
        return methods_of<Cylinder>();
    default:
        return {};
    }
}

std::vector<double> area_truth(const AreaCases& cases) {
    std::vector<double> truth(cases.size());
    if (cases.lights.empty()) return truth;
    switch (cases.lights.front().kind) {
    case Kind::disk:
        truth_of<Disk>(cases, truth);
        break;
    case Kind::ellipse:
        truth_of<Ellipse>(cases, truth);
        break;
    case Kind::rectangle:
        truth_of<Rectangle>(cases, truth);
        break;
    case Kind::tube:
        truth_of<Tube>(cases, truth);
        break;
    case Kind::cylinder:
        truth_of<Cylinder>(cases, truth);
        break;
    default:
        break;
    }
    return truth;
}

} // namespace gonio::measure
