#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/sky/detail/environment_charts.hpp>
#include <gonio/sky/detail/sphere_quadrature.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using detail::clipped;
using detail::SphericalPolygon;
using std::numbers::pi;

// The indices of the cells of unit width that the polygon's values reach into.
struct Range {
    double least = 1e300;
    double most = -1e300;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    // Rounding must not open a gap: a cell too many gets a polygon without area.
    [[nodiscard]] std::pair<int, int> cells(int first, int end) const {
        constexpr double rounding = 1e-9;
        return {std::clamp(static_cast<int>(std::floor(least - rounding)), first, end - 1),
                std::clamp(static_cast<int>(std::floor(most + rounding)), first, end - 1)};
    }
};

// A part of a picture in which a direction d lies at the point (u·d/w·d, v·d/w·d): a face or an octant.
struct PlaneChart {
    glm::dvec3 u;
    glm::dvec3 v;
    glm::dvec3 w;
    int first_column;
    int end_column;
    int first_row;
    int end_row;
    std::array<glm::dvec3, 4> inward; // normals of its sides
    std::size_t sides;
};

std::vector<PlaneChart> charts_of(const EnvironmentGrid& grid) {
    std::vector<PlaneChart> charts;
    const double n = grid.side();
    if (grid.layout() == EnvironmentLayout::octahedral) {
        const glm::dvec3 x{1, 0, 0};
        const glm::dvec3 y{0, 1, 0};
        const glm::dvec3 z{0, 0, 1};
        const int half = grid.side() / 2;
        for (const double sx : {-1.0, 1.0})
            for (const double sy : {-1.0, 1.0})
                for (const double sz : {-1.0, 1.0}) {
                    const glm::dvec3 w = sx * x + sy * y + sz * z;
                    // p.x and p.y times w
                    const glm::dvec3 px = sz > 0.0 ? x : sx * (w - sy * y);
                    const glm::dvec3 py = sz > 0.0 ? y : sy * (w - sx * x);
                    const int column = sx < 0.0 ? 0 : half;
                    const int row = sy > 0.0 ? 0 : half;
                    charts.push_back({0.5 * n * (w + px),
                                      0.5 * n * (w - py),
                                      w,
                                      column,
                                      column + half,
                                      row,
                                      row + half,
                                      {sx * x, sy * y, sz * z, glm::dvec3(0.0)},
                                      3});
                }
        return charts;
    }
    for (const detail::CubeFace& face : detail::cube_faces(grid.layout())) {
        const int column = face.column * grid.side();
        const int row = face.row * grid.side();
        charts.push_back(
            {(column + 0.5 * n) * face.middle + 0.5 * n * face.across,
             (row + 0.5 * n) * face.middle + 0.5 * n * face.down,
             face.middle,
             column,
             column + grid.side(),
             row,
             row + grid.side(),
             {face.middle + face.across, face.middle - face.across, face.middle + face.down, face.middle - face.down},
             4});
    }
    return charts;
}

// The slices of a lat-long between two meridians, and the chords that divide them into cells.
class LatLongSlices {
public:
    explicit LatLongSlices(const EnvironmentGrid& grid)
        : rows_(grid.height()),
          per_column_(detail::slices_of(grid)),
          count_(grid.width() * per_column_),
          half_chord_(std::cos(pi / count_)) {
        meridian_.reserve(static_cast<std::size_t>(count_) + 1);
        middle_.reserve(static_cast<std::size_t>(count_));
        for (int k = 0; k <= count_; ++k) {
            const double azimuth = (static_cast<double>(k % count_) / count_ - 0.5) * 2.0 * pi;
            meridian_.emplace_back(std::cos(azimuth), -std::sin(azimuth), 0.0);
            const double between = (static_cast<double>(2 * k + 1) / (2 * count_) - 0.5) * 2.0 * pi;
            if (k < count_) middle_.emplace_back(std::sin(between), std::cos(between), 0.0);
        }
        for (int j = 0; j <= rows_; ++j) {
            const double zenith = j * pi / rows_;
            chord_.push_back({std::sin(zenith) * half_chord_, std::cos(zenith)});
        }
        // The solid angle of a cell over that of its polygon, by row.
        for (int j = 0; j < rows_; ++j) {
            double area = 0.0;
            const detail::TexelPolygons cell = detail::polygons_of(grid, {0, j}, 0, per_column_);
            for (std::size_t i = 0; i < cell.count; ++i)
                area += detail::solid_angle(cell.part.at(i));
            scale_.push_back(grid.solid_angle({0, j}) / (per_column_ * area));
        }
    }

