#include <gonio/bake/layout.hpp>
#include <gonio/base/named.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr std::array infos{
    LayoutInfo{Layout::latlong,
               "latlong",
               "C across and gamma down, the aim in the first row",
               {2, 1},
               256,
               "column i covers C in [i, i+1]/width*360 deg, row j covers gamma in [j, j+1]/height*180 deg, first row "
               "at gamma = 0 (nadir); a texel holds the mean over its solid angle"},
    LayoutInfo{
        Layout::v180,
        "v180",
        "gamma across; one row holds the mean over C, more rows run over C",
        {1, 0},
        256,
        "column i covers gamma in [i, i+1]/width*180 deg, first column at gamma = 0 (nadir), row j covers C in [j, "
        "j+1]/height*360 deg; a texel holds the mean over its solid angle"},
    LayoutInfo{Layout::octahedral,
               "octahedral",
               "square, the aim in the middle, its opposite in the corners",
               {1, 1},
               256,
               "p = (x, y)/(|x|+|y|+|z|), for z > 0 folded to (1-|p.y|, 1-|p.x|) with the signs of x and y; column i "
               "covers p.x in [i, i+1]/width*2-1, row j covers p.y in 1-[j, j+1]/height*2; a texel holds the mean over "
               "its solid angle"},
    LayoutInfo{Layout::octahedral_equal_area,
               "octahedral-equal-area",
               "the octahedral layout with texels of equal solid angle",
               {1, 1},
               256,
               "r = sqrt(1-|z|), phi = atan2(|y|, |x|)*2/pi, p = (r - r*phi, r*phi), for z > 0 folded to (1-p.y, "
               "1-p.x), with the signs of x and y; column i covers p.x in [i, i+1]/width*2-1, row j covers p.y in "
               "1-[j, j+1]/height*2; a texel holds the mean over its solid angle"},
    LayoutInfo{Layout::cube_strip,
               "cube-strip",
               "cube faces +X -X +Y -Y +Z -Z side by side",
               {6, 1},
               128,
               "faces +X -X +Y -Y +Z -Z from the left, each as OpenGL looks it up; a texel holds the mean over its "
               "solid angle"},
    LayoutInfo{Layout::cube_cross,
               "cube-cross",
               "cube faces unfolded, 4 x 3",
               {4, 3},
               128,
               "faces +Y above, -X +Z +X -Z, -Y below, each as OpenGL looks it up; a texel holds the mean over its "
               "solid angle, texels of no face are 0"},
    LayoutInfo{
        Layout::cube,
        "cube",
        "six files, one for each cube face",
        {6, 1},
        128,
        "face +X -X +Y -Y +Z or -Z as its file's name says, each as OpenGL looks it up; a texel holds the mean over "
        "its solid angle"},
    LayoutInfo{Layout::gnomonic,
               "gnomonic",
               "a plane across the aim: a cookie for a spot light",
               {1, 1, true},
               256,
               "p = (x, y)/-z/tan(cone/2); inside the border columns run from p.x = -1 to 1, rows from p.y = 1 down to "
               "-1; a texel holds the mean over its solid angle, the border is 0"},
    LayoutInfo{Layout::panorama,
               "panorama",
               "longitude and latitude about +Y, the aim in the middle",
               {2, 1},
               256,
               "column i covers atan2(x, -z) in [i, i+1]/width*360-180 deg, row j covers asin(y) in 90-[j, "
               "j+1]/height*180 deg; a texel holds the mean over its solid angle"},
};
static_assert(in_enum_order(infos, &LayoutInfo::layout, last_layout));

double sign_of(double value) {
    return value < 0.0 ? -1.0 : 1.0;
}

// Appends `at` if it lies strictly between the ends.
void add_between(double at, double from, double to, std::vector<double>& cuts) {
    if (at > from && at < to) cuts.push_back(at);
}

// The place in an octahedral chart of a direction; (a, b) is its point in the lower half, without signs.
glm::dvec2 octahedral_place(const glm::dvec3& direction, double a, double b) {
    const bool away = direction.z > 0.0;
    const double u = sign_of(direction.x) * (away ? 1.0 - b : a);
    const double v = sign_of(direction.y) * (away ? 1.0 - a : b);
    return {0.5 * (1.0 + u), 0.5 * (1.0 - v)};
}

// Both octahedral maps fold at p = 0 on either axis and, where they cross the horizon, at |p.x| + |p.y| = 1.
class OctahedralChart : public Chart {
public:
    void folds(bool /*along_s*/, double fixed, double from, double to, std::vector<double>& at) const override {
        const double level = std::abs(2.0 * fixed - 1.0);
        add_between(0.5 * level, from, to, at); // p = −(1 − level)
        add_between(0.5, from, to, at);
        add_between(1.0 - 0.5 * level, from, to, at);
    }
    [[nodiscard]] bool folds_between(bool /*along_s*/, double fixed, double from, double to) const override {
        const double level = std::abs(2.0 * fixed - 1.0);
        for (const double at : {0.5 * level, 0.5, 1.0 - 0.5 * level})
            if (at > from && at < to) return true;
        return false;
    }
};

