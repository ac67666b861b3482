// The luminance of a light by direction, for many directions at once. Internal to the library.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/web/quick_web.hpp>

#include <span>
#include <vector>

namespace gonio {

// The projected areas of a body towards directions (x, y, z) of the luminaire's frame, each times the length of the
// direction [m²]. All spans have the same length.
void projected_areas(const LuminousBody& body, std::span<const double> x, std::span<const double> y,
                     std::span<const double> z, std::span<const double> length, std::span<double> to);

// The web by whose directions a light's luminance is given, that of its luminaire or of its mask, or null; and the
// frame of these directions.
const Web* luminance_web(const Light& light);
const Frame& luminance_frame(const Light& light);

// Light::luminance_share(), in a fifth of the time.
class LuminanceShares {
public:
    // A light that is a face of a luminous opening, or behind a mask with a web. It must outlive this.
    explicit LuminanceShares(const Light& light);

    const Frame& frame() const { return frame_; }
    // Along unit directions of that frame.
    void along(std::span<const double> x, std::span<const double> y, std::span<const double> z, std::span<double> to);

private:
    const LuminousBody* body_; // null for a mask
    double scale_;
    Frame frame_;
    QuickWeb web_;
    std::vector<double> length_, projected_m2_;
};

} // namespace gonio
