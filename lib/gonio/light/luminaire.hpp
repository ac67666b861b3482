// A measured luminaire with a size as the area lights that its faces are.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/luminous_body.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gonio {

// What a face of a luminous opening emits: the web of the luminaire over the projected area of its body.
struct FaceEmission {
    std::shared_ptr<const LuminousBody> body;
    std::shared_ptr<const Web> web;
    Frame luminaire;
    std::size_t face = 0; // of the body
};

// Gives a resolved light the body of its profile's opening, if its shape asks for one, and the faces that go with it.
// Says so where an opening is missing, implausibly large, or flat and shone through from behind.
void give_body(Light& light, Diagnostics& diagnostics);

// The faces of `light.body` at the light's present position, amount and colour; none without a body.
void place_faces(Light& light);

// The lights of a scene, those with a body replaced by their faces: what casts light and shadows.
class ShiningLights {
public:
    // The lights must outlive this. Without `faces` they stay as they are.
    explicit ShiningLights(std::span<const Light> lights, bool faces = true);

    std::span<const Light> all() const { return has_faces_ ? std::span<const Light>(faces_) : lights_; }

private:
    std::span<const Light> lights_;
    std::vector<Light> faces_;
    bool has_faces_ = false;
};

} // namespace gonio