class Octahedral final : public OctahedralChart {
public:
    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const double u = 2.0 * s - 1.0;
        const double v = 1.0 - 2.0 * t;
        const double su = sign_of(u);
        const double sv = sign_of(v);
        const double height = std::abs(u) + std::abs(v) - 1.0; // z
        const glm::dvec3 z_of{0.0, 0.0, 1.0};
        if (height <= 0.0)
            return {{u, v, height}, 2.0 * (glm::dvec3(1, 0, 0) + su * z_of), -2.0 * (glm::dvec3(0, 1, 0) + sv * z_of)};
        return {{(1.0 - std::abs(v)) * su, (1.0 - std::abs(u)) * sv, height},
                2.0 * glm::dvec3(0.0, -su * sv, su),
                -2.0 * glm::dvec3(-sv * su, 0.0, sv)};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
        return octahedral_place(d, std::abs(d.x) / sum, std::abs(d.y) / sum);
    }
};

class OctahedralEqualArea final : public OctahedralChart {
public:
    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const double u = 2.0 * s - 1.0;
        const double v = 1.0 - 2.0 * t;
        const double su = sign_of(u);
        const double sv = sign_of(v);
        double a = std::abs(u);
        double b = std::abs(v);
        const bool away = a + b > 1.0; // above the horizon: folded
        // The derivatives of a and b by |u| and |v|.
        glm::dvec2 a_of{1.0, 0.0};
        glm::dvec2 b_of{0.0, 1.0};
        if (away) {
            const double folded = 1.0 - b;
            b = 1.0 - a;
            a = folded;
            a_of = {0.0, -1.0};
            b_of = {-1.0, 0.0};
        }
        const double r = a + b;
        const double phi = r > 0.0 ? 0.5 * pi * b / r : 0.0;
        const double c = std::cos(phi);
        const double q = std::sin(phi);
        const double root = std::sqrt(2.0 - r * r);
        const double sine = r * root; // of the angle to the nearer pole
        const double z = away ? 1.0 - r * r : r * r - 1.0;
        const auto along = [&](double da, double db) {
            const double dr = da + db;
            const double turned = r > 0.0 ? 0.5 * pi * (a * db - b * da) / r * root : 0.0; // sine · dφ
            const double d_sine = dr * (root - r * r / root);
            const double dz = (away ? -2.0 : 2.0) * r * dr;
            return glm::dvec3(su * (d_sine * c - turned * q), sv * (d_sine * q + turned * c), dz);
        };
        return {{su * sine * c, sv * sine * q, z}, 2.0 * su * along(a_of.x, b_of.x), -2.0 * sv * along(a_of.y, b_of.y)};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        // r² = 1 − |z| of the unit direction, as a quotient that does not cancel.
        const double length = glm::length(d);
        const double across = d.x * d.x + d.y * d.y;
        const double r = std::sqrt(across / (length * (length + std::abs(d.z))));
        const double b = across > 0.0 ? r * std::atan2(std::abs(d.y), std::abs(d.x)) * 2.0 / pi : 0.0;
        return octahedral_place(d, r - b, b);
    }
    // In the middle and at the corners, where the poles are, the map is a cone.
    [[nodiscard]] double smooth_within(double s, double t) const override {
        const double across = std::abs(s - 0.5);
        const double down = std::abs(t - 0.5);
        return std::min(std::hypot(across, down), std::hypot(0.5 - across, 0.5 - down));
    }
};

// A rectangle of a plane: middle + (2s − 1) right + (1 − 2t) up; the vectors are orthogonal, the middle has unit
// length.
class Plane final : public Chart {
public:
    Plane(glm::dvec3 middle, glm::dvec3 right, glm::dvec3 up) : middle_(middle), right_(right), up_(up) {}

    [[nodiscard]] ChartPoint at(double s, double t) const override {
        return {middle_ + (2.0 * s - 1.0) * right_ + (1.0 - 2.0 * t) * up_, 2.0 * right_, -2.0 * up_};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        const double ahead = glm::dot(d, middle_);
        if (!(ahead > 0.0)) return std::nullopt;
        const double u = glm::dot(d, right_) / glm::dot(right_, right_) / ahead;
        const double v = glm::dot(d, up_) / glm::dot(up_, up_) / ahead;
        if (std::abs(u) > 1.0 || std::abs(v) > 1.0) return std::nullopt;
        return glm::dvec2(0.5 * (1.0 + u), 0.5 * (1.0 - v));
    }
    [[nodiscard]] double solid_angle() const override {
        const double u = glm::length(right_);
        const double v = glm::length(up_);
        return 4.0 * std::atan2(u * v, std::sqrt(1.0 + u * u + v * v));
    }

private:
    glm::dvec3 middle_;
    glm::dvec3 right_;
    glm::dvec3 up_;
};

