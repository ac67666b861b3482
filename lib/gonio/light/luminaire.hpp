// A measured luminaire with a size as the area lights that its faces are.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/luminous_body.hpp>

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace gonio {

// What a face of a luminous opening emits: the web of the luminaire over the projected area of its body.
struct FaceEmission {
    std::shared_ptr<const LuminousBody> body;
    std::shared_ptr<const Web> web;
    Frame luminaire;
    std::size_t face = 0; // of the body
};

// The body of an opening that a web emits from, which takes some passes over the web, but not its amount: lights of one
// profile share it, and what is made of it.
struct OpeningBody {
    std::shared_ptr<const LuminousBody> body; // nullptr: a dark web
    double behind = 0.0;                      // the share of the flux that leaves through the back of a flat opening
};
using OpeningBodies = std::map<std::pair<const Web*, const Opening*>, OpeningBody>;

// The body of an opening that is not a point.
OpeningBody opening_body(const Opening& opening, const Web& web);

// Gives a resolved light the body of its profile's opening, if its shape asks for one: a known one, or one of its own.
// Says so where an opening is missing, implausibly large, or flat and shone through from behind.
void give_body(Light& light, Diagnostics& diagnostics, const OpeningBodies& known = {});

// As resolve_light() of light.hpp, with bodies that are known.
Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics, const OpeningBodies& known);

// The faces of `light.body`, which must be there, at the light's present position, amount and colour.
std::vector<Light> faces_of(const Light& light);

} // namespace gonio
