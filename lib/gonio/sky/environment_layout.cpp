#include <gonio/base/named.hpp>
#include <gonio/sky/detail/environment_charts.hpp>
#include <gonio/sky/environment_layout.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr std::array infos{
    EnvironmentLayoutInfo{
        "latlong", EnvironmentLayout::latlong, 2, 1,
        "latitude and longitude, 2:1: the zenith above, north in the middle, east to its right",
        "column i covers azimuths ([i, i+1]/width-1/2)*360 deg, from north over east, row j covers zenith angles [j, "
        "j+1]/height*180 deg; a texel holds the mean over its solid angle"},
    EnvironmentLayoutInfo{"cube-cross", EnvironmentLayout::cube_cross, 4, 3,
                          "cube faces unfolded, 4:3: up above north, west, north, east and south, down below north",
                          "faces up above, west, north, east and south from the left, down below, as seen from inside; "
                          "up and down adjoin "
                          "north; a texel holds the mean over its solid angle, texels of no face are 0"},
    EnvironmentLayoutInfo{
        "cube-cross-vertical", EnvironmentLayout::cube_cross_vertical, 3, 4,
        "the same, 3:4: south upside down below down",
        "faces up above, west, north and east from the left, down below north, south upside down below down, as seen "
        "from inside; a texel holds the mean over its solid angle, texels of no face are 0"},
    EnvironmentLayoutInfo{"cube-strip", EnvironmentLayout::cube_strip, 6, 1,
                          "cube faces +X -X +Y -Y +Z -Z of a world with Y up, 6:1, as OpenGL looks them up",
                          "faces +X -X +Y -Y +Z -Z from the left, each as OpenGL looks it up in a world with X = east, "
                          "Y = up, Z = south; "
                          "a texel holds the mean over its solid angle"},
    EnvironmentLayoutInfo{
        "octahedral", EnvironmentLayout::octahedral, 1, 1,
        "square: the zenith in the middle, north above, the nadir in the corners",
        "p = (x, y)/(|x|+|y|+|z|), for z < 0 folded to (1-|p.y|, 1-|p.x|) with the signs of x and y; column i covers "
        "p.x in [i, i+1]/width*2-1, row j covers p.y in 1-[j, j+1]/height*2; a texel holds the mean over its solid "
        "angle"},
};
static_assert(in_enum_order(infos, &EnvironmentLayoutInfo::layout, EnvironmentLayout::octahedral));

constexpr glm::dvec3 east{1, 0, 0};
constexpr glm::dvec3 north{0, 1, 0};
constexpr glm::dvec3 up{0, 0, 1};
using detail::CubeFace;

constexpr std::array<CubeFace, 6> cross{{{up, east, north, 1, 0},
                                         {-east, north, -up, 0, 1},
                                         {north, east, -up, 1, 1},
                                         {east, -north, -up, 2, 1},
                                         {-north, -east, -up, 3, 1},
                                         {-up, east, -north, 1, 2}}};
constexpr std::array<CubeFace, 6> vertical_cross{{{up, east, north, 1, 0},
                                                  {-east, north, -up, 0, 1},
                                                  {north, east, -up, 1, 1},
                                                  {east, -north, -up, 2, 1},
                                                  {-up, east, -north, 1, 2},
                                                  {-north, east, up, 1, 3}}};
constexpr std::array<CubeFace, 6> strip{{{east, north, -up, 0, 0},
                                         {-east, -north, -up, 1, 0},
                                         {up, east, -north, 2, 0},
                                         {-up, east, north, 3, 0},
                                         {-north, east, -up, 4, 0},
                                         {north, -east, -up, 5, 0}}};

