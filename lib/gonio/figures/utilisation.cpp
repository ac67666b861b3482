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

// What reaches the floor of square rooms in the end, for each side and set of reflectances.
template<std::size_t sides, std::size_t sets>
std::array<std::array<FluxTransfer::Sources, sets>, sides>
transfer_to_floor(const std::array<double, sides>& side, const std::array<RoomReflectances, sets>& reflectances) {
    std::array<std::array<FluxTransfer::Sources, sets>, sides> all;
    for (std::size_t row = 0; row < sides; ++row)
        for (std::size_t column = 0; column < sets; ++column)
            all[row][column] = flux_transfer(side[row], side[row], reflectances[column]).floor_from;
    return all;
}

auto transfer_by_room_index() {
    std::array<double, room_indices.size()> sides;
    for (std::size_t row = 0; row < sides.size(); ++row)
        sides[row] = 2.0 * room_indices.at(row);
    return transfer_to_floor(sides, utilisation_reflectances);
}

auto transfer_by_cavity_ratio() {
    std::array<double, std::tuple_size_v<UtilisationCoefficients>> sides;
    sides[0] = std::numeric_limits<double>::infinity();
    for (std::size_t rcr = 1; rcr < sides.size(); ++rcr)
        sides[rcr] = 10.0 / static_cast<double>(rcr);
    return transfer_to_floor(sides, cu_reflectances);
}

} // namespace

UtilisationFactors utilisation_factors(const std::array<Lumens, 18>& zones, const std::array<double, 10>& direct_ratios,
                                       Lumens lamps) {
    const Halves light = halves_of(zones, lamps);
    UtilisationFactors factors{};
    static const auto to_floor = transfer_by_room_index();
    for (std::size_t row = 0; row < factors.size(); ++row)
        for (std::size_t column = 0; column < factors[row].size(); ++column)
            factors[row][column] = utilisation(light, direct_ratios[row], to_floor[row][column]);
    return factors;
}

UtilisationCoefficients utilisation_coefficients(const std::array<Lumens, 18>& zones, Lumens lamps) {
    const Halves light = halves_of(zones, lamps);
    UtilisationCoefficients coefficients{};
    static const auto to_floor = transfer_by_cavity_ratio();
    for (std::size_t rcr = 0; rcr < coefficients.size(); ++rcr) {
        const double direct = zonal_direct_ratio(zones, static_cast<double>(rcr));
        for (std::size_t column = 0; column < coefficients[rcr].size(); ++column)
            coefficients[rcr][column] = utilisation(light, direct, to_floor[rcr][column]);
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
