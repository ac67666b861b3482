#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/preview/glare.hpp>
#include <gonio/shading/falloff.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace gonio {

namespace {

using Vec = glm::dvec3;

constexpr double degree = std::numbers::pi / 180.0;

// The equation's angles, in degrees.
constexpr double core_deg = 0.0046;
constexpr double skirt_deg = 0.045;
constexpr double halo_deg = 0.1;

constexpr double square(double x) {
    return x * x;
}

// ∫ over the disk of radius r of the terms (1 + (θ/a)²)^(−3/2), ^(−1) and ^(−1/2), in degrees².
double steep_within(double r, double a) {
    return 2.0 * std::numbers::pi * square(a) * (1.0 - 1.0 / std::sqrt(1.0 + square(r / a)));
}
double middle_within(double r, double a) {
    return std::numbers::pi * square(a) * std::log1p(square(r / a));
}
double flat_within(double r, double a) {
    return 2.0 * std::numbers::pi * square(a) * (std::sqrt(1.0 + square(r / a)) - 1.0);
}

// The spread of light about its middle: the mean of x xᵀ, a symmetric matrix.
struct Spread2 {
    double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, xz = 0.0, yz = 0.0;

    void add(double weight, const Vec& from_middle) {
        const Vec& v = from_middle;
        add(weight, Spread2{v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z});
    }
    void add(double weight, const Spread2& other) {
        xx += weight * other.xx;
        yy += weight * other.yy;
        zz += weight * other.zz;
        xy += weight * other.xy;
        xz += weight * other.xz;
        yz += weight * other.yz;
    }
    double trace() const { return xx + yy + zz; }
    double along(const Vec& v) const {
        return xx * v.x * v.x + yy * v.y * v.y + zz * v.z * v.z +
               2.0 * (xy * v.x * v.y + xz * v.x * v.z + yz * v.y * v.z);
    }
};

// k = f(θ) cosθ and its derivatives by c = 2 (1 − cosθ), the square of the chord between two directions: 128 values for
// each power of two, linear between them, which is within 1e-4 of k.
class ByChord {
public:
    explicit ByChord(const GlareFunction& glare) : values_((octaves << steps_bits) + 1) {
        const auto k = [&](double chord2) {
            const double angle = 2.0 * std::asin(std::min(0.5 * std::sqrt(chord2), 1.0));
            return glare.per_sr(angle) * (1.0 - 0.5 * chord2);
        };
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const auto chord2 = __builtin_bit_cast(double, (std::uint64_t{i} << drop) + least_bits);
            const double step = 1e-3 * chord2; // of central differences
            const double below = k(chord2 - step);
            const double here = k(chord2);
            const double above = k(chord2 + step);
            values_[i] = {here, (above - below) / (2.0 * step), (above - 2.0 * here + below) / square(step)};
        }
    }

    // At one point.
    double at(double chord2) const {
        if (!(chord2 < 2.0)) return 0.0; // beyond 90° nothing falls on the pupil
        const Place place(chord2);
        const double before = values_[place.index].k;
        return before + place.between * (values_[place.index + 1].k - before);
    }

    // The mean over light spread about its middle, to second order: E k(|d − e|²) = k + k′ tr C + 2 k″ dᵀC d.
    double mean(const Vec& to, const Spread2& spread) const {
        const double chord2 = glm::dot(to, to);
        if (!(chord2 < 2.0)) return 0.0;
        const Place place(chord2);
        const Value& before = values_[place.index];
        const Value& after = values_[place.index + 1];
        const auto between = [&](double Value::*member) {
            return before.*member + place.between * (after.*member - before.*member);
        };
        return std::max(between(&Value::k) + between(&Value::slope) * spread.trace() +
                            2.0 * between(&Value::bend) * spread.along(to),
                        0.0);
    }

private:
    static constexpr int steps_bits = 7;
    static constexpr int drop = 52 - steps_bits;
    static constexpr double least = 0x1p-44; // a chord of 1e-5 degrees; k is flat there
    static constexpr std::uint64_t least_bits = __builtin_bit_cast(std::uint64_t, least);
    static constexpr std::size_t octaves = 45; // to c = 2

