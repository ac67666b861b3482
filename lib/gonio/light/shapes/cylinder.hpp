// The traits of a cylinder's side: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/irradiance_cylinder.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace closed_form {

// I/L from the side: 2 r l.
template<class S>
S cylinder_area(S r, S l) {
    return S(2) * r * l;
}

// E/L of a receiver that faces the middle of the side at the distance d ≥ r from the axis. With z = l/2, k² = d² − r²,
// N² = (d − r)² + z², F² = (d + r)² + z², t² = (d − r)/(d + r) and Q = d² + r² + z²:
// (2r/d) atan(z/k) + (2z/d) [(Q/NF) atan(tF/N) − atan t], the last two terms without their difference.
template<class S>
S facing_cylinder(S r, S l, S d) {
    const S s = r / d; // over d, as are all values below
    const S z = S(0.5) * l / d;
    const S gap = std::max(d - r, S(0)) / d; // exact near contact
    const S k = std::sqrt(gap) * std::sqrt(S(1) + s);
    const S near = std::hypot(gap, z);
    const S far = std::hypot(S(1) + s, z);
    const S t = std::sqrt(gap / (S(1) + s));
    const S e = S(2) * s;
    const S product = near * far;
    const S q = S(1) + s * s + z * z;
    // atan w − atan t, with w = t far/near; (far² − near²) = 2e.
    const S turned = std::atan2(t * (S(2) * e) / (near + far), near + t * t * far);
    const S excess = (e / product) * (e / (product + q)) * std::atan2(t * far, near);
    return S(2) * (s * std::atan2(z, k) + z * (turned + excess));
}

} // namespace closed_form

template<>
struct ShapeTraits<CylinderShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "cylinder";
    static constexpr std::string_view summary = "the side of a Lambertian cylinder along X, without caps";
    static constexpr std::tuple keys{LengthKey<CylinderShape>{"r", "radius", &CylinderShape::radius},
                                     LengthKey<CylinderShape>{"l", "length", &CylinderShape::length}};
    static constexpr MaskedBy masked_by = MaskedBy::shown_area;
    static constexpr const char* masked_flux = "Φ = (∬ mask sinψ dω) I₀";
    static constexpr bool inverse_square_is_exact = false;

    static double largest(const CylinderShape& s) { return std::fmax(s.radius.value, s.length.value); }
    static double radius(const CylinderShape& s) { return std::hypot(0.5 * s.length.value, s.radius.value); }
    static double nearest(const CylinderShape& s) { return s.radius.value; }
    static Radians half_cone(const CylinderShape&) { return shape_detail::all_round; }
    static double shown(const CylinderShape&, const glm::dvec3& d) { return shape_detail::sine_from_axis(d); }
    static Factor flux(const CylinderShape&) { return {std::numbers::pi * std::numbers::pi, "Φ = π² I"}; }
    static Factor projected(const CylinderShape& s) {
        return {closed_form::cylinder_area(s.radius.value, s.length.value), "I = 2 r l L"};
    }
    static Factor facing(const CylinderShape& s, Meters distance) {
        return {closed_form::facing_cylinder(s.radius.value, s.length.value, distance.value),
                "E = 2 [(r/d) atan(z/k) + (z/d) ((Q/NF) atan(tF/N) − atan t)] L, z = l/2, k² = d²−r², N² = (d−r)²+z², "
                "F² = (d+r)²+z², t² = (d−r)/(d+r), Q = d²+r²+z²"};
    }
    static shading::CylinderLight<double> core(const CylinderShape& s, const Frame& frame,
                                               const glm::dvec3& luminance) {
        return shape_detail::long_core<shading::CylinderLight<double>>(s, frame, luminance);
    }
};

} // namespace gonio