    // visit(texel, area of the overlap as a share of the source texel's light)
    template<class Visit>
    void overlaps(const SphericalPolygon& polygon, const Visit& visit) const {
        const auto [first, last] = slices_across(polygon);
        for (int k = first; k <= last; ++k) {
            const int slice = (k % count_ + count_) % count_;
            const auto at = static_cast<std::size_t>(slice);
            const SphericalPolygon part =
                first == last ? polygon : clipped(clipped(polygon, meridian_[at]), -meridian_[at + 1]);
            if (part.empty()) continue;
            cells_of(part, slice, visit);
        }
    }

private:
    struct Chord {
        double up;     // factor of z in the chord's normal
        double across; // factor of the slice's middle
    };

    // The slices that the polygon reaches into; the last may lie beyond the seam.
    [[nodiscard]] std::pair<int, int> slices_across(const SphericalPolygon& polygon) const {
        glm::dvec3 center(0.0);
        for (std::size_t i = 0; i < polygon.count; ++i)
            center += polygon.vertex.at(i);
        if (surrounds_pole(polygon)) return {0, count_ - 1};
        const double reference = std::atan2(center.x, center.y);
        Range range;
        for (std::size_t i = 0; i < polygon.count; ++i) {
            const glm::dvec3& d = polygon.vertex.at(i);
            if (std::hypot(d.x, d.y) < 1e-12) continue; // the pole itself has every azimuth
            const double azimuth = reference + std::remainder(std::atan2(d.x, d.y) - reference, 2.0 * pi);
            range.add((azimuth / (2.0 * pi) + 0.5) * count_);
        }
        if (range.most < range.least) return {0, count_ - 1};
        return range.cells(-count_, 2 * count_);
    }

    // Whether a pole lies in the polygon or on a side of it, but is no vertex.
    [[nodiscard]] static bool surrounds_pole(const SphericalPolygon& polygon) {
        for (const double pole : {-1.0, 1.0}) {
            bool inside = true;
            int side = 0;
            for (std::size_t i = 0; i < polygon.count && inside; ++i) {
                const glm::dvec3& a = polygon.vertex.at(i);
                const glm::dvec3& b = polygon.vertex.at(i + 1 < polygon.count ? i + 1 : 0);
                if (std::hypot(a.x, a.y) < 1e-12) inside = false;
                const double turn = pole * (a.x * b.y - a.y * b.x); // of the side as seen from the pole
                if (std::abs(turn) < 1e-14) continue;
                const int here = turn > 0.0 ? 1 : -1;
                if (side != 0 && here != side) inside = false;
                side = here;
            }
            if (inside && polygon.vertex.at(0).z * pole > 0.0) return true;
        }
        return false;
    }

    template<class Visit>
    void cells_of(const SphericalPolygon& part, int slice, const Visit& visit) const {
        const glm::dvec3& middle = middle_[static_cast<std::size_t>(slice)];
        Range range;
        for (std::size_t i = 0; i < part.count; ++i) {
            const glm::dvec3& d = part.vertex.at(i);
            range.add(std::atan2(std::fmax(glm::dot(middle, d), 0.0) / half_chord_, d.z) / pi * rows_);
        }
        const auto [first, last] = range.cells(0, rows_);
        const int column = slice / per_column_;
        for (int row = first; row <= last; ++row) {
            const auto at = static_cast<std::size_t>(row);
            SphericalPolygon cell = part;
            if (first != last && row > 0) cell = clipped(cell, chord_[at].across * middle - up_by(chord_[at].up));
            if (first != last && row + 1 < rows_)
                cell = clipped(cell, up_by(chord_[at + 1].up) - chord_[at + 1].across * middle);
            if (!cell.empty()) visit(TexelIndex{column, row}, scale_[at] * detail::solid_angle(cell));
        }
    }
    static glm::dvec3 up_by(double length) { return {0.0, 0.0, length}; }