class Panorama final : public Chart {
public:
    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const double longitude = 2.0 * pi * (s - 0.5);
        const double latitude = pi * (0.5 - t);
        const double cl = std::cos(longitude);
        const double sl = std::sin(longitude);
        const double cb = std::cos(latitude);
        const double sb = std::sin(latitude);
        return {{cb * sl, sb, -cb * cl},
                2.0 * pi * glm::dvec3(cb * cl, 0.0, cb * sl),
                -pi * glm::dvec3(-sb * sl, cb, sb * cl)};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        const double latitude = std::atan2(d.y, std::hypot(d.x, d.z));
        return glm::dvec2(0.5 + std::atan2(d.x, -d.z) / (2.0 * pi), 0.5 - latitude / pi);
    }
    [[nodiscard]] bool wraps() const override { return true; }
};

class Latlong final : public Chart {
public:
    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const double c = 2.0 * pi * s;
        const double gamma = pi * t;
        const double cos_c = std::cos(c);
        const double sin_c = std::sin(c);
        const double cos_g = std::cos(gamma);
        const double sin_g = std::sin(gamma);
        return {{sin_g * cos_c, sin_g * sin_c, -cos_g},
                2.0 * pi * glm::dvec3(-sin_g * sin_c, sin_g * cos_c, 0.0),
                pi * glm::dvec3(cos_g * cos_c, cos_g * sin_c, sin_g)};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        const double turns = std::atan2(d.y, d.x) / (2.0 * pi);
        return glm::dvec2(turns < 0.0 ? turns + 1.0 : turns, std::atan2(std::hypot(d.x, d.y), -d.z) / pi);
    }
    [[nodiscard]] bool wraps() const override { return true; }
};

// Rings of γ across, the full circle of C down.
class V180 final : public Chart {
public:
    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const ChartPoint point = Latlong().at(t, s);
        return {point.direction, point.along_t, point.along_s};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        const glm::dvec2 place = *Latlong().locate(d);
        return glm::dvec2(place.y, place.x);
    }
};

// Another chart, turned or mirrored.
class Turned final : public Chart {
public:
    Turned(std::shared_ptr<const Chart> chart, const glm::dmat3& turned) : chart_(std::move(chart)), turned_(turned) {}

    [[nodiscard]] ChartPoint at(double s, double t) const override {
        const ChartPoint point = chart_->at(s, t);
        return {turned_ * point.direction, turned_ * point.along_s, turned_ * point.along_t};
    }
    [[nodiscard]] std::optional<glm::dvec2> locate(const glm::dvec3& d) const override {
        return chart_->locate(d * turned_); // by the transpose
    }
    [[nodiscard]] bool wraps() const override { return chart_->wraps(); }
    void folds(bool along_s, double fixed, double from, double to, std::vector<double>& at) const override {
        chart_->folds(along_s, fixed, from, to, at);
    }
    [[nodiscard]] bool folds_between(bool along_s, double fixed, double from, double to) const override {
        return chart_->folds_between(along_s, fixed, from, to);
    }
    [[nodiscard]] double smooth_within(double s, double t) const override { return chart_->smooth_within(s, t); }
    [[nodiscard]] double solid_angle() const override { return chart_->solid_angle(); }

private:
    std::shared_ptr<const Chart> chart_;
    glm::dmat3 turned_;
};

// The face of an OpenGL cube map with its middle on the axis; s and t as OpenGL looks them up.
std::shared_ptr<const Chart> cube_face(std::size_t face) {
    using glm::dvec3;
    switch (face) {
    case 0:
        return std::make_shared<Plane>(dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, 1, 0));
    case 1:
        return std::make_shared<Plane>(dvec3(-1, 0, 0), dvec3(0, 0, 1), dvec3(0, 1, 0));
    case 2:
        return std::make_shared<Plane>(dvec3(0, 1, 0), dvec3(1, 0, 0), dvec3(0, 0, -1));
    case 3:
        return std::make_shared<Plane>(dvec3(0, -1, 0), dvec3(1, 0, 0), dvec3(0, 0, 1));
    case 4:
        return std::make_shared<Plane>(dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(0, 1, 0));
    default:
        return std::make_shared<Plane>(dvec3(0, 0, -1), dvec3(-1, 0, 0), dvec3(0, 1, 0));
    }
}

