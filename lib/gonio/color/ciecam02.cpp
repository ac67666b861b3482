#include <gonio/color/detail/ciecam02.hpp>

#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

// Rows as printed; GLM's matrices are written by columns.
glm::dmat3 rows(const glm::dvec3& r0, const glm::dvec3& r1, const glm::dvec3& r2) {
    return glm::transpose(glm::dmat3(r0, r1, r2));
}

constexpr double surround_c = 0.69; // average
constexpr double surround_nc = 1.0;

double signed_power(double base, double exponent) {
    return std::copysign(std::pow(std::fabs(base), exponent), base);
}

double achromatic(const glm::dvec3& response, double induction) {
    return (2.0 * response.x + response.y + response.z / 20.0 - 0.305) * induction;
}

} // namespace

Ciecam02::Ciecam02(const ViewingConditions& conditions) {
    const glm::dmat3 cat02 = rows({0.7328, 0.4296, -0.1624}, {-0.7036, 1.6975, 0.0061}, {0.0030, 0.0136, 0.9834});
    const glm::dmat3 pointer = rows({0.38971, 0.68898, -0.07868}, {-0.22981, 1.18340, 0.04641}, {0.0, 0.0, 1.0});
    const double k = 1.0 / (5.0 * conditions.adapting_nt + 1.0);
    const double k4 = k * k * k * k;
    luminance_adaptation_ = 0.2 * k4 * 5.0 * conditions.adapting_nt +
                            0.1 * (1.0 - k4) * (1.0 - k4) * std::cbrt(5.0 * conditions.adapting_nt);
    const double n = conditions.background_y / conditions.white.y;
    induction_ = 0.725 * std::pow(1.0 / n, 0.2);
    chroma_scale_ = std::pow(1.64 - std::pow(0.29, n), 0.73);
    exponent_ = surround_c * (1.48 + std::sqrt(n));
    const glm::dvec3 white = cat02 * conditions.white;
    const glm::dvec3 gain =
        conditions.adaptation * conditions.white.y / white + glm::dvec3(1.0 - conditions.adaptation);
    to_cones_ =
        pointer * glm::inverse(cat02) * glm::dmat3({gain.x, 0.0, 0.0}, {0.0, gain.y, 0.0}, {0.0, 0.0, gain.z}) * cat02;
    white_response_ = achromatic(response(conditions.white), induction_);
}

glm::dvec3 Ciecam02::response(const glm::dvec3& xyz) const {
    const glm::dvec3 cones = to_cones_ * xyz;
    glm::dvec3 compressed;
    for (int i = 0; i < 3; ++i) {
        const double x = std::pow(luminance_adaptation_ * std::fabs(cones[i]) / 100.0, 0.42);
        compressed[i] = std::copysign(400.0 * x / (x + 27.13), cones[i]) + 0.1;
    }
    return compressed;
}

Appearance Ciecam02::appearance(const glm::dvec3& xyz) const {
    const glm::dvec3 r = response(xyz);
    const double a = r.x - 12.0 * r.y / 11.0 + r.z / 11.0;
    const double b = (r.x + r.y - 2.0 * r.z) / 9.0;
    const double hue = std::atan2(b, a);
    Appearance seen;
    seen.hue_deg = hue * 180.0 / std::numbers::pi;
    if (seen.hue_deg < 0.0) seen.hue_deg += 360.0;
    if (seen.hue_deg >= 360.0) seen.hue_deg = 0.0; // rounded up
    const double eccentricity = 0.25 * (std::cos(hue + 2.0) + 3.8);
    const double t =
        50000.0 / 13.0 * surround_nc * induction_ * eccentricity * std::hypot(a, b) / (r.x + r.y + 21.0 * r.z / 20.0);
    seen.lightness = 100.0 * signed_power(achromatic(r, induction_) / white_response_, exponent_);
    seen.chroma = signed_power(t, 0.9) * std::sqrt(std::fabs(seen.lightness) / 100.0) * chroma_scale_;
    seen.colourfulness = seen.chroma * std::pow(luminance_adaptation_, 0.25);
    return seen;
}

UcsPoint cam02_ucs(const Appearance& appearance) {
    const double m = std::log(1.0 + 0.0228 * appearance.colourfulness) / 0.0228;
    const double hue = appearance.hue_deg * std::numbers::pi / 180.0;
    return {1.7 * appearance.lightness / (1.0 + 0.007 * appearance.lightness), m * std::cos(hue), m * std::sin(hue)};
}

} // namespace gonio::detail
