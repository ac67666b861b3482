// Layouts of environment images: the directions that each texel covers.
//
// The frame is that of sky_direction.hpp: z up, +Y north, +X east. A point of a picture is (x, y): x columns from the
// left, y rows from the top, so that texel (column, row) covers [column, column+1] × [row, row+1].
//
//   latlong              2:1; the zenith above, north in the middle, east to its right: azimuth (x/W − 1/2)·360°,
//                        zenith angle y/H·180°
//   cube-cross           4:3; up above north; west, north, east, south from the left; down below north. Seen from
//                        inside, as photographed
//   cube-cross-vertical  3:4; the same with south upside down below down
//   cube-strip           6:1; the faces +X −X +Y −Y +Z −Z of a world with Y up (east, west, up, down, south, north) as
//                        OpenGL looks them up, which is mirrored as seen from inside
//   octahedral           1:1; the zenith in the middle, north above, east to the right, the nadir in the corners:
//                        p = (x, y)/(|x|+|y|+|z|), folded to (1−|p.y|, 1−|p.x|) below the horizon; an even size
#pragma once

#include <gonio/base/result.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How a picture covers all directions.
enum class EnvironmentLayout : std::uint8_t { latlong, cube_cross, cube_cross_vertical, cube_strip, octahedral };

// A layout by its name in text.
struct EnvironmentLayoutInfo {
    std::string_view name; // "cube-cross"
    EnvironmentLayout layout;
    int across =
        1; // width and height in sides: of a cube's face, of the height of a lat-long, of the octahedral square
    int down = 1;
    std::string_view summary;          // for lists
    std::string_view texel_convention; // one sentence: which directions a texel covers
};

// All of them, and the one of a layout.
std::span<const EnvironmentLayoutInfo> environment_layouts();
const EnvironmentLayoutInfo& info_of(EnvironmentLayout layout);

// Fails (usage) on an unknown name.
Result<EnvironmentLayout> parse_environment_layout(std::string_view text);

// The layout that has pictures of this ratio. Fails (malformed) if there is none.
Result<EnvironmentLayout> environment_layout_of(int width, int height);

// The size of a texel at the middle of a face or at the horizon, as an angle, is the same for layouts of these sides:
// that of a face times 2 for a lat-long and an octahedral.
int side_like(EnvironmentLayout layout, int side, EnvironmentLayout like);

// A texel of a picture.
struct TexelIndex {
    int column = 0;
    int row = 0;

    friend bool operator==(const TexelIndex&, const TexelIndex&) = default;
};

// A layout at a size. A value without allocations.
class EnvironmentGrid {
public:
    // A single texel for each face of a cube: to be assigned.
    EnvironmentGrid() = default;

    // Fails (malformed) if the layout has no pictures of this size: a ratio that is not its own, an odd octahedral one,
    // fewer than 4 columns of a lat-long.
    static Result<EnvironmentGrid> create(EnvironmentLayout layout, int width, int height);

    [[nodiscard]] EnvironmentLayout layout() const { return layout_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int side() const { return side_; }

    // False for the empty corners of a cross.
    [[nodiscard]] bool covers(TexelIndex texel) const;

    // Unit direction at a point of the picture, which lies in a texel that is covered.
    [[nodiscard]] glm::dvec3 direction(const glm::dvec2& point) const;

    // The point of a direction of any length > 0, and the texel that it lies in.
    [[nodiscard]] glm::dvec2 locate(const glm::dvec3& direction) const;
    [[nodiscard]] TexelIndex texel_at(const glm::dvec3& direction) const;

    // The texel `across` columns and `down` rows away (−1, 0 or 1 each), also over the edge of a face or of the
    // picture: across the seam, the pole, the fold.
    [[nodiscard]] TexelIndex neighbor(TexelIndex texel, int across, int down) const;

    // No direction of a texel is farther from that of its middle: a generous bound [rad].
    [[nodiscard]] double texel_reach() const;

    // [sr]
    [[nodiscard]] double solid_angle(TexelIndex texel) const;

    // ∫ ω dω over the texel: its product with a normal above whose horizon the texel lies is the share of E/L.
    [[nodiscard]] glm::dvec3 direction_integral(TexelIndex texel) const;

    // The same of the part with ω·normal > 0. Texels across the normal's horizon are clipped there; those of a lat-long
    // as polygons, whose parallels are chords.
    [[nodiscard]] glm::dvec3 direction_integral_above(TexelIndex texel, const glm::dvec3& normal) const;

private:
    EnvironmentGrid(EnvironmentLayout layout, int width, int height, int side)
        : layout_(layout), width_(width), height_(height), side_(side) {}

    EnvironmentLayout layout_ = EnvironmentLayout::cube_strip;
    int width_ = 6;
    int height_ = 1;
    int side_ = 1;
};

} // namespace gonio
#pragma GCC visibility pop