    int rows_;
    int per_column_;
    int count_;
    double half_chord_;
    std::vector<glm::dvec3> meridian_; // towards growing azimuths
    std::vector<glm::dvec3> middle_;
    std::vector<Chord> chord_; // z·up − across·middle ≥ 0 above it
    std::vector<double> scale_;
};

// visit(texel, area), as above.
template<class Visit>
void overlaps_in(const PlaneChart& chart, const SphericalPolygon& polygon, const Visit& visit) {
    SphericalPolygon inside = polygon;
    for (std::size_t i = 0; i < chart.sides; ++i) {
        bool out = true;
        bool whole = true;
        for (std::size_t k = 0; k < inside.count; ++k) {
            const double side = glm::dot(inside.vertex.at(k), chart.inward.at(i));
            out = out && side <= 0.0;
            whole = whole && side >= 0.0;
        }
        if (out) return;
        if (!whole) inside = clipped(inside, chart.inward.at(i));
    }
    if (inside.empty()) return;
    const auto range_of = [&](const SphericalPolygon& of, const glm::dvec3& axis) {
        Range range;
        for (std::size_t k = 0; k < of.count; ++k)
            range.add(glm::dot(of.vertex.at(k), axis) / glm::dot(of.vertex.at(k), chart.w));
        return range;
    };
    const auto between = [&](const SphericalPolygon& of, const glm::dvec3& axis, int from) {
        return clipped(clipped(of, axis - static_cast<double>(from) * chart.w),
                       static_cast<double>(from + 1) * chart.w - axis);
    };
    const auto [first_column, last_column] = range_of(inside, chart.u).cells(chart.first_column, chart.end_column);
    for (int column = first_column; column <= last_column; ++column) {
        const SphericalPolygon strip = first_column == last_column ? inside : between(inside, chart.u, column);
        if (strip.empty()) continue;
        const auto [first_row, last_row] = range_of(strip, chart.v).cells(chart.first_row, chart.end_row);
        for (int row = first_row; row <= last_row; ++row) {
            const SphericalPolygon cell = first_row == last_row ? strip : between(strip, chart.v, row);
            if (!cell.empty()) visit(TexelIndex{column, row}, detail::solid_angle(cell));
        }
    }
}

template<class Overlaps>
EnvironmentMap gathered(const EnvironmentMap& source, const EnvironmentGrid& to, Radians rotation, unsigned threads,
                        const Overlaps& overlaps) {
    Image image(to.width(), to.height(), 3);
    const int slices = detail::slices_of(to);
    parallel_for(static_cast<std::size_t>(to.height()), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        for (int column = 0; column < to.width(); ++column) {
            const TexelIndex texel{column, row};
            if (!to.covers(texel)) continue;
            glm::dvec3 sum(0.0);
            for (int slice = 0; slice < slices; ++slice) {
                detail::TexelPolygons cell = detail::polygons_of(to, texel, slice, slices);
                for (std::size_t i = 0; rotation.value != 0.0 && i < cell.count; ++i)
                    for (glm::dvec3& vertex : cell.part.at(i).vertex)
                        vertex = turned(vertex, Radians(-rotation.value));
                for (std::size_t i = 0; i < cell.count; ++i)
                    overlaps(cell.part.at(i), [&](TexelIndex from, double area) {
                        const float* const pixel = source.image().at(from.column, from.row);
                        sum += area * glm::dvec3(pixel[0], pixel[1], pixel[2]);
                    });
            }
            const glm::dvec3 mean = sum / to.solid_angle(texel);
            for (int c = 0; c < 3; ++c)
                image.at(column, row)[c] = static_cast<float>(mean[c]);
        }
    });
    return EnvironmentMap::of_valid(to, std::move(image), source.nits_per_unit());
}

// A part of a texel: a bilinear patch of the picture, two of whose corners may be the same.
using Patch = std::array<glm::dvec2, 4>;

struct Sum {
    glm::dvec3 light{0.0};
    double weight = 0.0;

    Sum& operator+=(const Sum& other) {
        light += other.light;
        weight += other.weight;
        return *this;
    }
    [[nodiscard]] glm::dvec3 mean() const { return weight > 0.0 ? light / weight : glm::dvec3(0.0); }
};

class TexelMeans {
public:
    TexelMeans(const Sky& sky, const EnvironmentGrid& grid) : sky_(sky), grid_(grid) {}

