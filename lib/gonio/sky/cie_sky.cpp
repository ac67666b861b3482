#include <gonio/base/named.hpp>
#include <gonio/sky/cie_sky.hpp>
#include <gonio/sky/detail/sphere_quadrature.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

constexpr int overcast_number = 16;

// Table 1 of CIE S 011: the descriptions are its, shortened.
constexpr std::array types{
    CieSkyType{1, "1",
               "overcast, steep gradation to the zenith, the same in all azimuths: the CIE standard overcast sky", 4.0,
               -0.7, 0.0, -1.0, 0.0},
    CieSkyType{2, "2", "overcast, steep gradation, slightly brighter towards the sun", 4.0, -0.7, 2.0, -1.5, 0.15},
    CieSkyType{3, "3", "overcast, moderate gradation, the same in all azimuths", 1.1, -0.8, 0.0, -1.0, 0.0},
    CieSkyType{4, "4", "overcast, moderate gradation, slightly brighter towards the sun", 1.1, -0.8, 2.0, -1.5, 0.15},
    CieSkyType{5, "5", "uniform", 0.0, -1.0, 0.0, -1.0, 0.0},
    CieSkyType{6, "6", "partly cloudy, no gradation, slightly brighter towards the sun", 0.0, -1.0, 2.0, -1.5, 0.15},
    CieSkyType{7, "7", "partly cloudy, no gradation, brighter about the sun", 0.0, -1.0, 5.0, -2.5, 0.3},
    CieSkyType{8, "8", "partly cloudy, no gradation, distinct solar corona", 0.0, -1.0, 10.0, -3.0, 0.45},
    CieSkyType{9, "9", "partly cloudy, the sun obscured", -1.0, -0.55, 2.0, -1.5, 0.15},
    CieSkyType{10, "10", "partly cloudy, brighter about the sun", -1.0, -0.55, 5.0, -2.5, 0.3},
    CieSkyType{11, "11", "white-blue sky with a distinct solar corona", -1.0, -0.55, 10.0, -3.0, 0.45},
    CieSkyType{12, "12", "clear, low turbidity: the CIE standard clear sky", -1.0, -0.32, 10.0, -3.0, 0.45},
    CieSkyType{13, "13", "clear, polluted atmosphere", -1.0, -0.32, 16.0, -3.0, 0.3},
    CieSkyType{14, "14", "cloudless and turbid, broad solar corona", -1.0, -0.15, 16.0, -3.0, 0.3},
    CieSkyType{15, "15", "white-blue and turbid, broad solar corona", -1.0, -0.15, 24.0, -2.8, 0.15},
    CieSkyType{overcast_number, "overcast",
               "the traditional overcast sky: (1 + 2 cos Z)/3 of the zenith (Moon and Spencer 1942)", 0.0, -1.0, 0.0,
               -1.0, 0.0},
};

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// The angle between unit vectors: acos of their product loses its digits at 0, where the indicatrix is steepest.
double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return 2.0 * std::asin(std::min(0.5 * glm::length(a - b), 1.0));
}

} // namespace

std::span<const CieSkyType> cie_sky_types() {
    return types;
}

Result<const CieSkyType*> find_cie_sky(std::string_view name) {
    if (name == "16") return &types.back();
    return find_named("CIE sky", name, types).map([](const auto* row) -> const CieSkyType* { return row; });
}

CieSky::CieSky(const CieSkyType& type, const glm::dvec3& sun)
    : type_(&type), axis_(type.needs_sun() ? sun : up), offset_(std::exp(0.5 * std::numbers::pi * type.d)) {
    scale_ = 1.0 / (indicatrix(angle_between(axis_, up), axis_.z) * gradation(1.0));
}

double CieSky::gradation(double cos_zenith) const {
    if (type_->number == overcast_number) return (1.0 + 2.0 * cos_zenith) / 3.0;
    if (type_->a == 0.0 || cos_zenith <= 0.0) return 1.0;
    return 1.0 + type_->a * std::exp(type_->b / cos_zenith);
}

double CieSky::indicatrix(double chi, double cos_chi) const {
    if (!type_->needs_sun()) return 1.0;
    return 1.0 + type_->c * (std::exp(type_->d * chi) - offset_) + type_->e * cos_chi * cos_chi;
}

double CieSky::relative(const glm::dvec3& direction) const {
    if (!(direction.z >= 0.0)) return 0.0;
    const double chi = type_->needs_sun() ? angle_between(direction, axis_) : 0.0;
    return scale_ * indicatrix(chi, glm::dot(direction, axis_)) * gradation(direction.z);
}

double CieSky::illuminance(const glm::dvec3& normal) const {
    const std::array planes{up, normal};
    // Rounding makes nearly equal planes of one another; facing down, there is no sky.
    constexpr double alike = 1e-15;
    if (normal.z <= -1.0 + alike) return 0.0;
    const std::span<const glm::dvec3> above(planes.data(), normal.z >= 1.0 - alike ? 1 : 2);
    return detail::integrate_above(axis_, above, [&](const glm::dvec3& direction, double chi) {
        return scale_ * indicatrix(chi, std::cos(chi)) * gradation(direction.z) * glm::dot(direction, normal);
    });
}

double CieSky::mean() const {
    const std::array planes{up};
    const double sum = detail::integrate_above(axis_, planes, [&](const glm::dvec3& direction, double chi) {
        return scale_ * indicatrix(chi, std::cos(chi)) * gradation(direction.z);
    });
    return sum / (2.0 * std::numbers::pi);
}

} // namespace gonio
