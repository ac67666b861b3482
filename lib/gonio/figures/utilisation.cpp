#include <gonio/figures/utilisation.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

namespace gonio {

namespace {

// Lumens per lumen of the lamps.
struct Halves {
    double down = 0.0;
    double up = 0.0;
};

Halves halves_of(const std::array<Lumens, 18>& zones, Lumens lamps) {
    Halves halves;
    for (std::size_t i = 0; i < zones.size(); ++i)
        (i < 9 ? halves.down : halves.up) += zones[i] / lamps;
    return halves;
}

// Of the downward light the share `direct` falls on the plane first.
double utilisation(const Halves& light, double direct, const FluxTransfer::Sources& plane_from) {
    return light.down * (direct * plane_from.floor + (1.0 - direct) * plane_from.walls) + light.up * plane_from.ceiling;
}

} // namespace

UtilisationFactors utilisation_factors(const std::array<Lumens, 18>& zones, const std::array<double, 10>& direct_ratios,
                                       Lumens lamps) {
    const Halves light = halves_of(zones, lamps);
    UtilisationFactors factors{};
    static const auto transfers = flux_transfers<room_indices.size()>(
        utilisation_reflectances, [](std::size_t row) { return glm::dvec2(2.0 * room_indices.at(row)); });
    for (std::size_t row = 0; row < factors.size(); ++row)
        for (std::size_t column = 0; column < factors[row].size(); ++column)
            factors[row][column] = utilisation(light, direct_ratios[row], transfers[row][column].floor_from);
    return factors;
}

UtilisationCoefficients utilisation_coefficients(const std::array<Lumens, 18>& zones, Lumens lamps) {
    const Halves light = halves_of(zones, lamps);
    UtilisationCoefficients coefficients{};
    static const auto transfers =
        flux_transfers<std::tuple_size_v<UtilisationCoefficients>>(cu_reflectances, [](std::size_t rcr) {
            return glm::dvec2(rcr == 0 ? std::numeric_limits<double>::infinity() : 10.0 / static_cast<double>(rcr));
        });
    for (std::size_t rcr = 0; rcr < coefficients.size(); ++rcr) {
        const double direct = zonal_direct_ratio(zones, static_cast<double>(rcr));
        for (std::size_t column = 0; column < coefficients[rcr].size(); ++column)
            coefficients[rcr][column] = utilisation(light, direct, transfers[rcr][column].floor_from);
    }
    return coefficients;
}

double zonal_direct_ratio(const std::array<Lumens, 18>& zones, double room_cavity_ratio) {
    constexpr std::array a{0.0, 0.041, 0.070, 0.100, 0.136, 0.190, 0.315, 0.640, 2.10};
    constexpr std::array b{0.0, 0.98, 1.05, 1.12, 1.16, 1.25, 1.25, 1.25, 0.80};
    double direct = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        down += zones[i].value;
        direct += zones[i].value * std::exp(-a.at(i) * std::pow(room_cavity_ratio, b.at(i)));
    }
    return down > 0.0 ? direct / down : 0.0;
}

} // namespace gonio