    struct Value {
        double k;
        double slope;
        double bend;
    };
    struct Place {
        std::size_t index;
        double between; // it and the next, in [0, 1)

        explicit Place(double chord2) {
            const std::uint64_t bits = __builtin_bit_cast(std::uint64_t, std::max(chord2, least)) - least_bits;
            index = static_cast<std::size_t>(bits >> drop);
            between = static_cast<double>(bits & ((std::uint64_t{1} << drop) - 1)) * 0x1p-45;
        }
    };

    std::vector<Value> values_;
};

// The directions of a picture's pixels.
class PixelRays {
public:
    PixelRays(const Camera& camera, const Image& picture) : rays_(camera, picture.width, picture.height) {}

    // Through a point of the picture, in pixels.
    Vec at(double x, double y) const { return rays_.ray(x, y).direction; }
    Vec middle(int column, int row) const { return at(column + 0.5, row + 0.5); }
    double solid_angle(int column, int row) const {
        return glm::length(glm::cross(across(column, row), down(column, row)));
    }
    // Along the sides of a pixel, through its middle.
    Vec across(int column, int row) const { return at(column + 1.0, row + 0.5) - at(column, row + 0.5); }
    Vec down(int column, int row) const { return at(column + 0.5, row + 1.0) - at(column + 0.5, row); }

private:
    CameraRays rays_;
};

// The share of a pixel's light that stays in it: in triangles from its middle, each in closed form along its rays.
double share_in_pixel(const GlareFunction& glare, const Vec& across, const Vec& down) {
    static constexpr auto rule = gauss_legendre<8>();
    const double area = glm::length(glm::cross(across, down));
    double sum = 0.0;
    for (const QuadratureNode& node : rule)
        for (const Vec& to_side : {across + node.at * down, down + node.at * across}) {
            const double length = glm::length(to_side);
            sum += node.weight * glare.share_within(0.5 * length) / square(length);
        }
    return sum * area / std::numbers::pi;
}

// A pixel that is brighter than white, or a group of them.
struct Source {
    Vec middle{0.0}; // of its light
    Vec lux{0.0};    // of the excess, at an eye that looks there; one for each channel
    Spread2 spread;
    double radius = 0.0;     // chord to the farthest corner
    std::int32_t column = 0; // in cells of its level
    std::int32_t row = 0;
    std::uint32_t first = 0; // of a group: its members in the level below
    std::uint32_t count = 0;

    double weight() const { return lux.x + lux.y + lux.z; }
};

// Sources in cells of 2^level pixels; level 0 holds the pixels. Cells that share a cell of the next level are
// neighbours.
using Level = std::vector<Source>;

// Bits of the column and the row in turn: cells of every size are contiguous in this order.
std::uint64_t interleaved(std::int32_t column, std::int32_t row) {
    std::uint64_t key = 0;
    for (unsigned bit = 0; bit < 31; ++bit) {
        key |= (static_cast<std::uint64_t>(column) >> bit & 1U) << (2 * bit);
        key |= (static_cast<std::uint64_t>(row) >> bit & 1U) << (2 * bit + 1);
    }
    return key;
}

Level groups_of(const Level& below) {
    Level groups;
    for (std::uint32_t i = 0; i < below.size(); ++i) {
        const Source& member = below[i];
        const std::int32_t column = member.column / 2;
        const std::int32_t row = member.row / 2;
        if (groups.empty() || groups.back().column != column || groups.back().row != row) {
            Source& group = groups.emplace_back();
            group.column = column;
            group.row = row;
            group.first = i;
        }
        Source& group = groups.back();
        group.lux += member.lux;
        group.middle += member.weight() * member.middle;
        ++group.count;
    }
    for (Source& group : groups) {
        group.middle /= group.weight();
        for (std::uint32_t i = group.first; i < group.first + group.count; ++i) {
            const Source& member = below[i];
            const double share = member.weight() / group.weight();
            group.spread.add(share, member.spread);
            group.spread.add(share, member.middle - group.middle);
            group.radius = std::max(group.radius, glm::distance(group.middle, member.middle) + member.radius);
        }
    }
    return groups;
}

