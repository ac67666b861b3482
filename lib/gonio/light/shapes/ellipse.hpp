// The traits of an ellipse: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/irradiance_ellipse.hpp>

namespace gonio {

namespace closed_form {

// From the full axes w and h.
template<class S>
S ellipse_area(S w, S h) {
    return S(0.25) * pi<S> * (w * h);
}

// E/L as in closed_forms.hpp: π ab/√((d² + a²)(d² + b²)) with a = w/2, b = h/2, for d ≥ 0: the axis of the cone is
// perpendicular to the ellipse.
template<class S>
S facing_ellipse(S w, S h, S d) {
    const S a = S(0.5) * w;
    const S b = S(0.5) * h;
    return pi<S> * ((a / std::hypot(d, a)) * (b / std::hypot(d, b)));
}

} // namespace closed_form

template<>
struct ShapeTraits<EllipseShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "ellipse";
    static constexpr std::string_view summary = "a Lambertian ellipse, w along X and h along Y";
    static constexpr std::tuple keys{LengthKey<EllipseShape>{"w", "width", &EllipseShape::width},
                                     LengthKey<EllipseShape>{"h", "h", &EllipseShape::height},
                                     FlagKey<EllipseShape>{"two-sided", &EllipseShape::two_sided}};
    static constexpr MaskedBy masked_by = MaskedBy::shown_area;
    static constexpr const char* masked_flux = "Φ = (∬ mask cosγ dω) I₀";
    static constexpr bool inverse_square_is_exact = false;

    static double largest(const EllipseShape& s) { return std::fmax(s.width.value, s.height.value); }
    static double radius(const EllipseShape& s) { return 0.5 * largest(s); }
    static double nearest(const EllipseShape&) { return 0.0; }
    static Radians half_cone(const EllipseShape& s) { return shape_detail::flat_half_cone(s); }
    static double shown(const EllipseShape& s, const glm::dvec3& direction) {
        return shape_detail::flat_shown(s, direction);
    }
    static Factor flux(const EllipseShape& s) { return shape_detail::flat_flux(s); }
    static Factor projected(const EllipseShape& s) {
        return {closed_form::ellipse_area(s.width.value, s.height.value), "I = π/4 w h L"};
    }
    static Factor facing(const EllipseShape& s, Meters distance) {
        return {closed_form::facing_ellipse(s.width.value, s.height.value, distance.value),
                "E = I/√((d² + a²)(d² + b²)), a = w/2, b = h/2"};
    }
    static shading::EllipseLight<double> core(const EllipseShape& s, const Frame& frame, const glm::dvec3& luminance) {
        return {shape_detail::core(frame.origin),
                shape_detail::core(luminance),
                shape_detail::core(-frame.z),
                shape_detail::core(frame.x),
                0.5 * s.width.value,
                0.5 * s.height.value,
                0.0,
                s.two_sided};
    }
};

} // namespace gonio
