// The sixteen skies of the CIE: relative luminance of a direction.
//
// CIE S 011:2003 = ISO 15469:2004: L/Lz = f(χ) φ(Z) / (f(Zs) φ(0)), with the gradation φ(Z) = 1 + a exp(b/cos Z), 1 at
// the horizon, and the indicatrix f(χ) = 1 + c (exp(dχ) − exp(dπ/2)) + e cos²χ; Z is the angle from the zenith, Zs that
// of the sun, χ the angle from the sun. The sixteenth is the traditional overcast sky of Moon and Spencer (1942),
// L/Lz = (1 + 2 cos Z)/3, which the standard gives beside them.
//
// z is up. Each sky is relative, without a disc of the sun and without colour. Where a high sun stands near the zenith,
// Lz is the luminance beside the sun: state amounts by the illuminance.
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A sky of ISO 15469:2004(E)/CIE S 011/E:2003 by the parameters of its formula.
struct CieSkyType {
    int number = 0; // of the standard; 16 is the traditional overcast sky
    std::string_view name;
    std::string_view summary;
    // a and b of the gradation; c, d and e of the indicatrix
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
    double d = 0.0;
    double e = 0.0;

    // Whether the luminance depends on the sun.
    constexpr bool needs_sun() const { return c != 0.0 || e != 0.0; }
};

// In the order of the standard.
std::span<const CieSkyType> cie_sky_types();

// "12" or "overcast", also "16". Fails (usage) on other names.
Result<const CieSkyType*> find_cie_sky(std::string_view name);

// One of these under a sun: a value. A direction costs two exponentials and an arc sine.
class CieSky {
public:
    // `sun` is a unit vector with z ≥ 0 towards the sun; types that do not need one ignore it.
    CieSky(const CieSkyType& type, const glm::dvec3& sun);

    // L/Lz of a unit direction; 0 for z < 0.
    double relative(const glm::dvec3& direction) const;

    // E/Lz [sr] on an open plane with a unit normal, of the sky alone: the ground is black. Within 1e-8 of the value,
    // in about a millisecond.
    double illuminance(const glm::dvec3& normal) const;

    // The mean of L/Lz over the upper hemisphere, by solid angle.
    double mean() const;

    // The axis of its symmetry: towards the sun, or up where the sun has no effect. If it has a cusp, it is there.
    const glm::dvec3& axis() const { return axis_; }

    const CieSkyType& type() const { return *type_; }

private:
    double gradation(double cos_zenith) const;
    double indicatrix(double chi, double cos_chi) const;

    const CieSkyType* type_;
    glm::dvec3 axis_;
    double offset_ = 0.0; // exp(dπ/2)
    double scale_ = 1.0;  // 1/(f(Zs) φ(0))
};

} // namespace gonio
#pragma GCC visibility pop