// The part of a colour beyond white.
Vec excess_of(const Vec& rgb) {
    const double luminance = glm::dot(rgb, rec709_luminance);
    return luminance > 1.0 && std::isfinite(luminance) ? rgb * (1.0 - 1.0 / luminance) : Vec(0.0);
}

template<class Channels>
Vec vec_of(const Channels& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

template<class Channels>
void add(const Vec& value, Channels&& rgb) {
    for (int channel = 0; channel < 3; ++channel) {
        float& sum = rgb[static_cast<std::size_t>(channel)];
        sum = static_cast<float>(std::max(static_cast<double>(sum) + value[channel], 0.0));
    }
}

// The excess of each pixel; those that show lights in part have that of their parts.
std::vector<Vec> excess_in(const Image& exposed, std::span<const PartialLight> lights) {
    std::vector<Vec> excess(exposed.pixels.size() / 3);
    for (std::size_t i = 0; i < excess.size(); ++i)
        excess[i] = excess_of(vec_of(exposed.pixels.data() + 3 * i));
    while (!lights.empty()) {
        const std::uint32_t pixel = lights.front().pixel;
        Vec rest = vec_of(exposed.pixels.data() + std::size_t{pixel} * 3);
        Vec sum(0.0);
        double left = 1.0;
        for (; !lights.empty() && lights.front().pixel == pixel; lights = lights.subspan(1)) {
            const auto share = static_cast<double>(lights.front().share);
            const Vec rgb = vec_of(lights.front().rgb);
            rest -= share * rgb;
            left -= share;
            sum += share * excess_of(rgb);
        }
        constexpr double hardly_any = 1e-3; // where the difference is rounding
        if (left > hardly_any) sum += left * excess_of(glm::max(rest, 0.0) / left);
        excess[pixel] = sum;
    }
    return excess;
}

constexpr int tile_size = 8; // pixels that share their groups

// What a pixel sends to its neighbours, in which the function changes within it: the mean over the pixel by the value
// at its middle. By the offset in pixels, for pixels of one size and shape.
class NeighbourRatios {
public:
    NeighbourRatios(const ByChord& glare, const Vec& across, const Vec& down)
        : glare_(glare), across_(across), down_(down) {
        ratios_.fill(0.0);
    }

    static bool has(int columns, int rows) { return std::abs(columns) <= reach && std::abs(rows) <= reach; }

    double at(int columns, int rows) {
        const int place = (rows + reach) * static_cast<int>(side) + columns + reach;
        double& ratio = ratios_[static_cast<std::size_t>(place)];
        if (ratio == 0.0) ratio = computed(columns, rows);
        return ratio;
    }

private:
    static constexpr int reach = 8;
    static constexpr std::size_t side = 2 * reach + 1;

    double computed(int columns, int rows) const {
        const int parts = std::max(std::abs(columns), std::abs(rows)) > 2 ? 4 : 12; // along each side
        double sum = 0.0;
        for (int i = 0; i < parts; ++i)
            for (int j = 0; j < parts; ++j)
                sum += value(columns + (i + 0.5) / parts - 0.5, rows + (j + 0.5) / parts - 0.5);
        return sum / square(parts) / value(columns, rows);
    }
    double value(double columns, double rows) const {
        const Vec away = columns * across_ + rows * down_;
        return glare_.at(glm::dot(away, away));
    }

    const ByChord& glare_;
    Vec across_;
    Vec down_;
    std::array<double, side * side> ratios_; // 0: not computed yet
};

class Veil {
public:
    Veil(const Image& picture, const std::vector<Vec>& excess, const PixelRays& rays, const GlareFunction& glare,
         double group_size)
        : width_(picture.width), height_(picture.height), rays_(rays), glare_(glare), group_size_(group_size) {
        Level pixels;
        for (int row = 0; row < height_; ++row)
            for (int column = 0; column < width_; ++column) {
                const Vec& rgb = excess[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                        static_cast<std::size_t>(column)];
                if (rgb == Vec(0.0)) continue;
                const Vec across = rays.across(column, row);
                const Vec down = rays.down(column, row);
                Source& pixel = pixels.emplace_back();
                pixel.middle = rays.middle(column, row);
                pixel.lux = rgb * rays.solid_angle(column, row);
                pixel.spread.add(1.0 / 12.0, across);
                pixel.spread.add(1.0 / 12.0, down);
                pixel.radius = 0.5 * std::max(glm::length(across + down), glm::length(across - down));
                pixel.column = column;
                pixel.row = row;
            }
        std::sort(pixels.begin(), pixels.end(), [](const Source& a, const Source& b) {
            return interleaved(a.column, a.row) < interleaved(b.column, b.row);
        });
        levels_.push_back(std::move(pixels));
        while (levels_.back().size() > 1 && levels_.size() < 32)
            levels_.push_back(groups_of(levels_.back()));
    }

    bool is_empty() const { return levels_.front().empty(); }
    std::size_t tiles() const {
        return static_cast<std::size_t>(tiles_across()) * static_cast<std::size_t>(count_of(height_));
    }

    // What the pixels of a tile receive from all other pixels.
    void find_tile(std::size_t tile, std::vector<Vec>& veil) const {
        const int left = static_cast<int>(tile) % tiles_across() * tile_size;
        const int top = static_cast<int>(tile) / tiles_across() * tile_size;
        const Seen seen = seen_from(left, top);
        const std::array<Vec, nodes* nodes> smooth = at_nodes(seen.smooth, left, top);
        const int column_inside = std::min(left + tile_size / 2, width_ - 1);
        const int row_inside = std::min(top + tile_size / 2, height_ - 1);
        NeighbourRatios ratios(glare_, rays_.across(column_inside, row_inside), rays_.down(column_inside, row_inside));
        for (int row = top; row < std::min(top + tile_size, height_); ++row)
            for (int column = left; column < std::min(left + tile_size, width_); ++column) {
                const Vec to = rays_.middle(column, row);
                Vec sum = between_nodes(smooth, column - left, row - top);
                for (const Source* source : seen.far)
                    sum += glare_.mean(to - source->middle, source->spread) * source->lux;
                for (const Source* source : seen.near)
                    sum += from_pixel(*source, column, row, to, ratios) * source->lux;
                veil[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                     static_cast<std::size_t>(column)] = sum;
            }
    }

private:
    // The greatest radius of a pixel over its distance, for its mean to second order.
    static constexpr double pixel_size = 0.2;
    // The greatest radius of a tile over the distance of what is interpolated over it.
    static constexpr double tile_share = 0.15;
    static constexpr std::size_t nodes = 3; // of the interpolation over a tile, along each side

    // What a tile sees, by how its light is summed.
    struct Seen {
        std::vector<const Source*> smooth; // so far away that a parabola follows it over the tile
        std::vector<const Source*> far;    // at each pixel
        std::vector<const Source*> near;   // pixels, at each pixel
    };

    static int count_of(int pixels) { return (pixels + tile_size - 1) / tile_size; }
    int tiles_across() const { return count_of(width_); }

    Seen seen_from(int left, int top) const {
        const Vec middle = rays_.at(left + 0.5 * tile_size, top + 0.5 * tile_size);
        double radius = 0.0;
        for (const int row : {0, tile_size})
            for (const int column : {0, tile_size})
                radius = std::max(radius, glm::distance(middle, rays_.at(left + column, top + row)));
        struct Open {
            std::size_t level;
            const Source* source;
        };
        std::vector<Open> open;
        for (const Source& source : levels_.back())
            open.push_back({levels_.size() - 1, &source});
        Seen seen;
        while (!open.empty()) {
            const auto [level, source] = open.back();
            open.pop_back();
            const double distance = glm::distance(middle, source->middle);
            if (source->radius < (level == 0 ? pixel_size : group_size_) * (distance - radius)) {
                (radius < tile_share * distance && group_size_ > 0.0 ? seen.smooth : seen.far).push_back(source);
            } else if (level == 0) {
                seen.near.push_back(source);
            } else {
                for (std::uint32_t i = source->first + source->count; i-- > source->first;)
                    open.push_back({level - 1, &levels_[level - 1][i]});
            }
        }
        return seen;
    }

    // Where the nodes are: on the first and the last pixel of a whole tile and between them.
    static double node_at(std::size_t node) { return 0.5 * (tile_size - 1) * static_cast<double>(node); }

    std::array<Vec, nodes * nodes> at_nodes(const std::vector<const Source*>& sources, int left, int top) const {
        std::array<Vec, nodes * nodes> sums{};
        if (sources.empty()) return sums;
        for (std::size_t j = 0; j < nodes; ++j)
            for (std::size_t i = 0; i < nodes; ++i) {
                const Vec to = rays_.at(left + node_at(i) + 0.5, top + node_at(j) + 0.5);
                Vec& sum = sums[j * nodes + i];
                for (const Source* source : sources)
                    sum += glare_.mean(to - source->middle, source->spread) * source->lux;
            }
        return sums;
    }

    // Lagrange's parabola through values at −1, 0 and 1.
    static std::array<double, nodes> parabola(int pixel) {
        const double x = pixel / node_at(1) - 1.0;
        return {0.5 * x * (x - 1.0), 1.0 - square(x), 0.5 * x * (x + 1.0)};
    }
    static Vec between_nodes(const std::array<Vec, nodes * nodes>& sums, int column, int row) {
        const std::array<double, nodes> across = parabola(column);
        const std::array<double, nodes> down = parabola(row);
        Vec sum(0.0);
        for (std::size_t j = 0; j < nodes; ++j)
            for (std::size_t i = 0; i < nodes; ++i)
                sum += down[j] * across[i] * sums[j * nodes + i];
        return sum;
    }

    double from_pixel(const Source& pixel, int column, int row, const Vec& to, NeighbourRatios& ratios) const {
        if (pixel.column == column && pixel.row == row) return 0.0;
        const Vec away = to - pixel.middle;
        const double chord2 = glm::dot(away, away);
        if (square(pixel.radius) < square(pixel_size) * chord2 ||
            !NeighbourRatios::has(column - pixel.column, row - pixel.row))
            return glare_.mean(away, pixel.spread);
        return glare_.at(chord2) * ratios.at(column - pixel.column, row - pixel.row);
    }

    int width_;
    int height_;
    const PixelRays& rays_;
    ByChord glare_;
    double group_size_;
    std::vector<Level> levels_;
};

} // namespace

