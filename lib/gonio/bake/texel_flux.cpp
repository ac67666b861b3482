#include <gonio/bake/texel_flux.hpp>
#include <gonio/base/gauss_legendre.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double turn = 2.0 * pi;

// An edge is short if these are below: its length [rad], and that length as seen from the goniometer's axis.
constexpr double short_length = 0.15;
constexpr double short_reach = 0.2;

// For an edge that ends where the map has a corner; edges run straight there.
constexpr int most_halvings = 4;

// Charts with fewer texels per side have long edges.
constexpr int least_side = 16;

constexpr auto three = gauss_legendre<3>();
constexpr auto four = gauss_legendre<4>();
constexpr auto six = gauss_legendre<6>();
constexpr auto twelve = gauss_legendre<12>();

// atan and asin of small arguments, by their series: accurate to 1e-16 for |x| ≤ 0.15.
double small_atan(double x) {
    const double q = x * x;
    return x * (1.0 + q * (-1.0 / 3 + q * (1.0 / 5 + q * (-1.0 / 7 + q * (1.0 / 9 + q * (-1.0 / 11 + q / 13))))));
}
double small_asin(double x) {
    const double q = x * x;
    return x * (1.0 + q * (1.0 / 6 + q * (3.0 / 40 + q * (5.0 / 112 +
                                                          q * (35.0 / 1152 + q * (63.0 / 2816 + q * 231.0 / 13312))))));
}

// An edge at x, in the goniometer's frame: its direction, and the derivative across the line of sight.
struct Place {
    glm::dvec3 at; // of unit length
    glm::dvec3 moves;
};

Place place(const Meridians& meridians, const Chart& chart, bool along_s, double fixed, double x) {
    const ChartPoint point = along_s ? chart.at(x, fixed) : chart.at(fixed, x);
    const double scale = 1.0 / glm::length(point.direction);
    const glm::dvec3 at = meridians.local(point.direction) * scale;
    const glm::dvec3 moves = meridians.local(along_s ? point.along_s : point.along_t) * scale;
    return {at, moves - glm::dot(moves, at) * at};
}

// The zero of f between a and b, where f has opposite signs: regula falsi in the Illinois form.
template<class F>
double root(double a, double b, double fa, double fb, F&& f) {
    const double enough = 1e-13 * (b - a);
    for (int step = 0; step < 40; ++step) {
        const double c = std::clamp((a * fb - b * fa) / (fb - fa), a, b);
        const double fc = f(c);
        if (fc == 0.0) return c;
        const bool like_b = (fc < 0.0) == (fb < 0.0);
        const double moved = like_b ? b - c : c - a;
        if (like_b) {
            b = c;
            fb = fc;
            fa *= 0.5;
        } else {
            a = c;
            fa = fc;
            fb *= 0.5;
        }
        if (moved < enough) return c;
    }
    return 0.5 * (a + b);
}

// A few cuts of an edge, stored without allocation.
struct Cuts {
    std::array<double, 8> at{};
    std::size_t count = 0;
    bool full = false;

    void add(double x) {
        if (count < at.size())
            at[count++] = x;
        else
            full = true;
    }
};

} // namespace

// A corner of a texel in the goniometer's frame.
struct TexelFlux::Corner {
    glm::dvec3 at{};
    double rho = 0.0; // sinθ
    double azimuth = 0.0;
    double polar = 0.0;
};

TexelFlux::Corner TexelFlux::corner(int i, int j) const {
    const glm::dvec3 direction = chart_.at(static_cast<double>(i) / width_, static_cast<double>(j) / height_).direction;
    Corner corner;
    corner.at = meridians_.local(direction) / glm::length(direction);
    corner.rho = std::sqrt(corner.at.x * corner.at.x + corner.at.y * corner.at.y);
    corner.azimuth = std::atan2(corner.at.y, corner.at.x);
    corner.polar = std::atan2(corner.rho, corner.at.z);
    return corner;
}

ChartCell TexelFlux::cell_of(int i, int j) const {
    return {static_cast<double>(i) / width_, static_cast<double>(i + 1) / width_, static_cast<double>(j) / height_,
            static_cast<double>(j + 1) / height_};
}

