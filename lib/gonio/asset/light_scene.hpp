// LightScene: placed lights as one file of a target, with the files that it reads.
//
// Each light becomes one of the target's own kind if the target has it. Otherwise the replacement is reported with the
// name of the light:
//   a shape that the target lacks   a measured profile of its intensity in every direction, as from far away
//                                   (a sphere: a point of the same intensity)
//   a spot of another falloff       the same: a profile of its lobe
//   a two-sided disk or rectangle   two lights back to back
//   a mask on an area light         treated as a shape that the target lacks, unless its area lights take profiles
//   an image as a mask              the same without projectors or textured rectangles: without its colours, and its
//                                   details are lost beyond half a degree
//   a luminous opening              without area lights that take profiles left out: a point, with the distance from
//                                   which that is good to 1 %
//   a range                         left out if the target has no such window
//   a sky                           left out if the target stores none
// Flux and intensity are those of the light in all these cases. World: right-handed, Z up, metres; each target's writer
// converts to its axes and lengths.
#pragma once

#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/sky_picture.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/light/light.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The files of a rig's lights for a target.
struct LightScene {
    std::vector<AssetFile> files;
    std::vector<std::string> instead; // "light 'key': a disk is …", in the order of the lights; often empty
};

// How light_scene() writes.
struct LightSceneOptions {
    std::string name;                // of the files: letters, digits, '_' and '-'
    std::string description;         // for a comment in them: "12 lights of studio.json"
    Meters unit{1.0};                // length of the target's unit; see check_unit()
    const SkyPicture* sky = nullptr; // if there is one
    bool photometric = false;        // usd: with the schemas of UsdLux' proposal for lumens and lux
};

// Files are named NAME.…, those of the profiles NAME.LIGHT.…, that of a sky NAME.sky.… (or the next free name); lights
// with the same profile, amount and colour share one. Without lights there must be a sky. Fails (unsupported) when the
// target cannot express a light at all, or neither a light nor the sky, and as check_light_count() does, (usage) as
// check_unit() does.
Result<LightScene> light_scene(const Target& target, std::span<const Light> lights, const LightSceneOptions& options);

// A single luminaire, at the origin and aimed down, C0 along +X.
Result<LightScene> light_scene(const Target& target, const MeasuredLight& light, Meters unit = Meters(1.0),
                               bool photometric = false);

// Fails (unsupported) on more lights than the limit import-lights. A caller that checks before it resolves the lights
// saves that work.
Result<void> check_light_count(std::size_t lights);

// Fails (usage) on a unit outside [1e-4 m, 1e4 m], and if the target's lengths are fixed to another unit.
Result<void> check_unit(const Target& target, Meters unit);

} // namespace gonio
#pragma GCC visibility pop