GlareFunction::GlareFunction(Eye eye) {
    const double by_70 = std::pow(eye.age_years / 70.0, 4);
    narrow_ = 1.0 - 0.08 * by_70;
    wide_ = 1.0 + 1.6 * by_70;
    pigment_ = eye.pigment;
    static constexpr auto rule = gauss_legendre<12>();
    double sum = 0.0;
    double end_deg = 90.0;
    for (int octave = 0; octave < 40; ++octave, end_deg *= 0.5)
        for (const QuadratureNode& node : rule) {
            const double angle_deg = end_deg * (0.75 + 0.25 * node.at);
            const double angle = angle_deg * degree;
            sum +=
                node.weight * 0.25 * end_deg * degree * published_per_sr(angle_deg) * std::sin(angle) * std::cos(angle);
        }
    integral_ = 2.0 * std::numbers::pi * sum;
}

double GlareFunction::published_per_sr(double angle_deg) const {
    const double core = 1.0 + square(angle_deg / core_deg);
    const double skirt = 1.0 + square(angle_deg / skirt_deg);
    const double halo = 1.0 + square(angle_deg / halo_deg);
    const auto steep = [](double x) { return 1.0 / (x * std::sqrt(x)); };
    return narrow_ * (9.2e6 * steep(core) + 1.5e5 * steep(skirt)) +
           wide_ *
               (400.0 / halo + 3e-8 * square(angle_deg) + pigment_ * (1300.0 * steep(halo) + 0.8 / std::sqrt(halo))) +
           2.5e-3 * pigment_;
}