// Between cuts: in one sector and one cell.
EdgeSums TexelFlux::piece(bool along_s, double fixed, double from, double to, int halvings) const {
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    const Place center = place(meridians_, chart_, along_s, fixed, middle);
    const double rho = std::sqrt(center.at.x * center.at.x + center.at.y * center.at.y);
    const double azimuth = std::atan2(center.at.y, center.at.x);
    const double polar = std::atan2(rho, center.at.z);
    const Meridians::Patch patch = meridians_.patch(meridians_.sector_of(azimuth), meridians_.cell_of(polar));
    double from_begin = azimuth - patch.azimuth_begin;
    from_begin -= turn * std::round((from_begin - 0.5 * patch.azimuth_width) / turn);
    const double per_width = 1.0 / patch.azimuth_width;

    EdgeSums sums;
    const auto add = [&](const QuadratureNode& node) {
        const Place there = place(meridians_, chart_, along_s, fixed, middle + half * node.at);
        const glm::dvec3& p = there.at;
        const glm::dvec3& moves = there.moves;
        const double across = p.x * p.x + p.y * p.y;
        const double sine = std::sqrt(across);
        const double d_azimuth = node.weight * half * (p.x * moves.y - p.y * moves.x) / across;
        // α and θ relative to those of the middle.
        const double more_azimuth =
            small_atan((center.at.x * p.y - center.at.y * p.x) / (center.at.x * p.x + center.at.y * p.y));
        const double more_polar = small_asin(sine * center.at.z - p.z * rho);
        const double weight = (from_begin + more_azimuth) * per_width;
        const double beyond = polar - patch.polar_begin + more_polar;
        const auto integral = [&](const Meridians::Piece& end) {
            return end.constant - (end.intensity + end.slope * beyond) * p.z + end.slope * sine;
        };
        const double low = integral(patch.low);
        const double high = integral(patch.high);
        sums.flux += (low + weight * (high - low)) * d_azimuth;
        // The far part, computed for each end separately, so that it is 0 where there is no flux.
        const double low_beyond = low - patch.low_total;
        sums.far_flux += (low_beyond + weight * (high - patch.high_total - low_beyond)) * d_azimuth;
        // 1 − cosθ and −1 − cosθ, each in the form that does not cancel.
        const double small = across / (1.0 + std::abs(p.z));
        sums.solid_angle += (p.z > 0.0 ? small : 1.0 - p.z) * d_azimuth;
        sums.far_solid_angle -= (p.z < 0.0 ? small : 1.0 + p.z) * d_azimuth;
    };
    // The number of nodes grows with the piece's length, estimated at its middle: in itself, around the pole, and
    // relative to the distance of a corner of the map.
    const double speed = glm::length(center.moves) * 2.0 * half;
    const double corner = 2.0 * half / chart_.smooth_within(along_s ? middle : fixed, along_s ? fixed : middle);
    const double reach = std::max(std::max(speed, speed / rho), corner);
    if (reach < 0.03) {
        std::for_each(three.begin(), three.end(), add);
    } else if (reach < 0.08) {
        std::for_each(four.begin(), four.end(), add);
    } else if (reach < 0.2) {
        std::for_each(six.begin(), six.end(), add);
    } else if (reach < 0.6 || halvings == 0) {
        std::for_each(twelve.begin(), twelve.end(), add);
    } else {
        sums = piece(along_s, fixed, from, middle, halvings - 1);
        sums += piece(along_s, fixed, middle, to, halvings - 1);
    }
    return sums;
}

