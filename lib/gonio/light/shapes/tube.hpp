// The traits of a tube: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio {

template<>
struct ShapeTraits<TubeShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "tube";
    static constexpr std::string_view summary = "a Lambertian capsule along X, l without its caps";
    static constexpr std::tuple keys{LengthKey<TubeShape>{"r", "radius", &TubeShape::radius},
                                     LengthKey<TubeShape>{"l", "length", &TubeShape::length}};
    static constexpr MaskedBy masked_by = MaskedBy::shown_area;
    static constexpr const char* masked_flux = "Φ = (∬ mask A(ω)/A dω) I₀";
    static constexpr bool inverse_square_is_exact = false;

    static double largest(const TubeShape& s) { return std::fmax(s.radius.value, s.length.value); }
    static double radius(const TubeShape& s) { return 0.5 * s.length.value + s.radius.value; }
    static double nearest(const TubeShape& s) { return s.radius.value; }
    static Radians half_cone(const TubeShape&) { return shape_detail::all_round; }
    static double shown(const TubeShape& s, const glm::dvec3& d) {
        // The projected area of a capsule: 2 r l sin ψ + π r², ψ from its axis.
        const double sin_psi = shape_detail::sine_from_axis(d);
        const double side = 2.0 * s.length.value;
        const double caps = std::numbers::pi * s.radius.value;
        return (side * sin_psi + caps) / (side + caps);
    }
    static Factor flux(const TubeShape& s) {
        return {closed_form::tube_solid_angle(s.radius.value, s.length.value),
                "Φ = π (2π r l + 4π r²)/(2 r l + π r²) I"};
    }
    static Factor projected(const TubeShape& s) {
        return {closed_form::tube_area(s.radius.value, s.length.value), "I = (2 r l + π r²) L"};
    }
    static Factor facing(const TubeShape& s, Meters distance) {
        return {closed_form::facing_tube(s.radius.value, s.length.value, distance.value),
                "E = 2 [(r/d) atan(z/k) + r²d/D³ atan(Dk/rz) + r z k/(d D²)] L, z = l/2, k² = d²−r², "
                "D² = d²+z²"};
    }
    static shading::TubeLight<double> core(const TubeShape& s, const Frame& frame, const glm::dvec3& luminance) {
        return shape_detail::long_core<shading::TubeLight<double>>(s, frame, luminance);
    }
};

} // namespace gonio
