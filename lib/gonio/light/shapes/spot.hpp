// The traits of a spot: see description.hpp.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/shapes/description.hpp>

#include <string>

namespace gonio {

template<>
struct ShapeTraits<SpotShape> {
    static constexpr ShapeClass shape_class = ShapeClass::punctual;
    static constexpr std::string_view kind = "spot";
    static constexpr std::string_view summary = "a cone; half angles, or cone=ANGLE for the full one";
    static constexpr std::string_view grammar = "spot:outer=ANGLE[,inner=ANGLE][,falloff=NAME][,mask=FILE]";
    static constexpr AngleRange half_angles{0.0, 90.0, true, true};
    static constexpr std::tuple keys{AngleKey<SpotShape>{"outer", "outer", &SpotShape::outer, half_angles, "40deg"},
                                     AngleKey<SpotShape>{"inner", "inner", &SpotShape::inner, half_angles, "25deg"},
                                     FalloffKey<SpotShape>{"falloff", &SpotShape::falloff}};
    static constexpr MaskedBy masked_by = MaskedBy::lobe;
    static constexpr const char* masked_flux = "Φ = (∬ lobe · mask dω) I₀";

    // "outer" or "cone", the full angle; inner ≤ outer.
    static Result<SpotShape> parse(const KindText& text);
    // The keys of the grammar, "cone" and "beam", the full angle at half of the peak.
    static Result<bool> set_parameter(SpotShape& spot, std::string_view name, const std::string& value);

    static double largest(const SpotShape&) { return 0.0; }
    static double radius(const SpotShape&) { return 0.0; }
    static Radians half_cone(const SpotShape& spot) { return spot.outer; }
    static double shown(const SpotShape& spot, const glm::dvec3& direction) {
        return lobe(spot, Radians(std::atan2(std::hypot(direction.x, direction.y), -direction.z)));
    }
    static Factor flux(const SpotShape& spot) { return {lobe_solid_angle(spot).value, flux_formula(spot)}; }
};

} // namespace gonio
