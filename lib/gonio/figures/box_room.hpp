// A room as three surfaces, which is how the tables of the trade see it: ceiling, walls and floor, each of one
// reflectance and evenly lit.
//
// Lumens that first fall on a surface are reflected on without end. With the form factors F from surface to surface and
// the reflectances P, the lumens that reach each surface in the end are M φ, M = (1 − FᵀP)⁻¹.
#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <string>

#pragma GCC visibility push(default)
namespace gonio {

// Of ceiling, walls and floor, each from 0 to 1. Where the floor is a working plane its reflectance is that of the
// cavity below it.
struct RoomReflectances {
    double ceiling = 0.0;
    double walls = 0.0;
    double floor = 0.0;
};

// "70/50/20", in per cent.
std::string to_text(const RoomReflectances& reflectances);

// Share of the light from a Lambertian rectangle of sides x and y that reaches the same rectangle facing it, at
// distance
// 1. Both greater than 0, or infinite.
double facing_rectangles_form_factor(double x, double y);

// Lumens reaching each surface in the end per lumen that falls on one of them first: floor_from.walls is what a lumen
// on the walls brings to the floor. The first fall counts.
struct FluxTransfer {
    // Of a lumen on each surface.
    struct Sources {
        double floor = 0.0;
        double walls = 0.0;
        double ceiling = 0.0;
    };
    Sources floor_from;
    Sources walls_from;
    Sources ceiling_from;
};

// That of a room of sides x and y, in units of its height; infinite sides make walls that receive nothing. The
// reflectances must not all be 1.
FluxTransfer flux_transfer(double x, double y, const RoomReflectances& reflectances);

// The same for a table: a row for each room, whose sides are sides_of(row), and a column for each set of reflectances.
template<std::size_t rooms, std::size_t sets, class SidesOf>
std::array<std::array<FluxTransfer, sets>, rooms> flux_transfers(const std::array<RoomReflectances, sets>& reflectances,
                                                                 const SidesOf& sides_of) {
    std::array<std::array<FluxTransfer, sets>, rooms> table;
    for (std::size_t row = 0; row < rooms; ++row) {
        const glm::dvec2 sides = sides_of(row);
        for (std::size_t column = 0; column < sets; ++column)
            table[row][column] = flux_transfer(sides.x, sides.y, reflectances[column]);
    }
    return table;
}

} // namespace gonio
#pragma GCC visibility pop