double sign_of(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

bool is_cube(EnvironmentLayout layout) {
    return layout != EnvironmentLayout::latlong && layout != EnvironmentLayout::octahedral;
}

// Not normalised: linear in (u, v) = p within an octant.
glm::dvec3 octahedral_direction(double u, double v) {
    const double height = 1.0 - std::abs(u) - std::abs(v);
    if (height >= 0.0) return {u, v, height};
    return {(1.0 - std::abs(v)) * sign_of(u), (1.0 - std::abs(u)) * sign_of(v), height};
}

glm::dvec3 latlong_direction(const EnvironmentGrid& grid, double x, double y) {
    const double azimuth = (x / grid.width() - 0.5) * 2.0 * pi;
    const double zenith = y / grid.height() * pi;
    return {std::sin(azimuth) * std::sin(zenith), std::cos(azimuth) * std::sin(zenith), std::cos(zenith)};
}

// The bounds of a lat-long texel.
struct LatLongCell {
    double azimuth_from;
    double azimuth_to;
    double zenith_from;
    double zenith_to;

    LatLongCell(const EnvironmentGrid& grid, TexelIndex texel)
        : azimuth_from((static_cast<double>(texel.column) / grid.width() - 0.5) * 2.0 * pi),
          azimuth_to((static_cast<double>(texel.column + 1) / grid.width() - 0.5) * 2.0 * pi),
          zenith_from(static_cast<double>(texel.row) / grid.height() * pi),
          zenith_to(static_cast<double>(texel.row + 1) / grid.height() * pi) {}

    double solid_angle() const {
        return (azimuth_to - azimuth_from) * 2.0 * std::sin(0.5 * (zenith_from + zenith_to)) *
               std::sin(0.5 * (zenith_to - zenith_from));
    }
    glm::dvec3 direction_integral() const {
        const double width = zenith_to - zenith_from;
        const double middle = zenith_from + zenith_to;
        const double flat = 0.5 * (width - std::sin(width) * std::cos(middle)); // ∫ sin² dθ
        const double turn = azimuth_to - azimuth_from;
        // x is sin of the azimuth and y its cosine.
        const double azimuth = 0.5 * (azimuth_from + azimuth_to);
        const double chord = 2.0 * std::sin(0.5 * turn);
        return {flat * chord * std::sin(azimuth), flat * chord * std::cos(azimuth),
                0.5 * turn * std::sin(middle) * std::sin(width)};
    }
};

glm::dvec2 octahedral_place(const glm::dvec3& d) {
    const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
    const double u = d.x / sum;
    const double v = d.y / sum;
    if (d.z >= 0.0) return {u, v};
    return {(1.0 - std::abs(v)) * sign_of(u), (1.0 - std::abs(u)) * sign_of(v)};
}

int index_in(double at, int count) {
    return std::clamp(static_cast<int>(std::floor(at)), 0, count - 1);
}

} // namespace

std::span<const EnvironmentLayoutInfo> environment_layouts() {
    return infos;
}

const EnvironmentLayoutInfo& info_of(EnvironmentLayout layout) {
    return infos.at(static_cast<std::size_t>(layout));
}

Result<EnvironmentLayout> parse_environment_layout(std::string_view text) {
    return find_named("layout", text, infos).map([](const auto* row) { return row->layout; });
}

Result<EnvironmentLayout> environment_layout_of(int width, int height) {
    for (const EnvironmentLayoutInfo& info : infos)
        if (static_cast<std::int64_t>(width) * info.down == static_cast<std::int64_t>(height) * info.across)
            return info.layout;
    return fail(Failure::malformed, fmt::format("{}x{} pixels are not an environment of any layout", width, height),
                "a latlong is 2:1, a cube-cross 4:3, a cube-cross-vertical 3:4, a cube-strip 6:1, an octahedral 1:1");
}

int side_like(EnvironmentLayout layout, int side, EnvironmentLayout like) {
    // A face spans 90°, the height of a lat-long 180°, the diagonal half of an octahedral square 90°.
    const int of_face = is_cube(layout) ? side : (side + 1) / 2;
    return is_cube(like) ? of_face : 2 * of_face;
}

Result<EnvironmentGrid> EnvironmentGrid::create(EnvironmentLayout layout, int width, int height) {
    const EnvironmentLayoutInfo& info = info_of(layout);
    const int side = height / info.down;
    if (side < 1 || width != side * info.across || height != side * info.down)
        return fail(Failure::malformed,
                    fmt::format("an environment in the layout {} is {}:{}, not {}x{} pixels", info.name, info.across,
                                info.down, width, height),
                    fmt::format("for example {}x{}", 256 * info.across, 256 * info.down));
    if (layout == EnvironmentLayout::octahedral && side % 2 != 0)
        return fail(Failure::malformed,
                    fmt::format("an octahedral environment has an even size, not {}x{} pixels", width, height));
    if (layout == EnvironmentLayout::latlong && width < 4)
        return fail(Failure::malformed,
                    fmt::format("a latlong environment has at least 4 columns, not {}x{} pixels", width, height));
    return EnvironmentGrid(layout, width, height, side);
}

bool EnvironmentGrid::covers(TexelIndex texel) const {
    return !is_cube(layout_) || detail::face_of(layout_, side_, texel) != nullptr;
}

