// The sun in a photograph of the sky, taken out of it as a light of its own.
//
// From the brightest texel a region grows to neighbours that are more than twice as bright as the surroundings, up to
// 3° away. The surroundings are the median of the ring from 3° to 6°. What the region has above them goes to the sun:
// the integral Σ (L − Lb) ∫ ω dω is the sun's illuminance times its direction. So the illuminance of every plane that
// sees the whole region stays as it was.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sun_light.hpp>

#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// An environment parted into a sun and the rest.
struct ExtractedSun {
    EnvironmentMap sky; // the image without it
    SunLight sun;
    std::size_t texels = 0; // of the region
    Steradians region;
};

// Fails (usage) if nothing in the image is twice as bright as its surroundings, or if the region is so large that the
// ring around it is not on the image.
Result<ExtractedSun> extract_sun(const EnvironmentMap& map);

} // namespace gonio
#pragma GCC visibility pop
