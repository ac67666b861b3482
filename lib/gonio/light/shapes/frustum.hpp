// The traits of a frustum: see description.hpp.
#pragma once

#include <gonio/light/lobe.hpp>
#include <gonio/light/shapes/description.hpp>

namespace gonio {

template<>
struct ShapeTraits<FrustumShape> {
    static constexpr ShapeClass shape_class = ShapeClass::punctual;
    static constexpr std::string_view kind = "frustum";
    static constexpr std::string_view summary = "a pyramid, uniform inside; full apex angles";
    static constexpr AngleRange apex_angles{0.0, 180.0, false, false};
    static constexpr std::tuple keys{
        AngleKey<FrustumShape>{"h", "h", &FrustumShape::horizontal, apex_angles, "60deg,v=40deg"},
        AngleKey<FrustumShape>{"v", "v", &FrustumShape::vertical, apex_angles, "40deg,h=60deg"}};
    static constexpr MaskedBy masked_by = MaskedBy::lobe;
    static constexpr const char* masked_flux = "Φ = (∬ mask dω inside the pyramid) I₀";

    static double largest(const FrustumShape&) { return 0.0; }
    static double radius(const FrustumShape&) { return 0.0; }
    static Radians half_cone(const FrustumShape& frustum) { // to its edges
        return Radians(
            std::atan(std::hypot(std::tan(0.5 * frustum.horizontal.value), std::tan(0.5 * frustum.vertical.value))));
    }
    static double shown(const FrustumShape& frustum, const glm::dvec3& direction) { return lobe(frustum, direction); }
    static Factor flux(const FrustumShape& frustum) {
        return {lobe_solid_angle(frustum).value, "Φ = 4 asin(sin(h/2) sin(v/2)) I"};
    }
};

} // namespace gonio