glm::dvec3 EnvironmentGrid::direction(const glm::dvec2& point) const {
    if (layout_ == EnvironmentLayout::latlong) return latlong_direction(*this, point.x, point.y);
    if (layout_ == EnvironmentLayout::octahedral)
        return glm::normalize(octahedral_direction(2.0 * point.x / side_ - 1.0, 1.0 - 2.0 * point.y / side_));
    const CubeFace* const face =
        detail::face_of(layout_, side_, {index_in(point.x, width_), index_in(point.y, height_)});
    if (face == nullptr) return up;
    const double s = 2.0 * (point.x / side_ - face->column) - 1.0;
    const double t = 2.0 * (point.y / side_ - face->row) - 1.0;
    return glm::normalize(face->middle + s * face->across + t * face->down);
}

glm::dvec2 EnvironmentGrid::locate(const glm::dvec3& direction) const {
    if (layout_ == EnvironmentLayout::latlong) {
        const double azimuth = std::atan2(direction.x, direction.y);
        const double zenith = std::atan2(std::hypot(direction.x, direction.y), direction.z);
        return {(azimuth / (2.0 * pi) + 0.5) * width_, zenith / pi * height_};
    }
    if (layout_ == EnvironmentLayout::octahedral) {
        const glm::dvec2 p = octahedral_place(direction);
        return {0.5 * (1.0 + p.x) * side_, 0.5 * (1.0 - p.y) * side_};
    }
    const auto& faces = detail::cube_faces(layout_);
    const CubeFace* best = faces.data();
    for (const CubeFace& face : faces)
        if (glm::dot(direction, face.middle) > glm::dot(direction, best->middle)) best = &face;
    const double depth = glm::dot(direction, best->middle);
    const double s = std::clamp(glm::dot(direction, best->across) / depth, -1.0, 1.0);
    const double t = std::clamp(glm::dot(direction, best->down) / depth, -1.0, 1.0);
    // Within the face, also at its right and lower edges.
    const auto within = [&](double at, int cell) {
        return std::min(cell * static_cast<double>(side_) + 0.5 * (1.0 + at) * side_,
                        std::nextafter((cell + 1.0) * side_, 0.0));
    };
    return {within(s, best->column), within(t, best->row)};
}

TexelIndex EnvironmentGrid::texel_at(const glm::dvec3& direction) const {
    const glm::dvec2 point = locate(direction);
    return {index_in(point.x, width_), index_in(point.y, height_)};
}

TexelIndex EnvironmentGrid::neighbor(TexelIndex texel, int across, int down) const {
    TexelIndex next{texel.column + across, texel.row + down};
    switch (layout_) {
    case EnvironmentLayout::latlong:
        if (next.row < 0 || next.row >= height_) { // over the pole
            next.row = std::clamp(next.row, 0, height_ - 1);
            next.column += width_ / 2;
        }
        next.column = (next.column + 2 * width_) % width_;
        return next;
    case EnvironmentLayout::octahedral:
        if (next.row < 0 || next.row >= side_) {
            next.row = std::clamp(next.row, 0, side_ - 1);
            next.column = side_ - 1 - next.column;
        }
        if (next.column < 0 || next.column >= side_) {
            next.column = std::clamp(next.column, 0, side_ - 1);
            next.row = side_ - 1 - next.row;
        }
        return next;
    default: {
        const CubeFace* const face = detail::face_of(layout_, side_, texel);
        if (face == nullptr) return texel;
        const double s = 2.0 * ((next.column + 0.5) / side_ - face->column) - 1.0;
        const double t = 2.0 * ((next.row + 0.5) / side_ - face->row) - 1.0;
        if (std::abs(s) < 1.0 && std::abs(t) < 1.0) return next;
        return texel_at(face->middle + s * face->across + t * face->down);
    }
    }
}

double EnvironmentGrid::texel_reach() const {
    return 4.0 * pi / side_;
}

double EnvironmentGrid::solid_angle(TexelIndex texel) const {
    if (layout_ == EnvironmentLayout::latlong) return LatLongCell(*this, texel).solid_angle();
    const detail::TexelPolygons parts = detail::polygons_of(*this, texel);
    double sum = 0.0;
    for (std::size_t i = 0; i < parts.count; ++i)
        sum += detail::solid_angle(parts.part.at(i));
    return sum;
}

glm::dvec3 EnvironmentGrid::direction_integral(TexelIndex texel) const {
    if (layout_ == EnvironmentLayout::latlong) return LatLongCell(*this, texel).direction_integral();
    const detail::TexelPolygons parts = detail::polygons_of(*this, texel);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < parts.count; ++i)
        sum += detail::direction_integral(parts.part.at(i));
    return sum;
}

