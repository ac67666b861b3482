// SkyPicture: a sky for the files of targets, computed once for all of them: a uniform luminance, or a picture of the
// light from all around.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sun_light.hpp>

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace gonio {

// A sky as targets get it.
struct SkyPicture {
    // A lat-long with an even height: means over texels, without the sun. No pixel is above 65504, which engines store
    // as half floats. Nothing: uniform.
    std::shared_ptr<const EnvironmentMap> image;
    Nits uniform;
    glm::dvec3 color{1.0};       // of the uniform luminance: linear Rec.709 of luminance 1
    Lux horizontal;              // of an open plane that faces up, without the sun
    std::optional<SunLight> sun; // that of the sky: the caller makes a light of it
    std::string source;          // the sky as the user named it, for sidecars
    std::string source_sha256;   // of the image that it was read from
};

// The picture has the texels of an image sky, and 1024x512 for others, which keeps the illuminance of a plane within
// 1e-4. `source` and `source_sha256` are left empty. 0 threads: all. Fails (usage) if an image of another layout
// becomes larger than the limit environment-values as a lat-long.
Result<SkyPicture> sky_picture(const Sky& sky, unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
