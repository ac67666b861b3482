// LuminousBody: a luminous opening as the faces that emit, and its projected area.
//
// The model: all points of the opening have the same luminance towards a direction ω,
//
//   L(ω) = I(ω)/A(ω),   A(ω) = Σ Aᵢ max(nᵢ·ω, 0) over its faces,
//
// with the measured intensity I(ω). So the intensities of the faces, Aᵢ max(nᵢ·ω, 0) L(ω), add up to I(ω) exactly, and
// an element dA of a flat opening has the intensity I(ω) dA/A. A measurement from far away does not say where on the
// opening light leaves: a luminaire with single bright lenses differs from the model close to it.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A flat face is one-sided and emits along −Z of its frame; a sphere emits all around.
struct LuminousFace {
    Shape shape;
    Frame frame;            // in the frame of the luminaire
    double area_m2 = 0.0;   // of the emitting surface
    bool is_flat = true;    // or a sphere
    glm::dvec3 normal{0.0}; // of a flat face
};

// The surface of a luminaire's opening, with the luminance that its profile gives it.
class LuminousBody {
public:
    // The faces of an opening from which the web emits: both sides of a flat one if it emits to both. A rectangle, a
    // box and an ellipse are exact; a cylinder is a prism of 12 sides with the same lateral area, and an ellipsoid is
    // an upright elliptic cylinder of the same volume. A size of 0 beside others counts as a thousandth of the largest.
    // Nothing for a point and for a dark web.
    static std::optional<LuminousBody> of(const Opening& opening, const Web& web);

    const std::vector<LuminousFace>& faces() const { return faces_; }

    // A(ω) towards a direction of the luminaire's frame, of any length > 0 [m²].
    double projected_area_m2(const glm::dvec3& direction) const;

    // Of all faces [m²].
    double area_m2() const { return area_m2_; }
    // The area of one face if all faces are in one plane, or back to back in one; else 0 [m²].
    double flat_area_m2() const { return flat_area_m2_; }

    // The luminance whose Lambertian emission from all faces has the flux of the web.
    Nits mean_luminance() const { return mean_luminance_; }

    // The flux towards the far side of a flat opening: the side that faces up, or away from C0 or C90. 0 for others.
    Lumens flux_behind() const { return flux_behind_; }

private:
    void add(Shape shape, const Frame& frame, double area_m2);
    void add_rectangle(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& along, double width_m,
                       double height_m);
    void add_disk(const glm::dvec3& center, const glm::dvec3& normal, const glm::dvec3& along, double width_m,
                  double height_m);
    void add_box(const glm::dvec3& size_m, const std::array<double, 4>& side_heights_m, bool emits_up);
    void add_cylinder(const glm::dvec3& axis, const glm::dvec3& across, const glm::dvec3& size_m);

    std::vector<LuminousFace> faces_;
    double area_m2_ = 0.0;
    double flat_area_m2_ = 0.0;
    Nits mean_luminance_;
    Lumens flux_behind_;
};

} // namespace gonio
#pragma GCC visibility pop
