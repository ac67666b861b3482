// Parameters that several formulas have: lights with a size, and numbers of materials.
#pragma once

#include <gonio/shader/function.hpp>
// After the recording scalar.
#include <gonio/shading/ggx_anisotropic.hpp>
#include <gonio/shading/lights.hpp>

#include <string_view>

namespace gonio::shader {

using S = Recorded;
namespace core = shading;

// Lights, as their functions take them.

inline Vector center_of(Function& f) {
    return f.vector("to_center", "[m] from the receiver to the light's centre");
}
inline Vector normal_of(Function& f) {
    return f.unit("normal", "unit, the receiver's");
}
inline Vector emission_axis_of(Function& f) {
    return f.unit("axis", "unit, the direction in which the light emits");
}

// The core's lights emit 1 nt and have no window.
inline Vector ones() {
    return {S(1), S(1), S(1)};
}

struct Sphere {
    Vector to_center;
    S radius;
    Vector normal;
    explicit Sphere(Function& f) : to_center(center_of(f)), radius(f.size("radius", "[m]")), normal(normal_of(f)) {}
    core::SphereLight<S> as_light() const { return {to_center, ones(), radius, S(0)}; }
};
struct Disk {
    Vector to_center, axis;
    S radius;
    Vector normal;
    explicit Disk(Function& f)
        : to_center(center_of(f)), axis(emission_axis_of(f)), radius(f.size("radius", "[m]")), normal(normal_of(f)) {}
    core::DiskLight<S> as_light() const { return {to_center, ones(), axis, radius, S(0), false}; }
};
struct Rectangle {
    Vector to_center, axis, width_direction;
    S width, height;
    Vector normal;
    explicit Rectangle(Function& f)
        : to_center(center_of(f)),
          axis(emission_axis_of(f)),
          width_direction(f.unit("width_direction", "unit, across the axis")),
          width(f.size("width", "[m]")),
          height(f.size("height", "[m] across the width")),
          normal(normal_of(f)) {}
    core::RectangleLight<S> as_light() const {
        return {to_center, ones(), axis, width_direction, width, height, S(0), false};
    }
};
struct Tube {
    Vector to_center, axis;
    S radius, length;
    Vector normal;
    explicit Tube(Function& f)
        : to_center(center_of(f)),
          axis(f.unit("axis", "unit, along the tube")),
          radius(f.size("radius", "[m]")),
          length(f.size("tube_length", "[m] without the hemispheres at its ends")),
          normal(normal_of(f)) {}
    core::TubeLight<S> as_light() const { return {to_center, ones(), axis, radius, length, S(0)}; }
};

inline Vector color_of(Function& f, std::string_view name, std::string_view meaning = "[0, 1]") {
    return f.vector(name, meaning);
}
inline S share_of(Function& f, std::string_view name, std::string_view meaning = "[0, 1]") {
    return f.size(name, meaning);
}

// Of a surface that is rougher along one direction than across it.
struct GrainParameters {
    Vector tangent;
    core::AnisotropicAlpha<S> alphas;
    explicit GrainParameters(Function& f)
        : tangent(f.unit("tangent", "unit, across the normal: the direction of alpha_along")),
          alphas{alpha(f, "alpha_along", "[1e-4, 1.5] along the tangent"),
                 alpha(f, "alpha_across", "[1e-4, 1.5] across it")} {}

private:
    static S alpha(Function& f, std::string_view name, std::string_view meaning) {
        return simd::max(f.size(name, meaning), S(core::minimum_alpha));
    }
};

} // namespace gonio::shader
