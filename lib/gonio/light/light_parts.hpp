// Lights that consist of several: the faces of a luminous opening, and the three colours of an image.
//
// Code that adds up light works on the parts, each of which has one colour and one luminance by place or by direction.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/light_image.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

namespace gonio {

// image_solid_angle() of a coloured image before a shape, by luminance and by colour: computed once, when a coloured
// light first asks. Safe to call from any thread.
class ImageSolidAngles {
public:
    struct Values {
        double luminance_sr = 0.0;
        std::array<double, 3> color_sr{}; // 0: there is none of this colour
    };
    // `image` and `shape` are the same in all calls.
    const Values& of(const Shape& shape, const LightImage& image) const;

private:
    mutable std::once_flag once_;
    mutable Values values_;
};

// Gives a light its parts at its present position, amount and colour; none to a light that is one. The flux of
// the colours of an image together is that of the light, whatever its own colour. Fails (usage) on a colour of which
// the image has nothing.
Result<void> place_parts(Light& light);

// The luminance that lights[index], an area light, shows where the ray from `viewer` along `toward` meets it, RGB [nt].
// The colours of one image, which follow each other in `lights`, are shown together by the first of them.
glm::dvec3 shown_luminance(std::span<const Light> lights, std::size_t index, const glm::dvec3& viewer,
                           const glm::dvec3& toward);

// The lights of a scene, in place of each its parts if it has any: what casts light and shadows.
class ShiningLights {
public:
    // The lights must outlive this. Without `faces` a luminaire with an opening stays one light.
    explicit ShiningLights(std::span<const Light> lights, bool faces = true);

    std::span<const Light> all() const { return has_parts_ ? std::span<const Light>(parts_) : lights_; }

private:
    std::span<const Light> lights_;
    std::vector<Light> parts_;
    bool has_parts_ = false;
};

} // namespace gonio
