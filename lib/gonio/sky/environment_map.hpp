// Environment: an image of the light from all around, calibrated in cd/m².
//
// Pixels are linear Rec.709 floats; a factor makes them cd/m², so that a photograph keeps its numbers and can be
// calibrated. Each texel is uniform over the directions that it covers where light is summed: sums are then exact for
// the image, in any layout. The frame and the layouts are those of environment_layout.hpp. Nothing here depends on the
// number of threads; reading is safe from any thread.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/sky/environment_layout.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Pixels that cannot be light: NaN, infinite or negative.
enum class BadPixels : std::uint8_t {
    error, // the image is refused
    black  // they become 0, with a warning
};

// Half the angle of the spot around the brightest texel.
inline constexpr double spot_radius_deg = 3.0;

// Light from all directions, as a picture in cd/m².
class EnvironmentMap {
public:
    // An image with three channels, linear Rec.709, in which a pixel of Y = 1 has `nits_per_unit` cd/m². Remarks are
    // appended to `diagnostics`: on bad pixels, and on images that look clipped: the greatest value is
    // 65504, where half floats end, or many pixels have it, far above the mean. Fails (malformed) on a size that the
    // layout does not have and on bad pixels, with their number and the place of the first.
    static Result<EnvironmentMap> create(EnvironmentLayout layout, Image image, double nits_per_unit, BadPixels bad,
                                         Diagnostics& diagnostics);

    // Of pixels that are known to be light: three channels, the grid's size.
    static EnvironmentMap of_valid(const EnvironmentGrid& grid, Image image, double nits_per_unit);

    [[nodiscard]] const EnvironmentGrid& grid() const { return grid_; }
    [[nodiscard]] const Image& image() const { return image_; }
    [[nodiscard]] double nits_per_unit() const { return nits_per_unit_; }
    void set_nits_per_unit(double nits) { nits_per_unit_ = nits; }

    // Luminance of a texel, RGB [cd/m²].
    [[nodiscard]] glm::dvec3 texel(TexelIndex index) const;

    // Luminance of a direction of any length > 0, RGB [cd/m²]: bilinear between the centres of texels, continuous over
    // the seam, the poles and the folds of a layout, and within rounding of a texel over the edges of a cube.
    [[nodiscard]] glm::dvec3 radiance(const glm::dvec3& direction) const;

    // Illuminance of open planes with these unit normals, RGB [lx], in one pass. Exact for a horizontal plane and the
    // four walls where the picture's middle lines are edges of texels (an even height, a width that is a multiple of
    // four), else within the clipping of direction_integral_above(). 0 threads: all.
    [[nodiscard]] std::vector<glm::dvec3> irradiance(std::span<const glm::dvec3> normals, unsigned threads = 0) const;
    [[nodiscard]] glm::dvec3 irradiance(const glm::dvec3& normal, unsigned threads = 0) const;

    // ∫ L dω over all directions, RGB [lx]; of the texels with a middle within `radius` of a unit direction.
    [[nodiscard]] glm::dvec3 light(unsigned threads = 0) const;
    [[nodiscard]] glm::dvec3 light_within(const glm::dvec3& direction, Radians radius) const;

    // The texel of the greatest luminance, the first of equals.
    [[nodiscard]] TexelIndex brightest() const;

private:
    EnvironmentMap(const EnvironmentGrid& grid, Image image, double nits_per_unit);

    EnvironmentGrid grid_;
    Image image_;
    double nits_per_unit_;
};

// What a calibration makes of an image.
struct Calibration {
    // The measure that it fixes.
    enum class Of : std::uint8_t { illuminance, mean_luminance, zenith_luminance };
    Of of = Of::illuminance;
    double value = 0.0;               // [lx] or [cd/m²]
    glm::dvec3 normal{0.0, 0.0, 1.0}; // of the plane that the illuminance was measured on
};

// The factor on the image's luminances that gives it that amount. Fails (usage) on an image that is black where it is
// measured, on an amount that is not greater than 0, and above the range of amounts.
Result<double> calibration(const EnvironmentMap& map, const Calibration& to, unsigned threads = 0);

// Multiplies nits_per_unit by it. Fails as calibration() does.
Result<void> calibrate(EnvironmentMap& map, const Calibration& to, unsigned threads = 0);

} // namespace gonio
#pragma GCC visibility pop