EdgeSums TexelFlux::edge(const Corner& begin, const Corner& end, bool along_s, double fixed, double from,
                         double to) const {
    const auto generally = [&] { return edge_sums(meridians_, chart_, along_s, fixed, from, to); };
    const double length = glm::distance(begin.at, end.at);
    const double least_rho = std::min(begin.rho, end.rho);
    if (!(length < short_length && length < short_reach * least_rho)) return generally();
    const double speed = glm::length(place(meridians_, chart_, along_s, fixed, 0.5 * (from + to)).moves) * (to - from);
    if (!(speed < 1.25 * length + 1e-9)) return generally(); // back and forth, or all the way around
    if (chart_.folds_between(along_s, fixed, from, to)) return generally();

    Cuts cuts;
    // If there is no break of θ within the possible bulge of the edge, it crosses none.
    const std::span<const double> polars = meridians_.polar_breaks();
    const double bulge = 0.25 * length;
    const auto low = std::upper_bound(polars.begin(), polars.end(), std::min(begin.polar, end.polar) - bulge);
    const auto high = std::upper_bound(low, polars.end(), std::max(begin.polar, end.polar) + bulge);
    if (low != high) {
        const auto rise = [&](double x) { return place(meridians_, chart_, along_s, fixed, x).moves.z; };
        const double inside = 1e-9 * (to - from);
        if ((rise(from + inside) < 0.0) != (rise(to - inside) < 0.0)) return generally(); // θ turns
        for (auto at = low; at != high; ++at) {
            const double cosine = meridians_.polar_break_cosines()[static_cast<std::size_t>(at - polars.begin())];
            const double a = begin.at.z - cosine;
            const double b = end.at.z - cosine;
            if (std::min(a, b) < -1e-13 && std::max(a, b) > 1e-13)
                cuts.add(root(from, to, a, b,
                              [&](double x) { return place(meridians_, chart_, along_s, fixed, x).at.z - cosine; }));
        }
    }
    const std::size_t sector = meridians_.sector_of(begin.azimuth);
    const std::span<const double> azimuths = meridians_.azimuth_breaks();
    const double turned = std::remainder(end.azimuth - begin.azimuth, turn);
    for (std::size_t k = 0; k < azimuths.size() && !cuts.full; ++k) {
        // Forwards: the beginnings of the next sectors; backwards: that of this sector and of those before.
        const std::size_t next =
            turned > 0.0 ? (sector + 1 + k) % azimuths.size() : (sector + azimuths.size() - k) % azimuths.size();
        const double ahead = std::remainder(azimuths[next] - begin.azimuth, turn);
        if (turned > 0.0 ? ahead > turned || ahead < -1e-9 : ahead < turned || ahead > 1e-9) break;
        const double c = std::cos(azimuths[next]);
        const double s = std::sin(azimuths[next]);
        const double a = begin.at.y * c - begin.at.x * s;
        const double b = end.at.y * c - end.at.x * s;
        if (std::min(a, b) < -1e-13 && std::max(a, b) > 1e-13)
            cuts.add(root(from, to, a, b, [&](double x) {
                const glm::dvec3 at = place(meridians_, chart_, along_s, fixed, x).at;
                return at.y * c - at.x * s;
            }));
    }
    if (cuts.full) return generally();
    std::sort(cuts.at.begin(), cuts.at.begin() + static_cast<std::ptrdiff_t>(cuts.count));
    EdgeSums sums;
    double last = from;
    for (std::size_t k = 0; k <= cuts.count; ++k) {
        const double next = k < cuts.count ? cuts.at[k] : to;
        if (next <= last) continue;
        sums += piece(along_s, fixed, last, next, most_halvings);
        last = next;
    }
    return sums;
}

// Whether a texel lies where there is no light, judged by its corners: they are farther from the light than the texel's
// width.
bool TexelFlux::is_dark(const Corner* upper, const Corner* lower) const {
    const std::array<const Corner*, 4> corners{upper, upper + 1, lower, lower + 1};
    double width = 0.0;
    double least_rho = 1.0;
    double nearest = pi;
    double farthest = 0.0;
    for (const Corner* corner : corners) {
        for (const Corner* other : corners)
            width = std::max(width, glm::distance(corner->at, other->at));
        least_rho = std::min(least_rho, corner->rho);
        nearest = std::min(nearest, corner->polar);
        farthest = std::max(farthest, corner->polar);
    }
    const double margin = 1.1 * width + 1e-9;
    if (farthest + margin < meridians_.lit_polar_from() || nearest - margin > meridians_.lit_polar_to()) return true;
    if (meridians_.dark_azimuth_width() <= 0.0 || 2.0 * margin > least_rho) return false;
    const double beside = 1.5 * margin / least_rho;
    return std::all_of(corners.begin(), corners.end(), [&](const Corner* corner) {
        double inside = std::fmod(corner->azimuth - meridians_.dark_azimuth_begin(), turn);
        if (inside < 0.0) inside += turn;
        return inside > beside && inside < meridians_.dark_azimuth_width() - beside;
    });
}

// Whether the flux is counted from the pole θ = π: from the nearer pole; for a dark texel from the pole on its side of
// the light, so that zero flux is exactly 0.
bool TexelFlux::is_far(const Corner* upper, const Corner* lower) const {
    const std::array<double, 4> polars{upper[0].polar, upper[1].polar, lower[0].polar, lower[1].polar};
    const auto [least, greatest] = std::minmax_element(polars.begin(), polars.end());
    if (*least >= meridians_.lit_polar_to()) return true;
    if (*greatest <= meridians_.lit_polar_from()) return false;
    return upper[0].at.z + upper[1].at.z + lower[0].at.z + lower[1].at.z < 0.0;
}

