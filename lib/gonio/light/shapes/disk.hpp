// The traits of a disk: see description.hpp.
#pragma once

#include <gonio/light/closed_forms.hpp>
#include <gonio/light/shapes/description.hpp>
#include <gonio/shading/lights.hpp>

namespace gonio {

template<>
struct ShapeTraits<DiskShape> {
    static constexpr ShapeClass shape_class = ShapeClass::area;
    static constexpr std::string_view kind = "disk";
    static constexpr std::string_view summary = "a Lambertian disk of radius r";
    static constexpr std::tuple keys{LengthKey<DiskShape>{"r", "radius", &DiskShape::radius},
                                     FlagKey<DiskShape>{"two-sided", &DiskShape::two_sided}};
    static constexpr MaskedBy masked_by = MaskedBy::shown_area;
    static constexpr const char* masked_flux = "Φ = (∬ mask cosγ dω) I₀";
    static constexpr bool inverse_square_is_exact = false;

    static double largest(const DiskShape& s) { return s.radius.value; }
    static double radius(const DiskShape& s) { return s.radius.value; }
    static double nearest(const DiskShape&) { return 0.0; }
    static Radians half_cone(const DiskShape& s) { return shape_detail::flat_half_cone(s); }
    static double shown(const DiskShape& s, const glm::dvec3& direction) {
        return shape_detail::flat_shown(s, direction);
    }
    static Factor flux(const DiskShape& s) { return shape_detail::flat_flux(s); }
    static Factor projected(const DiskShape& s) { return {closed_form::disk_area(s.radius.value), "I = π r² L"}; }
    static Factor facing(const DiskShape& s, Meters distance) {
        return {closed_form::facing_disk(s.radius.value, distance.value), "E = I/(d² + r²)"};
    }
    static shading::DiskLight<double> core(const DiskShape& s, const Frame& frame, const glm::dvec3& luminance) {
        return {shape_detail::core(frame.origin),
                shape_detail::core(luminance),
                shape_detail::core(-frame.z),
                s.radius.value,
                0.0,
                s.two_sided};
    }
};

} // namespace gonio