// The position of each face, in faces.
using FacePlaces = std::array<std::array<int, 2>, 6>;
constexpr FacePlaces strip_places{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}};
constexpr FacePlaces cross_places{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};

Unexpected size_refused(Layout layout, int width, int height, const char* wanted, int example_width,
                        int example_height) {
    return fail("USE0106", fmt::format("the layout {} is {}, not {}x{}", info_of(layout).name, wanted, width, height),
                fmt::format("for example -s {}x{}", example_width, example_height));
}

Result<std::vector<PlacedChart>> cube(Layout layout, int width, int height, int across, int down,
                                      const FacePlaces& places) {
    const int face = height / down;
    if (width != across * face || height != down * face)
        return size_refused(layout, width, height, fmt::format("{} by {} square faces", across, down).c_str(),
                            across * 128, down * 128);
    std::vector<PlacedChart> charts;
    for (std::size_t i = 0; i < places.size(); ++i)
        charts.push_back({cube_face(i), places[i][0] * face, places[i][1] * face, face, face});
    return charts;
}

std::vector<PlacedChart> one(std::shared_ptr<const Chart> chart, int border, int width, int height) {
    std::vector<PlacedChart> charts(1);
    charts[0] = {std::move(chart), border, border, width, height};
    return charts;
}

template<class Map>
std::vector<PlacedChart> whole(int width, int height) {
    return one(std::make_shared<Map>(), 0, width, height);
}

} // namespace

std::span<const LayoutInfo> layouts() {
    return infos;
}

const LayoutInfo& info_of(Layout layout) {
    return infos[static_cast<std::size_t>(layout)];
}

TextureSize size_of_side(const LayoutInfo& layout, int side, int border) {
    const LayoutShape& shape = layout.shape;
    const int around = shape.bordered ? 2 * border : 0;
    return {shape.across * side + around, shape.down == 0 ? 1 : shape.down * side + around};
}

Result<Layout> parse_layout(std::string_view text) {
    return find_named("layout", text, infos).map([](const LayoutInfo* known) { return known->layout; });
}

void Chart::folds(bool /*along_s*/, double /*fixed*/, double /*from*/, double /*to*/,
                  std::vector<double>& /*at*/) const {}

bool Chart::folds_between(bool /*along_s*/, double /*fixed*/, double /*from*/, double /*to*/) const {
    return false;
}

double Chart::smooth_within(double /*s*/, double /*t*/) const {
    return 1.0;
}

double Chart::solid_angle() const {
    return 4.0 * pi;
}

namespace {

Result<std::vector<PlacedChart>> upright_charts(Layout layout, int width, int height, const LayoutOptions& options) {
    switch (layout) {
    case Layout::octahedral:
    case Layout::octahedral_equal_area:
        if (width != height) return size_refused(layout, width, height, "square", 256, 256);
        if (layout == Layout::octahedral) return whole<Octahedral>(width, height);
        return whole<OctahedralEqualArea>(width, height);
    case Layout::cube:
    case Layout::cube_strip:
        return cube(layout, width, height, 6, 1, strip_places);
    case Layout::cube_cross:
        return cube(layout, width, height, 4, 3, cross_places);
    case Layout::panorama:
        return whole<Panorama>(width, height);
    case Layout::gnomonic: {
        if (width != height) return size_refused(layout, width, height, "square", 256, 256);
        const int inside = width - 2 * options.border;
        if (options.border < 0 || inside < 1)
            return fail("USE0106",
                        fmt::format("a border of {} texels leaves no texel of {}x{}", options.border, width, height));
        if (!(options.cone.value > 0.0 && options.cone.value < pi))
            return fail("USE0106", fmt::format("a plane shows a cone of more than 0deg and less than 180deg, not {}deg",
                                               to_degrees(options.cone)));
        const double reach = std::tan(0.5 * options.cone.value);
        return one(std::make_shared<Plane>(glm::dvec3(0, 0, -1), glm::dvec3(reach, 0, 0), glm::dvec3(0, reach, 0)),
                   options.border, inside, inside);
    }
    case Layout::latlong:
        return whole<Latlong>(width, height);
    case Layout::v180:
        return whole<V180>(width, height);
    }
    return fail(Failure::internal, "a layout without charts");
}

} // namespace

Result<std::vector<PlacedChart>> charts_of(Layout layout, int width, int height, const LayoutOptions& options) {
    Result<std::vector<PlacedChart>> charts = upright_charts(layout, width, height, options);
    if (charts && options.turned != glm::dmat3(1.0))
        for (PlacedChart& placed : *charts)
            placed.chart = std::make_shared<Turned>(std::move(placed.chart), options.turned);
    return charts;
}

} // namespace gonio
