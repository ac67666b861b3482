// The traits of a rectangle: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio {

template<>
struct ShapeTraits<RectShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "rect";
    static constexpr std::string_view summary = "a Lambertian rectangle, w along X and h along Y";
    static constexpr std::tuple keys{LengthKey<RectShape>{"w", "width", &RectShape::width},
                                     LengthKey<RectShape>{"h", "h", &RectShape::height},
                                     FlagKey<RectShape>{"two-sided", &RectShape::two_sided}};
    static constexpr MaskedBy masked_by = MaskedBy::shown_area;
    static constexpr const char* masked_flux = "Φ = (∬ mask cosγ dω) I₀";
    static constexpr bool inverse_square_is_exact = false;

    static double largest(const RectShape& s) { return std::fmax(s.width.value, s.height.value); }
    static double radius(const RectShape& s) { return 0.5 * std::hypot(s.width.value, s.height.value); }
    static double nearest(const RectShape&) { return 0.0; }
    static Radians half_cone(const RectShape& s) { return shape_detail::flat_half_cone(s); }
    static double shown(const RectShape& s, const glm::dvec3& direction) {
        return shape_detail::flat_shown(s, direction);
    }
    static Factor flux(const RectShape& s) { return shape_detail::flat_flux(s); }
    static Factor projected(const RectShape& s) { return {s.width.value * s.height.value, "I = w h L"}; }
    static Factor facing(const RectShape& s, Meters distance) {
        return {closed_form::facing_rectangle(s.width.value, s.height.value, distance.value),
                "E = 2 [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))] L, A = w/2d, B = h/2d"};
    }
    static shading::RectangleLight<double> core(const RectShape& s, const Frame& frame, const glm::dvec3& luminance) {
        return {shape_detail::core(frame.origin),
                shape_detail::core(luminance),
                shape_detail::core(-frame.z),
                shape_detail::core(frame.x),
                s.width.value,
                s.height.value,
                0.0,
                s.two_sided};
    }
};

} // namespace gonio
