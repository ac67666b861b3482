// The traits of a sun: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio {

template<>
struct ShapeTraits<SunShape> {
    static constexpr ShapeClass shape_class = ShapeClass::sun;
    static constexpr std::string_view kind = "sun";
    static constexpr std::string_view summary = "a uniform disk of that angular diameter, at infinity";
    static constexpr AngleRange diameters{0.0, 180.0, false, true};
    static constexpr std::tuple keys{AngleKey<SunShape>{"angle", "angle", &SunShape::diameter, diameters, "0.53deg"}};
    static constexpr bool inverse_square_is_exact = true;

    static double largest(const SunShape&) { return 0.0; }
    static double radius(const SunShape&) { return 0.0; }
    static double nearest(const SunShape&) { return 0.0; }
    static Radians half_cone(const SunShape&) { return shape_detail::all_round; }
    static double shown(const SunShape&, const glm::dvec3&) { return 0.0; } // it has no intensity
    static Factor projected(const SunShape& s) {
        return {closed_form::sun_projected_solid_angle(s.diameter.value), "E = π sin²(δ/2) L"};
    }
    static shading::SunLight<double> core(const SunShape& s, const Frame& frame, const glm::dvec3& luminance) {
        const double sigma = 0.5 * s.diameter.value;
        return {shape_detail::core(frame.z), shape_detail::core(luminance), std::sin(sigma),
                std::fmax(std::cos(sigma), 0.0)};
    }
};

} // namespace gonio
