// ShapeTraits: the description of every kind of shape, written once. All code that lists, parses, measures or converts
// shapes, or exports them to another program's lights, derives from it; gonio/light/shape_traits.hpp includes the
// traits of all shapes.
//
// A specialisation has
//
//   shape_class     punctual, area or sun
//   kind, summary   "disk" and a line for `gonio list shapes`
//   keys            a tuple of the keys below, in the order of the grammar; a member `mask_file` adds "mask=FILE"
//   parse, grammar, set_parameter
//                   only where the keys alone are not enough (spot, ies)
//   largest(s)      the largest of its measures [m], 0 if it has none
//   radius(s)       of the bounding sphere about its centre [m]
//   half_cone(s)    the angle from its direction within which it emits
//   shown(s, d)     the intensity towards a direction d of its frame (axis −Z) over that along its direction, unmasked
//   flux(s)         Φ over I (not for the sun or ies), and the formula
//   masked_flux     the formula behind a mask; masked_by tells how it is integrated
//   facing(s, d)    E over the strength for a receiver that faces it at the distance d; punctual shapes have I/d²
//
// and an area shape or the sun
//
//   projected(s)    I/L (for the sun E/L), and the formula
//   nearest(s)      distances from its centre below this are inside it [m]
//   core(s, frame, luminance)
//                   the corresponding light of gonio/shading/lights.hpp, placed
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/light/shape_factors.hpp>
#include <gonio/shading/vec3.hpp>

#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

namespace gonio {

template<class Shape>
struct ShapeTraits; // not defined for a shape without a specialisation: a new shape does not compile until it has one

// How the flux behind a mask is integrated: over the mask alone, weighted by the lobe, or by the projected area.
enum class MaskedBy { mask, lobe, shown_area };

// The angles that a key accepts: from `least_deg` to `most_deg`, with or without each bound.
struct AngleRange {
    double least_deg = 0.0;
    double most_deg = 0.0;
    bool takes_least = false;
    bool takes_most = true;
};

// A key of the grammar, the parameter of a sweep that sets it, and the member that holds it.
template<class Shape>
struct LengthKey { // > 0
    std::string_view key;
    std::string_view parameter;
    Meters Shape::*member;
};
template<class Shape>
struct AngleKey {
    std::string_view key;
    std::string_view parameter;
    Radians Shape::*member;
    AngleRange range;
    std::string_view example; // "60deg,v=40deg": includes the other required keys
};
template<class Shape>
struct FlagKey { // present or absent
    std::string_view key;
    bool Shape::*member;
};
template<class Shape>
struct FalloffKey {
    std::string_view key;
    Falloff Shape::*member;
};

template<class Shape>
concept PunctualShape = ShapeTraits<Shape>::shape_class == ShapeClass::punctual;
template<class Shape>
concept AreaShape = ShapeTraits<Shape>::shape_class == ShapeClass::area;
template<class Shape>
concept MaskedShape = requires(Shape shape) {
    shape.mask_file;
};

namespace shape_detail {

inline shading::vec3<double> core(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

// For shapes that emit in all directions.
inline constexpr Radians all_round{std::numbers::pi};

// For a long shape: the light of the core, and the sine of the angle from its axis, X.
template<class CoreLight, class Long>
CoreLight long_core(const Long& shape, const Frame& frame, const glm::dvec3& luminance) {
    return {core(frame.origin), core(luminance), core(frame.x), shape.radius.value, shape.length.value, 0.0};
}
inline double sine_from_axis(const glm::dvec3& d) {
    return std::hypot(d.y, d.z) / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

// For a flat shape: the cosine from its direction, on both sides if two-sided.
template<class Flat>
double flat_shown(const Flat& shape, const glm::dvec3& direction) {
    const double cos_theta =
        -direction.z / std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
    return shape.two_sided ? std::abs(cos_theta) : std::fmax(cos_theta, 0.0);
}
template<class Flat>
Factor flat_flux(const Flat& shape) {
    constexpr double pi = std::numbers::pi;
    return shape.two_sided ? Factor{2.0 * pi, "Φ = 2π I"} : Factor{pi, "Φ = π I"};
}
template<class Flat>
Radians flat_half_cone(const Flat& shape) {
    return Radians(shape.two_sided ? std::numbers::pi : 0.5 * std::numbers::pi);
}

} // namespace shape_detail

} // namespace gonio