    [[nodiscard]] glm::dvec3 operator()(TexelIndex texel) const {
        const double left = texel.column;
        const double top = texel.row;
        const std::array corner{glm::dvec2(left, top), glm::dvec2(left + 1, top), glm::dvec2(left + 1, top + 1),
                                glm::dvec2(left, top + 1)};
        if (grid_.layout() != EnvironmentLayout::octahedral) return refined(corner, 0).mean();
        // Two triangles, either of which has one side of the fold alone, if it crosses the texel.
        const int half = grid_.side() / 2;
        const bool falling = (texel.column < half) != (texel.row < half);
        const Patch a = falling ? Patch{corner[0], corner[1], corner[2], corner[2]}
                                : Patch{corner[1], corner[2], corner[3], corner[3]};
        const Patch b = falling ? Patch{corner[0], corner[2], corner[3], corner[3]}
                                : Patch{corner[0], corner[1], corner[3], corner[3]};
        Sum sum = refined(a, 0);
        sum += refined(b, 0);
        return sum.mean();
    }

private:
    // dω over the area of the picture, up to a factor that is the same for the whole picture.
    [[nodiscard]] double density(const glm::dvec3& d) const {
        switch (grid_.layout()) {
        case EnvironmentLayout::latlong:
            return std::hypot(d.x, d.y);
        case EnvironmentLayout::octahedral:
            return std::pow(std::abs(d.x) + std::abs(d.y) + std::abs(d.z), 3.0);
        default:
            return std::pow(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}), 3.0);
        }
    }

    template<class Rule>
    [[nodiscard]] Sum gauss(const Patch& patch, const Rule& rule) const {
        Sum sum;
        for (const QuadratureNode& across : rule)
            for (const QuadratureNode& down : rule) {
                const double a = 0.5 * (1.0 + across.at);
                const double b = 0.5 * (1.0 + down.at);
                const glm::dvec2 along_a = (1.0 - b) * (patch[1] - patch[0]) + b * (patch[2] - patch[3]);
                const glm::dvec2 along_b = (1.0 - a) * (patch[3] - patch[0]) + a * (patch[2] - patch[1]);
                const double area = std::abs(along_a.x * along_b.y - along_a.y * along_b.x);
                const glm::dvec3 direction = grid_.direction(at(patch, a, b));
                const double weight = across.weight * down.weight * area * density(direction);
                sum.light += weight * sky_.radiance(direction);
                sum.weight += weight;
            }
        return sum;
    }

    static glm::dvec2 at(const Patch& patch, double a, double b) {
        return (1.0 - b) * ((1.0 - a) * patch[0] + a * patch[1]) + b * ((1.0 - a) * patch[3] + a * patch[2]);
    }

    // Two rules that agree are enough: the finer one is far better than their difference.
    [[nodiscard]] Sum refined(const Patch& patch, int depth) const {
        constexpr int deepest = 8;
        constexpr double tolerance = 2e-7;
        static constexpr auto two = gauss_legendre<2>();
        static constexpr auto three = gauss_legendre<3>();
        const Sum coarse = gauss(patch, two);
        const Sum fine = gauss(patch, three);
        const glm::dvec3 mean = fine.mean();
        const double most = std::max({mean.x, mean.y, mean.z});
        const double change = glm::length(mean - coarse.mean());
        if (depth == deepest || !(change > tolerance * most)) return fine;
        const glm::dvec2 middle = at(patch, 0.5, 0.5);
        const std::array edge{at(patch, 0.5, 0.0), at(patch, 1.0, 0.5), at(patch, 0.5, 1.0), at(patch, 0.0, 0.5)};
        const std::array<Patch, 4> quarters{{{patch[0], edge[0], middle, edge[3]},
                                             {edge[0], patch[1], edge[1], middle},
                                             {middle, edge[1], patch[2], edge[2]},
                                             {edge[3], middle, edge[2], patch[3]}}};
        Sum sum;
        for (const Patch& quarter : quarters)
            sum += refined(quarter, depth + 1);
        return sum;
    }

    const Sky& sky_;
    const EnvironmentGrid& grid_;
};

} // namespace

