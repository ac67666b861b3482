// CIECAM02, forward only, and the uniform space CAM02-UCS.
//
// CIE 159:2004, "A colour appearance model for colour management systems: CIECAM02"; M. R. Luo, G. Cui and C. Li,
// "Uniform colour spaces based on CIECAM02 colour appearance model", 2006. Average surround.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace gonio::detail {

struct ViewingConditions {
    glm::dvec3 white{0.0};      // XYZ of the adapting white, Y about 100
    double adapting_nt = 100.0; // L_A
    double background_y = 20.0; // Y_b
    double adaptation = 1.0;    // D: 1 is complete
};

// Lightness, chroma, colourfulness and hue angle.
struct Appearance {
    double lightness = 0.0;     // J
    double chroma = 0.0;        // C
    double colourfulness = 0.0; // M
    double hue_deg = 0.0;       // h, from 0 to below 360
};

// A point of CAM02-UCS: J', a', b'. Distances are colour differences.
struct UcsPoint {
    double j = 0.0;
    double a = 0.0;
    double b = 0.0;
};
UcsPoint cam02_ucs(const Appearance& appearance);

// The model for one set of viewing conditions.
class Ciecam02 {
public:
    explicit Ciecam02(const ViewingConditions& conditions);

    // Of an XYZ on the scale of the white. A colour with a negative achromatic response, which no surface has, gets J
    // with its sign.
    Appearance appearance(const glm::dvec3& xyz) const;

private:
    // Cone responses after adaptation, compressed.
    glm::dvec3 response(const glm::dvec3& xyz) const;

    glm::dmat3 to_cones_{1.0};          // CAT02, adaptation, Hunt-Pointer-Estevez
    double luminance_adaptation_ = 0.0; // F_L
    double induction_ = 0.0;            // N_bb = N_cb
    double chroma_scale_ = 0.0;         // (1.64 − 0.29^n)^0.73
    double exponent_ = 0.0;             // c z
    double white_response_ = 0.0;       // A_w
};

} // namespace gonio::detail
