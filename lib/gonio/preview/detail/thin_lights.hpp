// Lights that a picture shows narrower than its pixels. Rays through pixels would meet them by chance; here the part of
// each pixel that their outlines cover is computed.
#pragma once

#include <gonio/preview/detail/seen_rays.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// A rectangle of whole pixels.
struct PixelArea {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
};

class ThinLights {
public:
    // What is thin: a light with a surface of its own, or a surface of the stage that emits.
    struct Thing {
        bool is_surface = false;
        std::uint32_t number = 0;
        std::vector<glm::dvec2> outline; // convex, in pixels of the picture
        double widening = 1.0;           // its width times this is a pixel or more; of a dot, its area
    };

    // Takes the thin ones out of the numbers of lights and surfaces that an area of a picture may show, and lights that
    // turn their dark side to the eye, which it does not.
    ThinLights(const RayScene& scene, const PixelArea& area, std::vector<std::uint32_t>& lights,
               std::vector<std::uint32_t>& surfaces);

    // A thing in a pixel: the part of the pixel that its outline covers, and points spread evenly over that part.
    static constexpr std::size_t points_of_part = 16;
    struct Part {
        int x = 0;
        int y = 0;
        std::uint32_t thing = 0;
        double share = 0.0; // of the pixel
        std::array<glm::dvec2, points_of_part> points{};
    };
    // By rows, pixels and things. What is in front of a thing is not subtracted.
    std::span<const Part> parts() const { return parts_; }
    const Thing& thing(const Part& part) const { return things_[part.thing]; }

private:
    void add(Thing thing, const PixelArea& area);

    std::vector<Thing> things_;
    std::vector<Part> parts_;
};

} // namespace gonio::detail
