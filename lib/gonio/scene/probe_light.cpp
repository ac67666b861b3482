#include <gonio/light/light_color.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/detail/surface_parts.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/shading/irradiance_approximate.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/web/web.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

// A sum or product of finite terms ≥ 0, made finite if it overflowed; NaN becomes 0.
double bounded(double lx) {
    return simd::min(simd::max(lx, 0.0), shading::illuminance_ceiling);
}

double inverse_range(const Light& light) {
    return light.range ? 1.0 / light.range->value : 0.0;
}

double window(const Light& light, const Vec& to_center) {
    return light.range ? shading::window_squared(shading::length(to_center), inverse_range(light)) : 1.0;
}

double luminance_y(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

// E/L of each area light by each method; `c` is the vector from the receiver to the centre.
struct AreaIrradiance {
    Vec c;
    Vec n;
    IrradianceMethod method;

    double operator()(const shading::SphereLight<double>& light) const {
        if (method == IrradianceMethod::frostbite) return by<Approximation::frostbite>(light);
        if (method == IrradianceMethod::ue4) return by<Approximation::point>(light);
        return shading::detail::irradiance(light, c, n);
    }
    double operator()(const shading::TubeLight<double>& light) const {
        if (method == IrradianceMethod::frostbite) return by<Approximation::frostbite>(light);
        if (method == IrradianceMethod::ue4) return by<Approximation::ue4>(light);
        return shading::detail::irradiance(light, c, n);
    }
    double operator()(const shading::CylinderLight<double>& light) const {
        return shading::detail::irradiance(light, c, n);
    }
    double operator()(const shading::SunLight<double>& light) const { return shading::detail::irradiance(light, c, n); }
    template<class Flat>
    double operator()(Flat light) const {
        const bool both = light.two_sided;
        light.two_sided = false;
        const double front = one_side(light);
        if (!both) return front;
        light.axis = light.axis * -1.0;
        return front + one_side(light);
    }

private:
    using Approximation = shading::Approximation;

    template<Approximation approximation, class CoreLight>
    double by(const CoreLight& light) const {
        return shading::detail::approximate<double, approximation>(light, c, n);
    }
    template<class Flat>
    double one_side(const Flat& light) const {
        if (method == IrradianceMethod::frostbite) return by<Approximation::frostbite>(light);
        return shading::detail::irradiance(light, c, n);
    }
};

// Whether a point is inside a light, where it sees only that light.
bool is_within(const shading::SphereLight<double>& light, const glm::dvec3& to_center) {
    return glm::length(to_center) < light.radius;
}
bool is_within(const shading::TubeLight<double>& light, const glm::dvec3& to_center) {
    const glm::dvec3 axis(light.axis.x, light.axis.y, light.axis.z);
    const double along = glm::dot(to_center, axis);
    const double half = 0.5 * light.length;
    return glm::length(to_center - std::clamp(along, -half, half) * axis) < light.radius;
}
// In it and before its open ends a point sees none of its luminous side.
bool is_within(const shading::CylinderLight<double>& /*dark inside*/, const glm::dvec3& /*to_center*/) {
    return false;
}
bool is_within(const shading::SunLight<double>& /*at infinity*/, const glm::dvec3& /*to_center*/) {
    return false;
}
template<class Flat>
requires requires(Flat light) {
    light.two_sided;
}
bool is_within(const Flat& /*light*/, const glm::dvec3& /*to_center*/) {
    return false;
}

// Whether the light counts as a point: because it is one, because the method is `point`, or because the method has no
// form for its shape.
bool as_point(const Shape& shape, IrradianceMethod method) {
    if (!has_extent(shape) || method == IrradianceMethod::point) return true;
    if (std::holds_alternative<CylinderShape>(shape)) return takes_points(method);
    return method == IrradianceMethod::ue4 && is_flat(shape);
}

// 1/d² with the method's guard of 1 cm.
double inverse_square(double inverse_distance, IrradianceMethod method) {
    constexpr double most = 1.0 / (0.01 * 0.01);
    const double unguarded = inverse_distance * inverse_distance;
    if (method == IrradianceMethod::frostbite) return std::min(unguarded, most);
    if (method != IrradianceMethod::ue4) return unguarded;
    return std::isfinite(unguarded) ? unguarded / (1.0 + unguarded / most) : most;
}

ProbeShare of_point(const Light& light, const Vec& to_light, const Vec& normal, IrradianceMethod method) {
    const shading::Direction<double> d = shading::direction(to_light, normal);
    if (d.inverse_distance == 0.0) return {0.0, 0.0, ProbeRemark::at_light};
    if (!(d.n_dot_l > 0.0)) return {};
    const double cd = light.intensity_towards(-glm::dvec3(to_light.x, to_light.y, to_light.z)).value;
    return {bounded(cd * d.n_dot_l * inverse_square(d.scale * d.inverse_distance, method) * window(light, to_light))};
}

// A uniform cap of half angle δ/2 around the direction of the sun, clipped by the receiver's horizon.
double of_sun(const SunShape& sun, const Frame& frame, const glm::dvec3& normal) {
    const double s = std::sin(0.5 * sun.diameter.value);
    const double c = glm::dot(normal, frame.z);
    if (c >= s) return std::numbers::pi * s * s * c;
    if (c <= -s) return 0.0;
    return std::max(shading::irradiance_straddling_cap(s, std::max(std::cos(0.5 * sun.diameter.value), 0.0), c), 0.0);
}

// The method that gives the illuminance.
IrradianceMethod illuminance_method(IrradianceMethod method) {
    return is_specular_method(method) ? IrradianceMethod::exact : method;
}

ReferenceGoal goal_of(const ProbeWay& way) {
    return way.method == IrradianceMethod::reference ? way.goal : ReferenceGoal{};
}

// The BRDF towards the single direction.
ProbeLuminance of_punctual(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                           const ProbeSurface& surface, const ProbeShare& share) {
    if (!(share.illuminance_lx > 0.0)) return {};
    const shading::Direction<double> d = shading::direction(vec(light.frame.origin - position), vec(normal));
    const Vec l = d.scaled * d.inverse_distance;
    const SurfaceParts parts = surface_parts(surface.material);
    const auto nt = [&](const SurfaceParts::Reflectance& reflectance) {
        const Vec f = reflectance(vec(normal), l, vec(surface.view));
        return Nits(bounded(share.illuminance_lx * luminance_y(light.color * glm::dvec3(f.x, f.y, f.z))));
    };
    return {nt(parts.diffuse), nt(parts.specular), Nits()};
}

} // namespace