// Whether the texel is at θ = π, which needs the general method.
bool TexelFlux::is_at_far_pole(const Corner* upper, const Corner* lower, const ChartCell& cell) const {
    const double least = std::min(std::min(upper[0].at.z, upper[1].at.z), std::min(lower[0].at.z, lower[1].at.z));
    return least < -0.7 && may_hold_far_pole(meridians_, chart_, cell);
}

CellFlux TexelFlux::texel(int i, int j) const {
    const ChartCell cell = cell_of(i, j);
    if (width_ < least_side || height_ < least_side) return cell_flux(meridians_, chart_, cell);
    const std::array<Corner, 2> upper{corner(i, j), corner(i + 1, j)};
    const std::array<Corner, 2> lower{corner(i, j + 1), corner(i + 1, j + 1)};
    if (is_at_far_pole(upper.data(), lower.data(), cell)) return cell_flux(meridians_, chart_, cell);
    EdgeSums around = edge(upper[0], upper[1], true, cell.t0, cell.s0, cell.s1);
    around += edge(upper[1], lower[1], false, cell.s1, cell.t0, cell.t1);
    around -= edge(lower[0], lower[1], true, cell.t1, cell.s0, cell.s1);
    around -= edge(upper[0], lower[0], false, cell.s0, cell.t0, cell.t1);
    return inside(around, is_far(upper.data(), lower.data()));
}

void TexelFlux::rows(int j, int rows, std::span<const char> wanted, bool skip_dark, std::span<double> lumens,
                     std::span<double> steradians) const {
    const auto w = static_cast<std::size_t>(width_);
    std::fill(lumens.begin(), lumens.end(), 0.0);
    std::fill(steradians.begin(), steradians.end(), 0.0);
    const auto set = [&](std::size_t at, const CellFlux& flux) {
        lumens[at] = flux.lumens;
        steradians[at] = flux.steradians;
    };
    if (width_ < least_side || height_ < least_side) {
        for (int row = 0; row < rows; ++row)
            for (std::size_t i = 0; i < w; ++i) {
                const std::size_t at = static_cast<std::size_t>(row) * w + i;
                if (wanted.empty() || wanted[at] != 0) set(at, texel(static_cast<int>(i), j + row));
            }
        return;
    }

    std::vector<Corner> upper(w + 1);
    std::vector<Corner> lower(w + 1);
    for (std::size_t i = 0; i <= w; ++i)
        upper[i] = corner(static_cast<int>(i), j);
    // The edges above the row, if the row before has computed them.
    std::vector<std::optional<EdgeSums>> top(w);
    for (int row = j; row < j + rows; ++row) {
        const std::size_t first = static_cast<std::size_t>(row - j) * w;
        for (std::size_t i = 0; i <= w; ++i)
            lower[i] = corner(static_cast<int>(i), row + 1);
        std::optional<EdgeSums> left;
        for (std::size_t i = 0; i < w; ++i) {
            const ChartCell cell = cell_of(static_cast<int>(i), row);
            const bool leave_out =
                (!wanted.empty() && wanted[first + i] == 0) || (skip_dark && is_dark(&upper[i], &lower[i]));
            if (leave_out || is_at_far_pole(&upper[i], &lower[i], cell)) {
                if (!leave_out) set(first + i, cell_flux(meridians_, chart_, cell));
                top[i].reset();
                left.reset();
                continue;
            }
            EdgeSums around = top[i] ? *top[i] : edge(upper[i], upper[i + 1], true, cell.t0, cell.s0, cell.s1);
            const EdgeSums right = edge(upper[i + 1], lower[i + 1], false, cell.s1, cell.t0, cell.t1);
            const EdgeSums bottom = edge(lower[i], lower[i + 1], true, cell.t1, cell.s0, cell.s1);
            around += right;
            around -= bottom;
            around -= left ? *left : edge(upper[i], lower[i], false, cell.s0, cell.t0, cell.t1);
            set(first + i, inside(around, is_far(&upper[i], &lower[i])));
            top[i] = bottom; // the upper edge of the next row
            left = right;
        }
        std::swap(upper, lower);
    }
}

} // namespace gonio