double GlareFunction::per_sr(double angle_rad) const {
    return published_per_sr(angle_rad / degree) / integral_;
}

double GlareFunction::share_within(double angle_rad) const {
    const double r = angle_rad / degree;
    const double sum = narrow_ * (9.2e6 * steep_within(r, core_deg) + 1.5e5 * steep_within(r, skirt_deg)) +
                       wide_ * (400.0 * middle_within(r, halo_deg) + 0.5 * std::numbers::pi * 3e-8 * square(square(r)) +
                                pigment_ * (1300.0 * steep_within(r, halo_deg) + 0.8 * flat_within(r, halo_deg))) +
                       2.5e-3 * pigment_ * std::numbers::pi * square(r);
    return sum * square(degree) / integral_;
}

void show_points(Image& luminance_nt, const Stage& stage, std::span<const Light> lights, const Camera& camera) {
    const CameraRays rays(camera, luminance_nt.width, luminance_nt.height);
    const PixelRays pixels(camera, luminance_nt);
    for (const Light& light : lights) {
        const bool has_size = light.luminance.value > 0.0 || light.illuminance.value > 0.0 || light.body != nullptr;
        if (has_size) continue;
        const std::optional<glm::dvec2> place = rays.place_of(light.frame.origin);
        if (!place || !(place->x >= 0.0 && place->x < luminance_nt.width)) continue;
        if (!(place->y >= 0.0 && place->y < luminance_nt.height)) continue;
        const Vec to_eye = camera.position - light.frame.origin;
        const double distance = glm::length(to_eye);
        const std::optional<Hit> hit = first_hit(stage, rays.ray(place->x, place->y));
        if (hit && hit->distance < distance) continue;
        const auto column = static_cast<int>(place->x);
        const auto row = static_cast<int>(place->y);
        const double window = light.range ? shading::window_squared(distance, 1.0 / light.range->value) : 1.0;
        const double lux = light.intensity_towards(to_eye).value / square(distance) * window;
        const double nits = lux / pixels.solid_angle(column, row);
        if (std::isfinite(nits)) add(nits * light.color, luminance_nt.at(column, row));
    }
}