bool takes_points(IrradianceMethod method) {
    return method == IrradianceMethod::frostbite || method == IrradianceMethod::ue4 ||
           method == IrradianceMethod::point;
}

bool consists_of_parts(const Light& light, IrradianceMethod method) {
    return light.parts != nullptr && (light.body == nullptr || !takes_points(method));
}

bool is_integrated(const Light& light, IrradianceMethod method) {
    if (consists_of_parts(light, method))
        return std::any_of(light.parts->begin(), light.parts->end(),
                           [&](const Light& part) { return is_integrated(part, method); });
    return has_extent(light.shape) &&
           (method == IrradianceMethod::reference || (method == IrradianceMethod::exact && light.has_pattern()));
}

ProbeShare illuminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                          const ProbeWay& way) {
    const IrradianceMethod method = illuminance_method(way.method);
    if (consists_of_parts(light, method)) {
        ProbeShare sum;
        for (const Light& part : *light.parts) {
            const ProbeShare share = illuminance_of(part, position, normal, way);
            sum.illuminance_lx = bounded(sum.illuminance_lx + share.illuminance_lx);
            sum.error_lx += share.error_lx;
            sum.converged = sum.converged && share.converged;
            if (share.remark != ProbeRemark::none) sum.remark = share.remark;
        }
        return sum;
    }
    const glm::dvec3 to_center = light.frame.origin - position;
    const bool inside = with_core_light(light.shape, light.frame, light.color, false,
                                        [&](const auto& core) { return is_within(core, to_center); });
    const ProbeRemark remark = inside ? ProbeRemark::inside : ProbeRemark::none;
    if (is_integrated(light, way.method)) {
        const ReferenceValue e = reference_illuminance(light, position, normal, goal_of(way));
        return {bounded(e.value), e.error_estimate, remark, e.converged};
    }
    if (const auto* sun = std::get_if<SunShape>(&light.shape)) {
        const double lx = method == IrradianceMethod::exact ? light.luminance.value * of_sun(*sun, light.frame, normal)
                                                            : light.illuminance.value * glm::dot(normal, light.frame.z);
        return {bounded(lx)};
    }
    if (as_point(light.shape, method)) return of_point(light, vec(to_center), vec(normal), method);
    const double e_over_l = inside && method == IrradianceMethod::exact
                                ? std::numbers::pi
                                : with_core_light(light.shape, light.frame, light.color, 0.0,
                                                  AreaIrradiance{vec(to_center), vec(normal), method});
    return {
        bounded(light.luminance.value * e_over_l * window(light, vec(to_center)) * share_from_center(light, position)),
        0.0, remark};
}

