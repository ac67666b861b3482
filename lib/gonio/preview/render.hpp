// The preview: lights on a stage, as a picture in scene-linear luminance.
//
// Noise-free: every pixel is an exact evaluation of the lights at its surface point; pixels on outlines and hard shadow
// edges are the mean of 4×4 such points. Soft shadows are integrated along lines over the light (README.md). Tiles run
// on all threads; the picture does not depend on their number. Work that cannot change the picture is skipped;
// README.md describes what is skipped and what that saves.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/preview/partial_light.hpp>
#include <gonio/preview/render_stats.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/lighting_options.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Greatest width and height of a picture.
inline constexpr int max_picture_size = static_cast<int>(limit("picture-side").value);

class Interreflection;

// How a picture is rendered.
struct RenderOptions : LightingOptions {
    int width = 512;
    int height = 512;
    bool skip = true;         // false: evaluates every light at every point, even if it cannot reach the point
    bool shows_sky = false;   // where the camera sees nothing else; without its sun
    bool shows_lights = true; // those with a size, themselves
    // Relative to the direct light of each pixel, in every channel and in lux: how far it may be from the picture
    // without this, where that is faster (README.md); 0 changes nothing. Not for the method `reference`.
    double error = 0.0;
    // Rendering::indirect of a picture of the same surfaces in any materials: what depends on these alone is not
    // computed again.
    std::shared_ptr<const Interreflection> known;
};

// A picture in cd/m², and what there is to say about it.
struct Rendering {
    // Three channels, linear Rec.709, in cd/m². Includes lights with a size where the camera sees them.
    Image luminance_nt;
    // One channel: the illuminance of the visible surface from all lights; 0 where the pixel shows a light or nothing.
    // Empty unless requested.
    Image illuminance_lx;
    // For each pixel: 1 if it shows a light itself, even in only a part of it, else 0.
    std::vector<std::uint8_t> shows_light;
    // For each pixel: 1 if its middle shows a subject of the stage, else 0.
    std::vector<std::uint8_t> shows_subject;
    // Pixels that show a light in a part of them, in cd/m²; in the order of the pixels. Not of a reference_picture().
    std::vector<PartialLight> partial_lights;
    // The light that bounces; null without bounces, and of a reference_picture().
    std::shared_ptr<const Interreflection> indirect;
    RenderStats stats;
};

// A light with a size behind a mask uses the mask from its centre (scene/MEASURED.md has the error), except by
// `reference`, which integrates it. Fails (usage) as check_picture_size() does and on a light with a luminance or
// intensity that is not finite, and on a closed stage that absorbs nothing if all bounces are asked for.
Result<Rendering> render(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                         const RenderOptions& options = {});

} // namespace gonio
#pragma GCC visibility pop
