// The traits of a sphere: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio {

template<>
struct ShapeTraits<SphereShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "sphere";
    static constexpr std::string_view summary = "a Lambertian sphere of radius r";
    static constexpr std::tuple keys{LengthKey<SphereShape>{"r", "radius", &SphereShape::radius}};
    static constexpr MaskedBy masked_by = MaskedBy::mask;
    static constexpr const char* masked_flux = "Φ = (∬ mask dω) I₀";
    static constexpr bool inverse_square_is_exact = true;

    static double largest(const SphereShape& s) { return s.radius.value; }
    static double radius(const SphereShape& s) { return s.radius.value; }
    static double nearest(const SphereShape& s) { return s.radius.value; }
    static Radians half_cone(const SphereShape&) { return shape_detail::all_round; }
    static double shown(const SphereShape&, const glm::dvec3&) { return 1.0; }
    static Factor flux(const SphereShape&) { return {4.0 * std::numbers::pi, "Φ = 4π I"}; }
    static Factor projected(const SphereShape& s) { return {closed_form::disk_area(s.radius.value), "I = π r² L"}; }
    static Factor facing(const SphereShape& s, Meters distance) {
        return {closed_form::facing_sphere(s.radius.value, distance.value), "E = I/d²"};
    }
    static shading::SphereLight<double> core(const SphereShape& s, const Frame& frame, const glm::dvec3& luminance) {
        return {shape_detail::core(frame.origin), shape_detail::core(luminance), s.radius.value, 0.0};
    }
};

} // namespace gonio
