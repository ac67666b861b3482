// Sky: a description, resolved once into what a renderer asks.
//
// The frame is that of scenes and of sky_direction.hpp: z up, +Y north, +X east. Directions point from the receiver to
// the sky. Luminances are linear Rec.709 in cd/m², so that their Y is the luminance. The sun of `daylight` is a light
// of its own, which no function but sun() includes. Everything is computed in double and may be called from any
// thread; radiance() does not allocate.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/sky/cie_sky.hpp>
#include <gonio/sky/environment_map.hpp>
#include <gonio/sky/sky_description.hpp>
#include <gonio/sky/sun_light.hpp>

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Light from all around: uniform, a CIE sky, or an image; with the sun, if it has one.
class Sky {
public:
    // None.
    Sky() = default;
    // From every direction.
    explicit Sky(Nits uniform, const glm::dvec3& color = glm::dvec3(1.0));

    // Of a unit direction: the luminance of the sky there, RGB; of the ground below the horizon; of an image bilinear.
    glm::dvec3 radiance(const glm::dvec3& direction) const;

    // Of an open plane with a unit normal, RGB [lx]; without the sun. In closed form for a uniform sky, by quadrature
    // to 1e-8 in about a millisecond for others; an image is summed, in about 0.1 µs a texel. 0 threads: all.
    glm::dvec3 irradiance(const glm::dvec3& normal, unsigned threads = 0) const;

    // The same of several planes, once for each different normal: one pass over the pixels of an image.
    std::vector<glm::dvec3> irradiance(std::span<const glm::dvec3> normals, unsigned threads = 0) const;

    // Luminances: of the zenith, and the mean over the sky's solid angle (SkyMeasure::mean).
    Nits zenith() const;
    Nits mean(unsigned threads = 0) const;

    // ∫ L dω over all directions, RGB [lx]: the scalar illuminance of a point, four times that of a sphere's surface.
    glm::dvec3 light(unsigned threads = 0) const;

    // No light from anywhere, but for the sun.
    bool is_dark() const { return !(scale_ > 0.0); }

    const std::optional<SunLight>& sun() const { return sun_; }

    // Of the analytic sky, nothing for a uniform one: its axis is where texels need most care.
    const std::optional<CieSky>& cie() const { return cie_; }

    // Of an image sky: the pixels, the factor on their luminances, and the rotation of sky_direction.hpp.
    const std::shared_ptr<const EnvironmentMap>& image() const { return image_; }
    double image_scale() const { return scale_; }
    Radians rotation() const { return rotation_; }

private:
    friend Result<Sky> resolve_sky(const SkyDescription& description, std::shared_ptr<const EnvironmentMap> image,
                                   unsigned threads);

    std::vector<glm::dvec3> irradiance_of_each(std::vector<glm::dvec3> normals, unsigned threads) const;

    std::optional<CieSky> cie_;
    glm::dvec3 color_{1.0};
    double scale_ = 0.0;  // [cd/m²] of the zenith; of all directions of a uniform sky; of an image a factor
    double ground_ = 0.0; // [cd/m²] below the horizon
    std::optional<SunLight> sun_;
    std::shared_ptr<const EnvironmentMap> image_;
    Radians rotation_;
};

// An image sky needs the image of its file. Fails (usage) if the sun of `daylight` is not above the horizon, if the sky
// is dark where its amount is measured, and above the range of amounts. An image is summed up on `threads`, 0: all.
Result<Sky> resolve_sky(const SkyDescription& description, std::shared_ptr<const EnvironmentMap> image = nullptr,
                        unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
