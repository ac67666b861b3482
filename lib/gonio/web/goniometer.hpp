// The angles of the three goniometers and their directions (IES LM-75, CIE 121).
//
// Horizontal and vertical as LM-63 lists them, in degrees. In a light's frame the aim is −Z:
//   C  half planes around the axis:  C horizontal, γ vertical    (sinγ cosC, sinγ sinC, −cosγ)
//   A  polar axis Y: H is the longitude, V the latitude          (cosV sinH, sinV, −cosV cosH)
//   B  polar axis X: H is the latitude, V the longitude          (sinH, cosH sinV, −cosH cosV)
// So (0, 0) of A and B is the aim, H = 90° is C0 and V = 90° is C90, and a table of A or B is a true rotation of
// directions, never a transpose of a type C table. The measure of flux is cos(latitude) dH dV for A and B.
#pragma once

#include <gonio/profile/profile.hpp>

#include <glm/vec3.hpp>

namespace gonio {

struct GoniometerAngles {
    double horizontal_deg = 0.0;
    double vertical_deg = 0.0;
};

// Unit vector; any angles.
glm::dvec3 direction_of(Photometry type, GoniometerAngles angles);

// Angles of a direction of any length > 0: C in [0°, 360°) and γ in [0°, 180°]; latitudes in [−90°, 90°], longitudes in
// (−180°, 180°]. A longitude is 0 at the poles, where it has no meaning.
GoniometerAngles angles_of(Photometry type, const glm::dvec3& direction);

} // namespace gonio
