// The traits of a point: see description.hpp.
#pragma once

#include <gonio/light/shapes/description.hpp>

namespace gonio {

template<>
struct ShapeTraits<PointShape> {
    static constexpr ShapeClass shape_class = ShapeClass::punctual;
    static constexpr std::string_view kind = "point";
    static constexpr std::string_view summary = "uniform in every direction, without size";
    static constexpr std::tuple<> keys{};
    static constexpr MaskedBy masked_by = MaskedBy::mask;
    static constexpr const char* masked_flux = "Φ = (∬ mask dω) I₀";

    static double largest(const PointShape&) { return 0.0; }
    static double radius(const PointShape&) { return 0.0; }
    static Radians half_cone(const PointShape&) { return shape_detail::all_round; }
    static double shown(const PointShape&, const glm::dvec3&) { return 1.0; }
    static Factor flux(const PointShape&) { return {4.0 * std::numbers::pi, "Φ = 4π I"}; }
};

} // namespace gonio
