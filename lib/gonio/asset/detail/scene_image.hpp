// Pictures of the images that lights project or show, as targets store them.
//
// Their texels are linear Rec.709 over SceneImage::peak, in [0, 1], with the light's colour and lobe in them: a target
// multiplies them by a white light. Rows run from the top. A projector's picture is upright as the light sees it (right
// is +X of its frame, up is +Y), a panel's as a viewer in front of it sees it (right is −X).
#pragma once

#include <gonio/asset/scene_content.hpp>
#include <gonio/base/image.hpp>
#include <gonio/light/light.hpp>

#include <glm/vec2.hpp>

#include <string>

namespace gonio::asset_detail {

// Of a light with an image.
SceneImage scene_image(const Light& light, std::string name);

// What a projector's picture covers on the plane one unit before it, from −slopes to slopes, by how many texels.
struct Projection {
    glm::dvec2 slopes;
    int width = 0;
    int height = 0;
};

// The spot's square or the frustum, with as many texels as the image has pixels or a multiple: at least 512 on the
// longer side, for lobes, and at most 2048.
Projection projection_of(const SceneImage& image);

// The same of square texels, for programs that know one angle and the sides of the file: the shorter side is exact, the
// longer one a part of a texel longer. `least` on the longer side; more for programs that look up the nearest texel.
Projection square_texels(const SceneImage& image, int least = 512);

// The square around the narrowest cone that contains it, and the half angle of that cone [rad].
double cone_of(const SceneImage& image);
Projection square_around_cone(const SceneImage& image, double cone_rad);

// Intensities in the directions of the texels; 0 outside of the light.
Image projected_picture(const SceneImage& image, const Projection& projection);

// Luminances of the places of the texels, one for each pixel of the image.
Image panel_picture(const SceneImage& image);

} // namespace gonio::asset_detail
