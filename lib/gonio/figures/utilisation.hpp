// How much of the lamps' light reaches a working plane: utilisation factors, coefficients of utilisation.
//
// All are lumens on the plane per lumen of the lamps, so that the mean illuminance is E = Φ N factor MF/A; for absolute
// photometry the lamps' lumens are those of the luminaire.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/figures/box_room.hpp>

#include <array>

#pragma GCC visibility push(default)
namespace gonio {

// Room indices k = XY/(H(X + Y)), with H from the working plane to the luminaires.
inline constexpr std::array room_indices{0.6, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0};

// Reflectances of the columns of a table of utilisation factors. Makers choose their own; the last are those of UGR
// tables, and none at all.
inline constexpr std::array<RoomReflectances, 8> utilisation_reflectances{{{0.8, 0.8, 0.2},
                                                                           {0.8, 0.5, 0.2},
                                                                           {0.7, 0.5, 0.2},
                                                                           {0.7, 0.3, 0.2},
                                                                           {0.5, 0.5, 0.2},
                                                                           {0.5, 0.3, 0.2},
                                                                           {0.3, 0.3, 0.2},
                                                                           {0.0, 0.0, 0.0}}};

// A row for each room index.
using UtilisationFactors = std::array<std::array<double, utilisation_reflectances.size()>, room_indices.size()>;

// CIE 52, EN 13032-2: for square rooms with luminaires spread uniformly on the ceiling. Of the downward light the
// direct ratio falls on the plane first and the rest on the walls, upward light falls on the ceiling; the rest is
// flux_transfer(). `zones` are those of ten_degree_zones(), `direct_ratios` those at room_indices, `lamps` > 0.
UtilisationFactors utilisation_factors(const std::array<Lumens, 18>& zones, const std::array<double, 10>& direct_ratios,
                                       Lumens lamps);

// Columns of a table of coefficients of utilisation: effective reflectance of the ceiling cavity, of the walls, and 0.2
// of the floor cavity, as the IES prints them.
inline constexpr std::array<RoomReflectances, 18> cu_reflectances{{{0.8, 0.7, 0.2},
                                                                   {0.8, 0.5, 0.2},
                                                                   {0.8, 0.3, 0.2},
                                                                   {0.8, 0.1, 0.2},
                                                                   {0.7, 0.7, 0.2},
                                                                   {0.7, 0.5, 0.2},
                                                                   {0.7, 0.3, 0.2},
                                                                   {0.7, 0.1, 0.2},
                                                                   {0.5, 0.5, 0.2},
                                                                   {0.5, 0.3, 0.2},
                                                                   {0.5, 0.1, 0.2},
                                                                   {0.3, 0.5, 0.2},
                                                                   {0.3, 0.3, 0.2},
                                                                   {0.3, 0.1, 0.2},
                                                                   {0.1, 0.5, 0.2},
                                                                   {0.1, 0.3, 0.2},
                                                                   {0.1, 0.1, 0.2},
                                                                   {0.0, 0.0, 0.2}}};

// A row for each room cavity ratio RCR = 5h(L + W)/(LW) from 0 to 10.
using UtilisationCoefficients = std::array<std::array<double, cu_reflectances.size()>, 11>;

// IES zonal cavity method. The direct ratio is D = Σφₙ exp(−A RCR^B)/φ over the nine downward zones of 10°; the rest is
// flux_transfer() in a square room. `zones` are those of ten_degree_zones(), `lamps` > 0.
UtilisationCoefficients utilisation_coefficients(const std::array<Lumens, 18>& zones, Lumens lamps);

// That D; 0 without downward light.
double zonal_direct_ratio(const std::array<Lumens, 18>& zones, double room_cavity_ratio);

} // namespace gonio
#pragma GCC visibility pop