glm::dvec3 EnvironmentGrid::direction_integral_above(TexelIndex texel, const glm::dvec3& normal) const {
    const glm::dvec3 middle = direction({texel.column + 0.5, texel.row + 0.5});
    const double height = glm::dot(middle, normal);
    if (height >= texel_reach()) return direction_integral(texel);
    if (height <= -texel_reach()) return glm::dvec3(0.0);
    glm::dvec3 sum(0.0);
    bool all = true;
    const int slices = detail::slices_of(*this);
    for (int slice = 0; slice < slices; ++slice) {
        const detail::TexelPolygons parts = detail::polygons_of(*this, texel, slice, slices);
        for (std::size_t i = 0; i < parts.count; ++i) {
            const detail::SphericalPolygon& part = parts.part.at(i);
            for (std::size_t k = 0; k < part.count; ++k)
                all = all && glm::dot(part.vertex.at(k), normal) >= -1e-15;
            sum += detail::direction_integral(detail::clipped(part, normal));
        }
    }
    return all ? direction_integral(texel) : sum;
}

namespace detail {

const std::array<CubeFace, 6>& cube_faces(EnvironmentLayout layout) {
    if (layout == EnvironmentLayout::cube_strip) return strip;
    return layout == EnvironmentLayout::cube_cross_vertical ? vertical_cross : cross;
}

const CubeFace* face_of(EnvironmentLayout layout, int side, TexelIndex texel) {
    const int column = texel.column / side;
    const int row = texel.row / side;
    for (const CubeFace& face : cube_faces(layout))
        if (face.column == column && face.row == row) return &face;
    return nullptr;
}

int slices_of(const EnvironmentGrid& grid) {
    constexpr int least = 2048;
    return grid.layout() == EnvironmentLayout::latlong ? (least + grid.width() - 1) / grid.width() : 1;
}

TexelPolygons polygons_of(const EnvironmentGrid& grid, TexelIndex texel, int slice, int slices) {
    TexelPolygons parts;
    const auto add = [&](const std::array<glm::dvec3, 4>& corners) {
        SphericalPolygon& part = parts.part.at(parts.count++);
        for (const glm::dvec3& corner : corners)
            if (part.count == 0 || corner != part.vertex.at(part.count - 1)) part.add(corner);
        while (part.count > 1 && part.vertex.at(part.count - 1) == part.vertex.at(0))
            --part.count; // a triangle at the pole
    };
    const double left = texel.column;
    const double top = texel.row;
    switch (grid.layout()) {
    case EnvironmentLayout::latlong: {
        const double from = left + static_cast<double>(slice) / slices;
        // The last slice ends where the next texel begins, to the last digit.
        const double to = slice + 1 == slices ? left + 1.0 : left + static_cast<double>(slice + 1) / slices;
        const auto corner = [&](double x, double y) {
            if (y == 0.0) return up;
            if (y == grid.height()) return -up;
            return latlong_direction(grid, x == grid.width() ? 0.0 : x, y);
        };
        add({corner(from, top), corner(to, top), corner(to, top + 1.0), corner(from, top + 1.0)});
        break;
    }
    case EnvironmentLayout::octahedral: {
        const int half = grid.side() / 2;
        const auto corner = [&](int column, int row) {
            return glm::normalize(octahedral_direction(static_cast<double>(column - half) / half,
                                                       static_cast<double>(half - row) / half));
        };
        const int c = texel.column;
        const int r = texel.row;
        const std::array corners{corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)};
        // The fold |p.x| + |p.y| = 1 runs along a diagonal of the texels that it crosses.
        const auto on_fold = [&](int column, int row) {
            return std::abs(column - half) + std::abs(half - row) == half;
        };
        if (on_fold(c, r) && on_fold(c + 1, r + 1)) {
            add({corners[0], corners[1], corners[2], corners[2]});
            add({corners[0], corners[2], corners[3], corners[3]});
        } else if (on_fold(c + 1, r) && on_fold(c, r + 1)) {
            add({corners[1], corners[2], corners[3], corners[3]});
            add({corners[0], corners[1], corners[3], corners[3]});
        } else {
            add(corners);
        }
        break;
    }
    default: {
        const CubeFace* const face = face_of(grid.layout(), grid.side(), texel);
        if (face == nullptr) return parts;
        const int n = grid.side();
        const auto corner = [&](int column, int row) {
            const double s = static_cast<double>(2 * (column - face->column * n) - n) / n;
            const double t = static_cast<double>(2 * (row - face->row * n) - n) / n;
            return glm::normalize(face->middle + s * face->across + t * face->down);
        };
        const int c = texel.column;
        const int r = texel.row;
        add({corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)});
        break;
    }
    }
    return parts;
}

} // namespace detail

} // namespace gonio
