// Layouts: the direction at each point of a texture.
//
// A layout is one or more charts, each a rectangle of texels with a smooth or piecewise smooth map of the unit square
// to directions of the light's frame (aim −Z, C0 +X, C90 +Y). In a chart s runs along the columns, left to right, and t
// along the rows, top to bottom, both from 0 to 1.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// Which directions the texels of a picture cover.
enum class Layout {
    latlong,               // C across, γ down
    v180,                  // γ across, one row: the mean over C; more rows: C down
    octahedral,            // the aim in the middle, its opposite in the corners
    octahedral_equal_area, // the same with texels of equal solid angle (P. Clarberg, Fast equal-area mapping, 2008)
    cube_strip,            // faces +X −X +Y −Y +Z −Z side by side
    cube_cross,            // the same unfolded, 4 × 3 faces
    cube,                  // the same strip, for six files
    gnomonic,              // a plane across the aim: a cookie
    panorama               // longitude and latitude about +Y, the aim in the middle
};
// For loops over all of them.
inline constexpr Layout last_layout = Layout::panorama;

// In texels.
struct TextureSize {
    int width = 0;
    int height = 0;
};

// How a layout's width and height follow from its side: a face of a cube, the height of a map of the sphere.
struct LayoutShape {
    int across = 1;        // sides
    int down = 1;          // sides; 0: one row
    bool bordered = false; // surrounded by the border of the options
};

// A layout by its name, as `gonio list layouts` shows it.
struct LayoutInfo {
    Layout layout;
    std::string_view name;    // "octahedral-equal-area"
    std::string_view summary; // for lists
    LayoutShape shape;
    int usual_side;                    // when no size is requested
    std::string_view texel_convention; // one sentence: which directions a texel covers
};

// The size of a layout with that many texels per side.
TextureSize size_of_side(const LayoutInfo& layout, int side, int border = 0);

// All of them, and the one of a layout.
std::span<const LayoutInfo> layouts();
const LayoutInfo& info_of(Layout layout);

// Fails (usage) on an unknown name.
Result<Layout> parse_layout(std::string_view text);

// A direction of any length > 0 and its derivatives along the chart.
struct ChartPoint {
    glm::dvec3 direction;
    glm::dvec3 along_s;
    glm::dvec3 along_t;
};

// The map of one square of a layout to directions, both ways.
class Chart {
public:
    virtual ~Chart() = default;
    [[nodiscard]] virtual ChartPoint at(double s, double t) const = 0;

    // The place of a direction of any length > 0; nothing if it is not in this chart.
    [[nodiscard]] virtual std::optional<glm::dvec2> locate(const glm::dvec3& direction) const = 0;

    // Whether s = 0 and s = 1 are the same directions.
    [[nodiscard]] virtual bool wraps() const { return false; }

    // Appends the places between `from` and `to` at which a line of constant t (`along_s`) or of constant s is not
    // smooth.
    virtual void folds(bool along_s, double fixed, double from, double to, std::vector<double>& at) const;

    // Whether there is any such place.
    [[nodiscard]] virtual bool folds_between(bool along_s, double fixed, double from, double to) const;

    // Distance from (s, t) to the nearest point around which the map is not a power series; folds do not count.
    [[nodiscard]] virtual double smooth_within(double s, double t) const;

    // Solid angle of the whole chart [sr].
    [[nodiscard]] virtual double solid_angle() const;

protected:
    Chart() = default;
    Chart(const Chart&) = default;
    Chart& operator=(const Chart&) = default;
};

// A chart and its position in the picture.
struct PlacedChart {
    std::shared_ptr<const Chart> chart;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

// What some layouts need besides their size.
struct LayoutOptions {
    Radians cone = degrees(90.0); // gnomonic: full angle from edge to edge, in (0°, 180°)
    int border = 0;               // gnomonic: width of the dark border
    // The layout's frame in that of the light: the columns are its x, y and z there. Orthogonal; may mirror.
    glm::dmat3 turned{1.0};
};

// The charts of a picture of that size. Fails (usage) on a size that the layout cannot have: an octahedral or gnomonic
// texture must be square, a strip 6:1, a cross 4:3, and the border must leave at least one texel.
Result<std::vector<PlacedChart>> charts_of(Layout layout, int width, int height, const LayoutOptions& options);

} // namespace gonio
#pragma GCC visibility pop
