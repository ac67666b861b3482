// A light of the same flux as a profile or an area, for programs without them: a point if the profile emits upwards
// too, else a spot about as narrow, with glTF's falloff.
#pragma once

#include <gonio/asset/measured_light.hpp>

namespace gonio::asset_detail {

struct SameFlux {
    bool is_point = true;
    double intensity = 0.0; // cd along the axis
    double inner = 0.0;     // half angles of the spot [rad], 0 ≤ inner < outer
    double outer = 0.0;
};

SameFlux same_flux(const MeasuredLight& light);

// Of one side of a rectangle or a disk with this intensity along its axis [cd].
SameFlux same_flux_as_area(double candela);

} // namespace gonio::asset_detail
