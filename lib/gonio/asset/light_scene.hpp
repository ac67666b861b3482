// LightScene: placed lights as one file of a target, with the files that it reads.
//
// Each light becomes the target's own where that has one of the kind; of the rest, what it does instead is said by
// name:
//   a shape that a target has not   a measured profile of its intensity in every direction, as from far away
//                                   (a sphere: a point of the same intensity)
//   a spot of another falloff       the same: a profile of its lobe
//   a two-sided disk or rectangle   two lights back to back
//   a mask on an area               as a shape that the target has not
//   a range                         left out where the target has no such window
// Flux and intensity are those of the light in all of them. World: right-handed, Z up, metres; a target's own
// axes and lengths are its writer's affair.
#pragma once

#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/light/light.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gonio {

struct LightScene {
    std::vector<AssetFile> files;
    std::vector<std::string> instead; // "light 'key': a disk is …", in the order of the lights; often empty
};

struct LightSceneOptions {
    std::string name;        // of the files: letters, digits, '_' and '-'
    std::string description; // for a comment in them: "12 lights of studio.json"
    Meters unit{1.0};        // length of the target's unit; see check_unit()
};

// Files are named NAME.…, those of the profiles NAME.LIGHT.…; lights of the same profile, amount and colour share one.
// Fails (unsupported) when a light cannot be said to the target at all and as check_light_count() does, (usage) as
// check_unit() does.
Result<LightScene> light_scene(const Target& target, std::span<const Light> lights, const LightSceneOptions& options);

// A luminaire alone, at the origin and shining down, C0 along +X.
Result<LightScene> light_scene(const Target& target, const MeasuredLight& light, Meters unit = Meters(1.0));

// Fails (unsupported) on more lights than the limit import-lights: what asks before it resolves them saves the work.
Result<void> check_light_count(std::size_t lights);

// Fails (usage) where the target's lengths are fixed, and not this one.
Result<void> check_unit(const Target& target, Meters unit);

} // namespace gonio
