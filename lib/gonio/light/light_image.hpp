// Images that lights project or show: a gobo or cookie before a spot or a frustum, the picture on a panel.
//
// As a mask, an image multiplies a light by its pixels over the greatest luminance among them. Pixels are linear
// Rec.709; a coloured image colours the light.
//
// Projected by a spot or a frustum: the plane one metre before the light, upright as the light sees it: right is +X and
// up is +Y of its frame. It covers the frustum, or the square around the cone. Bilinear between the centres of pixels.
//
// On a rectangle: upright as a viewer in front of it sees it, so right is −X; a two-sided one shows it reversed behind.
// Each pixel is a uniform rectangle, so that sums over pixels are exact.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/shape.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// One channel of an image, from 0 to 1 at its brightest pixel. Coordinates are (0, 0) at the top left corner of the
// image and (1, 1) at the bottom right one.
class ImagePlane {
public:
    // Values ≥ 0 and finite, rows from top to bottom, at least one of them > 0.
    ImagePlane(int width, int height, std::vector<float> values);

    int width() const { return width_; }
    int height() const { return height_; }
    // Row by row, width × height.
    const std::vector<float>& pixels() const { return pixels_; }
    // The factor that made the brightest pixel 1 was one over this.
    double peak() const { return peak_; }
    // Of all pixels.
    double mean() const { return mean_; }

    // Bilinear between the centres of pixels; beyond the outermost centres, the value there.
    double smooth(glm::dvec2 at) const;
    // The pixel at the place, the nearest one outside of the image.
    double pixel(glm::dvec2 at) const;
    // Over the rectangle between two corners, low ≤ high, clipped to the image; a rectangle without an area is pixel().
    // The first call takes as long as a pass over the image; safe to call from any thread.
    double mean(glm::dvec2 low, glm::dvec2 high) const;

private:
    void sum_up() const;
    double sum_before(double column, double row) const; // of the pixels left of and above a place, in parts of pixels

    int width_;
    int height_;
    std::vector<float> pixels_;
    double peak_;
    double mean_;
    // Of all pixels before a corner, (width + 1) × (height + 1): made when a mean is first asked for.
    mutable std::once_flag summed_up_;
    mutable std::vector<double> sums_;
};

// Of one of the colours red, green and blue in a coloured image.
struct ImageColor {
    std::shared_ptr<const ImagePlane> plane; // nullptr: there is none of this colour
    double share = 0.0;                      // luminance of its brightest pixel over that of the whole image
};

// An image before a light: its luminance, and the colours of a coloured one.
class LightImage {
public:
    // One or three channels, linear Rec.709. Fails (malformed) on pixels that are negative or not finite, with the
    // place of the first, and on an image that is black.
    static Result<LightImage> create(const Image& image);

    const std::shared_ptr<const ImagePlane>& luminance() const { return luminance_; }
    bool is_colored() const { return is_colored_; }
    // Red, green, blue; only of a coloured image.
    const std::array<ImageColor, 3>& colors() const { return colors_; }

private:
    std::shared_ptr<const ImagePlane> luminance_;
    bool is_colored_ = false;
    std::array<ImageColor, 3> colors_;
};

// Whether a file of this name is taken as an image and not as a profile: by its extension.
bool names_image(std::string_view file);

// What load_profile() reads images with: this room opens no picture files. Without a reader an image as a mask fails
// (unsupported). Safe to call from any thread; gonio/media/light_image_file.hpp has the reader.
using LightImageReader = Result<LightImage> (*)(const std::string& file, Diagnostics& diagnostics);
void set_light_image_reader(LightImageReader reader);
Result<LightImage> read_light_image(const std::string& file, Diagnostics& diagnostics);

// Half of the width and the height that an image covers on the plane one metre before a spot or a frustum [m]; 0 for
// other shapes.
glm::dvec2 covered_by_image(const Shape& shape);

// The share of the intensity along the axis that an image before or on a light lets through towards a direction of the
// light's frame (axis −Z) of any length > 0: of a projected one its value there, 0 outside of the spot's square or the
// frustum; of one on a rectangle its mean, as from far away.
double image_share(const Shape& shape, const ImagePlane& image, const glm::dvec3& direction);

// The place on a rectangle's image of a point at x along its width and y along its height from its centre [m].
glm::dvec2 place_on(const RectShape& rect, double x_m, double y_m);

// Φ over the intensity along the axis before the image, as masked_solid_angle(): of a frustum 1e-6, of a spot 1e-5 for
// images of some hundred pixels a side, of a rectangle exact; 0 for shapes that take no image.
Steradians image_solid_angle(const Shape& shape, const ImagePlane& image);

} // namespace gonio
#pragma GCC visibility pop
