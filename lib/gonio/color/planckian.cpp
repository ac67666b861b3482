#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/luminous_efficacy.hpp>
#include <gonio/color/planckian.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio {

namespace {

constexpr double nm = 1e-9;
constexpr double h = 6.62607015e-34; // J·s
constexpr double c = 299792458.0;    // m/s
constexpr double k = 1.380649e-23;   // J/K
constexpr std::size_t samples = detail::observer.size();

// 1 µm over the wavelength, so that powers of it stay near 1.
double wave_number(std::size_t i) {
    return 1e3 / (detail::observer_first_nm + static_cast<double>(i));
}

// Spectral radiance [W/(m²·sr·m)] summed over 1 nm, in W/(m²·sr), weighted by V and by 1.
struct Radiance {
    double luminous = 0.0;
    double band = 0.0;
};
Radiance radiance(Kelvin temperature) {
    Radiance sum;
    for (std::size_t i = 0; i < samples; ++i) {
        const double lambda = (detail::observer_first_nm + static_cast<double>(i)) * nm;
        const double lambda2 = lambda * lambda;
        const double spectral =
            2.0 * h * c * c / (lambda2 * lambda2 * lambda) / std::expm1(c2_meter_kelvin / (lambda * temperature.value));
        sum.luminous += spectral * detail::observer[i][1] * nm;
        sum.band += spectral * nm;
    }
    return sum;
}

} // namespace

LocusPoint planckian_sum(double t) {
    // X, Y, Z and their first two derivatives by t. With n = 1/(e^(at) − 1): n' = −a n(1+n), n'' = a² n(1+n)(1+2n).
    std::array<std::array<double, 3>, 3> sum{};
    for (std::size_t i = 0; i < samples; ++i) {
        const double w = wave_number(i);
        const double a = c2_meter_kelvin * 1e3 * w; // c2 / (λ · 1000 K)
        const double n = 1.0 / std::expm1(a * t);
        const double weight = w * w * w * w * w * n;
        const double first = -a * (1.0 + n);
        const double second = a * a * (1.0 + n) * (1.0 + 2.0 * n);
        for (std::size_t j = 0; j < 3; ++j) {
            const double power = weight * detail::observer[i][j];
            sum[0][j] += power;
            sum[1][j] += power * first;
            sum[2][j] += power * second;
        }
    }
    // u = N/D: u' = (N' − uD')/D, u'' = (N'' − 2u'D' − uD'')/D.
    std::array<double, 3> d{};
    std::array<double, 3> nu{};
    std::array<double, 3> nv{};
    for (std::size_t order = 0; order < 3; ++order) {
        d[order] = sum[order][0] + 15.0 * sum[order][1] + 3.0 * sum[order][2];
        nu[order] = 4.0 * sum[order][0];
        nv[order] = 6.0 * sum[order][1];
    }
    LocusPoint point;
    point.at = {nu[0] / d[0], nv[0] / d[0]};
    point.first = {(nu[1] - point.at.u * d[1]) / d[0], (nv[1] - point.at.v * d[1]) / d[0]};
    point.second = {(nu[2] - 2.0 * point.first.u * d[1] - point.at.u * d[2]) / d[0],
                    (nv[2] - 2.0 * point.first.v * d[1] - point.at.v * d[2]) / d[0]};
    return point;
}

glm::dvec3 planckian_xyz(Kelvin temperature, double c2) {
    glm::dvec3 xyz(0.0);
    for (std::size_t i = 0; i < samples; ++i) {
        const double w = wave_number(i);
        const double power = std::isinf(temperature.value)
                                 ? w * w * w * w
                                 : w * w * w * w * w / std::expm1(c2 * 1e6 * w / temperature.value);
        for (int j = 0; j < 3; ++j)
            xyz[j] += power * detail::observer[i][static_cast<std::size_t>(j)];
    }
    return xyz / xyz.y;
}

namespace {

// [W/(m²·sr)], over all wavelengths: σT⁴/π.
double total_radiance(Kelvin temperature) {
    const double sigma = 2.0 * std::pow(std::numbers::pi, 5) * std::pow(k, 4) / (15.0 * std::pow(h, 3) * c * c);
    return sigma * std::pow(temperature.value, 4) / std::numbers::pi;
}

} // namespace

BlackbodyEfficacy blackbody_efficacy(Kelvin temperature) {
    const Radiance sum = radiance(temperature);
    return {luminous_efficacy_constant * sum.luminous / total_radiance(temperature),
            luminous_efficacy_constant * sum.luminous / sum.band};
}

Nits blackbody_luminance(Kelvin temperature) {
    return Nits(luminous_efficacy_constant * radiance(temperature).luminous);
}

Nits blackbody_luminance(Kelvin temperature, const BlackbodyEfficacy& efficacy) {
    return Nits(efficacy.total_lm_per_w * total_radiance(temperature));
}

} // namespace gonio