Result<EnvironmentGrid> environment_grid(EnvironmentLayout layout, int side) {
    const EnvironmentLayoutInfo& info = info_of(layout);
    const double values = 3.0 * info.across * info.down * static_cast<double>(side) * side;
    if (side < 1) return fail("USE0106", "an environment has at least one pixel a side", "for example 512");
    if (values > static_cast<double>(limit("environment-values").value))
        return fail("USE0106",
                    fmt::format("an environment of {:.0f}x{:.0f} pixels with three channels has more than {}",
                                static_cast<double>(info.across) * side, static_cast<double>(info.down) * side,
                                to_text(limit("environment-values"))),
                    std::string(limits_hint));
    return EnvironmentGrid::create(layout, info.across * side, info.down * side);
}

EnvironmentMap resampled(const EnvironmentMap& source, const EnvironmentGrid& to, Radians rotation, unsigned threads) {
    if (source.grid().layout() == EnvironmentLayout::latlong) {
        const LatLongSlices slices(source.grid());
        return gathered(source, to, rotation, threads,
                        [&](const SphericalPolygon& cell, const auto& visit) { slices.overlaps(cell, visit); });
    }
    const std::vector<PlaneChart> charts = charts_of(source.grid());
    return gathered(source, to, rotation, threads, [&](const SphericalPolygon& cell, const auto& visit) {
        for (const PlaneChart& chart : charts)
            overlaps_in(chart, cell, visit);
    });
}

EnvironmentMap rendered(const Sky& sky, const EnvironmentGrid& to, unsigned threads) {
    Image image(to.width(), to.height(), 3);
    const TexelMeans means(sky, to);
    parallel_for(static_cast<std::size_t>(to.height()), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        for (int column = 0; column < to.width(); ++column) {
            if (!to.covers({column, row})) continue;
            const glm::dvec3 mean = means({column, row});
            for (int c = 0; c < 3; ++c)
                image.at(column, row)[c] = static_cast<float>(mean[c]);
        }
    });
    return EnvironmentMap::of_valid(to, std::move(image), 1.0);
}

EnvironmentMap environment_of(const Sky& sky, const EnvironmentGrid& to, unsigned threads) {
    if (!sky.image()) return rendered(sky, to, threads);
    const EnvironmentMap& own = *sky.image();
    const bool is_same = own.grid().layout() == to.layout() && own.grid().side() == to.side();
    EnvironmentMap map = is_same && sky.rotation().value == 0.0 ? own : resampled(own, to, sky.rotation(), threads);
    map.set_nits_per_unit(map.nits_per_unit() * sky.image_scale());
    return map;
}

EnvironmentMap with_sun(const EnvironmentMap& map, const SunLight& sun) {
    // Points of equal solid angle on a spiral of the golden angle (H. Vogel, 1979).
    constexpr int points = 1 << 16;
    constexpr double golden_angle = 2.399963229728653;
    const double radius = 0.5 * sun.diameter.value;
    const auto [e, f] = detail::perpendicular(sun.direction);
    const EnvironmentGrid& grid = map.grid();
    // A uniform disc: E = L π sin² r, over 2π (1 − cos r) sr.
    const double cap_height = 2.0 * std::pow(std::sin(0.5 * radius), 2.0);
    const double luminance = sun.illuminance.value / (pi * std::pow(std::sin(radius), 2.0));
    const glm::dvec3 of_point = luminance * 2.0 * pi * cap_height / points / map.nits_per_unit() * sun.color;
    std::map<std::pair<int, int>, int> covered;
    for (int i = 0; i < points; ++i) {
        const double cosine = 1.0 - cap_height * (i + 0.5) / points;
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        const double turn = golden_angle * i;
        const TexelIndex at = grid.texel_at(cosine * sun.direction + sine * (std::cos(turn) * e + std::sin(turn) * f));
        ++covered[{at.row, at.column}];
    }
    Image image = map.image();
    for (const auto& [at, count] : covered) {
        const TexelIndex texel{at.second, at.first};
        const glm::dvec3 added = static_cast<double>(count) / grid.solid_angle(texel) * of_point;
        for (int c = 0; c < 3; ++c)
            image.at(texel.column, texel.row)[c] += static_cast<float>(added[c]);
    }
    return EnvironmentMap::of_valid(grid, std::move(image), map.nits_per_unit());
}

} // namespace gonio