void add_glare(Image& exposed, std::span<PartialLight> lights, const Camera& camera, const GlareOptions& options) {
    const std::vector<Vec> excess = excess_in(exposed, lights);
    const GlareFunction glare(options.eye);
    const PixelRays rays(camera, exposed);
    const Veil veil(exposed, excess, rays, glare, options.group_size);
    if (veil.is_empty()) return;
    std::vector<Vec> received(excess.size());
    parallel_for(veil.tiles(), options.threads, [&](std::size_t tile) { veil.find_tile(tile, received); });
    // What a source loses to other pixels.
    const auto share_lost = [&](std::size_t pixel) {
        const auto width = static_cast<std::size_t>(exposed.width);
        const auto column = static_cast<int>(pixel % width);
        const auto row = static_cast<int>(pixel / width);
        return 1.0 - share_in_pixel(glare, rays.across(column, row), rays.down(column, row));
    };
    for (std::size_t i = 0; i < excess.size(); ++i) {
        Vec change = received[i];
        if (excess[i] != Vec(0.0)) change -= share_lost(i) * excess[i];
        float* const pixel = exposed.pixels.data() + 3 * i;
        add(change, pixel);
    }
    for (PartialLight& light : lights)
        add(received[light.pixel] - share_lost(light.pixel) * excess_of(vec_of(light.rgb)), light.rgb);
}

} // namespace gonio
