// Stages with known indirect light, for tests.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>

#include "collocation.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace gonio::test {

using Vec = glm::dvec3;

inline Light bulb(const Vec& at, double cd) {
    Light light;
    light.name = "bulb";
    light.shape = PointShape{};
    light.frame.origin = at;
    light.intensity = Candelas(cd);
    light.color = Vec(1.0);
    return light;
}

inline Stage stage_of(const BoxRoom& room) {
    Stage stage;
    stage.camera = {0.25 * room.size, 0.75 * room.size};
    stage.light.position = room.light;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        Vec normal(0.0);
        normal[axis] = face % 2 == 0 ? 1.0 : -1.0;
        Vec middle = 0.5 * room.size;
        middle[axis] = face % 2 == 0 ? 0.0 : room.size[axis];
        const Vec up = axis == 2 ? Vec(0.0, 1.0, 0.0) : Vec(0.0, 0.0, 1.0);
        const Panel unsized = panel_facing(middle, normal, up, 1.0, 1.0);
        const auto extent = [&](const Vec& along) { return std::abs(glm::dot(along, room.size)); };
        stage.surfaces.push_back({"face",
                                  panel_facing(middle, normal, up, extent(unsized.frame.x), extent(unsized.frame.y)),
                                  LambertMaterial{Vec(room.albedo[static_cast<std::size_t>(face)])}});
    }
    return stage;
}

inline const BoxRoom six_reflectances{{5.0, 4.0, 3.0}, {0.6, 0.6, 0.5, 0.4, 0.2, 0.8}, {1.5, 1.0, 2.2}, 100.0};

struct WallPoint {
    std::size_t face;
    Vec at;
    double indirect_lx;
};

// Collocation on 9600 graded cells, extrapolated, ±1 in the last digit.
inline const std::array wall_points{WallPoint{4, {2.5, 2.0, 0.0}, 20.097}, WallPoint{4, {0.5, 0.5, 0.0}, 22.908},
                                    WallPoint{4, {4.5, 3.5, 0.0}, 10.431}, WallPoint{5, {1.5, 1.0, 3.0}, 18.884},
                                    WallPoint{5, {4.0, 3.0, 3.0}, 8.1610}, WallPoint{0, {0.0, 2.0, 1.5}, 17.894},
                                    WallPoint{0, {0.0, 0.3, 0.3}, 13.039}, WallPoint{1, {5.0, 2.0, 1.5}, 13.015},
                                    WallPoint{2, {2.5, 0.0, 1.0}, 14.034}, WallPoint{3, {2.5, 4.0, 2.0}, 15.640}};

inline Vec inwards(std::size_t face) {
    Vec normal(0.0);
    normal[static_cast<int>(face / 2)] = face % 2 == 0 ? 1.0 : -1.0;
    return normal;
}

// Two infinite planes 3 m apart, for a light of 100 cd 2 m above the lower one.
inline Stage two_planes() {
    Stage stage;
    stage.camera = {{0.0, -3.0, 1.5}, {0.0, 0.0, 1.5}};
    stage.light.position = {0.0, 0.0, 2.0};
    stage.surfaces = {{"below", Plane{Vec(0.0), Vec(0.0, 0.0, 1.0)}, LambertMaterial{Vec(0.3)}},
                      {"above", Plane{Vec(0.0, 0.0, 3.0), Vec(0.0, 0.0, -1.0)}, LambertMaterial{Vec(0.7)}}};
    return stage;
}

// Indirect light at the distance r from the light's foot, by Hankel transforms of Lambert's kernel.
struct PlanesRow {
    double r, below_lx, above_lx;
};
inline constexpr std::array planes_rows{
    PlanesRow{0.0, 9.2524989370, 3.3405791630}, PlanesRow{1.0, 8.3238903362, 3.1394205247},
    PlanesRow{3.0, 4.3359125723, 2.0545648872}, PlanesRow{6.0, 1.3583531796, 0.8102998235}};
inline constexpr double one_bounce_lx = 7.9289583588; // at r = 0 of the lower plane

} // namespace gonio::test