double share_from_center(const Light& light, const glm::dvec3& position) {
    const glm::dvec3 way = position - light.frame.origin;
    if (!has_extent(light.shape) || way == glm::dvec3(0.0)) return 1.0;
    return light.luminance_share(way);
}

bool has_luminance(const Material& material, IrradianceMethod method) {
    if (std::holds_alternative<LambertMaterial>(material)) return true;
    if (is_specular_method(method)) return has_named_lobe(material);
    return method == IrradianceMethod::exact || method == IrradianceMethod::reference;
}

ProbeShine luminance_of(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                        const ProbeSurface& surface, const ProbeShare& share, const ProbeWay& way) {
    if (!(glm::dot(normal, surface.view) > 0.0)) return {};
    if (consists_of_parts(light, way.method)) {
        // Parts of one colour share their illuminance among them: a Lambertian surface needs no more than the sum.
        const bool is_lambert = std::holds_alternative<LambertMaterial>(surface.material);
        if (!is_lambert || light.body == nullptr) {
            ProbeShine sum;
            for (const Light& part : *light.parts) {
                const ProbeShare of_part =
                    is_lambert || !has_extent(part.shape) ? illuminance_of(part, position, normal, way) : ProbeShare();
                const ProbeShine shine = luminance_of(part, position, normal, surface, of_part, way);
                sum.luminance.diffuse = sum.luminance.diffuse + shine.luminance.diffuse;
                sum.luminance.specular = sum.luminance.specular + shine.luminance.specular;
                sum.luminance.error_estimate = sum.luminance.error_estimate + shine.luminance.error_estimate;
                sum.converged = sum.converged && shine.converged;
            }
            return sum;
        }
    }
    if (const auto* lambert = std::get_if<LambertMaterial>(&surface.material)) {
        const double y = luminance_y(lambert->albedo * light.color) * std::numbers::inv_pi;
        return {{Nits(bounded(share.illuminance_lx * y)), Nits(), Nits(bounded(share.error_lx * y))}, share.converged};
    }
    if (!has_extent(light.shape)) return {of_punctual(light, position, normal, surface, share)};
    if (is_specular_method(way.method)) {
        const NamedLuminance nt = named_luminance(light, position, normal, surface, way.method);
        return {{Nits(bounded(nt.diffuse_nt)), Nits(bounded(nt.specular_nt)), Nits()}};
    }
    const ReferenceLuminance nt =
        reference_luminance(light, position, normal, surface.view, surface.material, goal_of(way));
    return {{Nits(bounded(nt.diffuse.value)), Nits(bounded(nt.specular.value)),
             Nits(bounded(nt.diffuse.error_estimate + nt.specular.error_estimate))},
            nt.diffuse.converged && nt.specular.converged};
}

} // namespace gonio::detail
