// A measured luminaire with a size as the area lights that its faces are.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/luminous_body.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace gonio {

// What a face of a luminous opening emits: the web of the luminaire over the projected area of its body.
struct FaceEmission {
    std::shared_ptr<const LuminousBody> body;
    std::shared_ptr<const Web> web;
    Frame luminaire;
    std::size_t face = 0; // of the body
};

// Gives a resolved light the body of its profile's opening, if its shape asks for one.
// Says so where an opening is missing, implausibly large, or flat and shone through from behind.
void give_body(Light& light, Diagnostics& diagnostics);

// The faces of `light.body`, which must be there, at the light's present position, amount and colour.
std::vector<Light> faces_of(const Light& light);

} // namespace gonio
