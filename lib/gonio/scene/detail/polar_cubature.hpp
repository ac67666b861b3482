// Adaptive integration over the visible part of a light on the sphere, with an error estimate.
//
// Polar coordinates about a pole: the azimuth is divided where the outline turns, so that within a section the ends of
// the rays are smooth; the map t → t³(10 − 15t + 6t²) removes the square roots at the sections' ends. Along a ray the
// angle is w sinh s: uniform steps of s resolve both a lobe of the width w about the pole and the region far from it.
// Where a ray ends at the horizon the steps shrink with the cube, because shadowing there rises from 0 within a height
// of α. Cells of (azimuth, s) are integrated by the product of two Gauss–Kronrod rules of 7 and 15 nodes (R. Piessens
// et al., "QUADPACK", 1983), and the worst cell is halved along its worse side until the sum of the errors is small
// enough. All directions of a cell are evaluated at once.
//
// Along known edges of the integrand, such as the grid of a measured profile about the pole, sections and rays are
// divided beforehand. Between them the integrand is simple, and rules of 3 and 7 nodes are used.
#pragma once

#include <gonio/scene/detail/light_region.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace gonio::detail {

// An expected peak: `pole` is its direction, `along` a unit tangent there, `width` [rad] its half width along the
// tangent, `squeeze` in (0, 1] times `width` the half width across it.
struct PolarPeak {
    Vec pole;
    Vec along;
    double width = 1.0;
    double squeeze = 1.0;
};

// Where the integrand's slope jumps: azimuths about the pole from `along` on, and angles from the pole, in (0, π) and
// ascending [rad].
struct PolarEdges {
    std::vector<double> azimuths;
    std::vector<double> angles;

    bool empty() const { return azimuths.empty() && angles.empty(); }
};

struct CubatureGoal {
    double relative_error = 1e-6;
    std::size_t most_evaluations = 4'000'000;
};

struct CubatureResult {
    double value = 0.0;
    double error_estimate = 0.0; // absolute
    std::size_t evaluations = 0;
    bool converged = true;
};

// The nodes on [−1, 1] of Kronrod's rule and its weights; the nodes of Gauss's rule are every other one of them.
template<std::size_t node_count>
struct GaussKronrod {
    static constexpr std::size_t count = node_count;
    static constexpr std::size_t half = (count + 1) / 2;
    std::array<double, count> node{};
    std::array<double, count> kronrod{};
    std::array<double, count> gauss{}; // 0 at the other nodes

    // Of the lower half, the middle included.
    constexpr GaussKronrod(const std::array<double, half>& nodes, const std::array<double, half>& weights,
                           const std::array<double, half / 2>& gauss_weights) {
        for (std::size_t i = 0; i < half; ++i) {
            node[i] = -nodes[i];
            node[count - 1 - i] = nodes[i];
            kronrod[i] = kronrod[count - 1 - i] = weights[i];
            if (i % 2 == 1) gauss[i] = gauss[count - 1 - i] = gauss_weights[i / 2];
        }
    }
};
inline constexpr GaussKronrod<7> kronrod_7({0.960491268708020283423507092629080, 0.774596669241483377035853079956480,
                                            0.434243749346802558002071502844628, 0.0},
                                           {0.104656226026467265193823857192073, 0.268488089868333440728569280666710,
                                            0.401397414775962222905051818618432, 0.450916538658474142345110087045571},
                                           {0.555555555555555555555555555555556, 0.888888888888888888888888888888889});
inline constexpr GaussKronrod<15> kronrod_15(
    {0.991455371120812639206854697526329, 0.949107912342758524526189684047851, 0.864864423359769072789712788640926,
     0.741531185599394439863864773280788, 0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
     0.207784955007898467600689403773245, 0.0},
    {0.022935322010529224963732008058970, 0.063092092629978553290700663189204, 0.104790010322250183839876322541518,
     0.140653259715525918745189590510238, 0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
     0.204432940075298892414161999234649, 0.209482141084727828012999174891714},
    {0.129484966168869693270611432679082, 0.279705391489276667901467771423780, 0.381830050505118944950369775488975,
     0.417959183673469387755102040816327});

template<class Integrand>
class PolarCubature {
public:
    // integrand(directions, values) for unit directions of the region, the values in [0, ∞), smooth there except for
    // features that adaptivity resolves.
    PolarCubature(const LightRegion& region, const PolarPeak& peak, const Integrand& integrand, PolarEdges edges = {})
        : region_(region),
          integrand_(integrand),
          pole_(peak.pole),
          width_(peak.width),
          squeeze_(peak.squeeze),
          edges_(std::move(edges)),
          edged_(!edges_.empty()) {
        divide(peak.along);
    }

    CubatureResult integrate(const CubatureGoal& goal) {
        for (std::size_t i = 0; i < sections_.size(); ++i)
            begin(i);
        const auto better = [](const Cell& a, const Cell& b) { return a.error() < b.error(); };
        std::make_heap(cells_.begin(), cells_.end(), better);
        // Running sums collect rounding errors, so they are computed again from time to time.
        CubatureResult sums = sum();
        double before = sums.error_estimate;
        for (std::size_t steps = 1; !enough(sums, goal) && sums.evaluations < goal.most_evaluations; ++steps) {
            std::pop_heap(cells_.begin(), cells_.end(), better);
            const Cell worst = cells_.back();
            cells_.pop_back();
            sums.value -= worst.value;
            sums.error_estimate -= worst.error();
            for (const Cell& half : halves(worst)) {
                cells_.push_back(half);
                std::push_heap(cells_.begin(), cells_.end(), better);
                sums.value += half.value;
                sums.error_estimate += half.error();
            }
            sums.evaluations = evaluations_;
            if (steps % 64 == 0 || enough(sums, goal)) sums = sum();
            if (steps % patience == 0) {
                // Halving cells does not reduce rounding errors.
                if (sums.error_estimate > 0.9 * before) break;
                before = sums.error_estimate;
            }
        }
        sums = sum();
        sums.converged = enough(sums, goal);
        return sums;
    }

private:
    // Azimuths about the pole from `zero_`; ψ is the azimuth in which a peak that is squeezed across `along_` becomes
    // round.
    struct Section {
        double from = 0.0; // ψ
        double to = 0.0;
        bool horizon = false; // the rays end there
        bool even = false;    // between two edges of the integrand, away from the outline's turns
    };
    struct Cell {
        std::size_t section = 0;
        double t0 = 0.0, t1 = 1.0; // of the section
        double u0 = 0.0, u1 = 1.0; // of the ray
        double value = 0.0;
        double error_t = 0.0, error_u = 0.0;
        double rounding = 0.0;

        double error() const { return error_t + error_u + rounding; }
    };

    static bool enough(const CubatureResult& sums, const CubatureGoal& goal) {
        return sums.error_estimate <= goal.relative_error * std::abs(sums.value);
    }

    CubatureResult sum() const {
        CubatureResult sums;
        for (const Cell& cell : cells_) {
            sums.value += cell.value;
            sums.error_estimate += cell.error();
        }
        sums.evaluations = evaluations_;
        return sums;
    }

    static Vec unit(Vec a) { return a * (1.0 / shading::length(a)); }

    double squeezed(double phi) const {
        const double c = std::cos(phi);
        const double s = std::sin(phi);
        return phi + std::atan2((1.0 / squeeze_ - 1.0) * s * c, c * c + s * s / squeeze_);
    }
    double stretched(double psi) const {
        const double c = std::cos(psi);
        const double s = std::sin(psi);
        return psi + std::atan2((squeeze_ - 1.0) * s * c, c * c + squeeze_ * s * s);
    }

    void divide(Vec along) {
        using std::numbers::pi;
        if (region_.dark()) return;
        // Azimuths are measured from the region's middle, so that those of a narrow region keep their digits.
        const Vec middle = region_.middle();
        const Vec toward = middle - pole_ * dot(pole_, middle);
        along_ = unit(along - pole_ * dot(pole_, along));
        zero_ = shading::length(toward) > 1e-9 ? unit(toward) : along_;
        zero_ = unit(zero_ - pole_ * dot(pole_, zero_));
        quarter_ = cross(pole_, zero_);
        // The azimuth of `zero_` measured from `along_`.
        offset_ = std::atan2(dot(zero_, cross(pole_, along_)), dot(zero_, along_));
        struct Turn {
            double azimuth;
            bool edge;
        };
        std::vector<Turn> turns;
        for (const Vec& point : region_.turns(pole_)) {
            const double x = dot(point, zero_);
            const double y = dot(point, quarter_);
            if (x != 0.0 || y != 0.0) turns.push_back({std::atan2(y, x), false});
        }
        if (edges_.azimuths.empty())
            for (int k = 0; k < 4; ++k) // the axes of the peak
                turns.push_back({std::remainder(0.5 * pi * k - offset_, 2.0 * pi), edged_});
        for (const double azimuth : edges_.azimuths)
            turns.push_back({std::remainder(azimuth - offset_, 2.0 * pi), true});
        std::sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) { return a.azimuth < b.azimuth; });
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const Turn& next = turns[i + 1 < turns.size() ? i + 1 : 0];
            const double from = turns[i].azimuth;
            const double to = i + 1 < turns.size() ? next.azimuth : next.azimuth + 2.0 * pi;
            const Vec between = tangent(0.5 * (from + to));
            const PolarInterval seen = region_.along(pole_, between);
            if (!(from < to) || seen.empty()) continue;
            sections_.push_back({squeezed(from + offset_), squeezed(to + offset_),
                                 !edged_ && seen.to >= region_.above(pole_, between).to, turns[i].edge && next.edge});
        }
    }

    Vec tangent(double azimuth) const { return zero_ * std::cos(azimuth) + quarter_ * std::sin(azimuth); }

    void begin(std::size_t section) {
        const Ray ray = cast(section, 0.5);
        const double wanted = 0.5 * (ray.s1 - ray.s0);
        const std::size_t pieces = wanted > 1.0 && !edged_ ? static_cast<std::size_t>(std::min(wanted, 8.0)) : 1;
        for (std::size_t i = 0; i < pieces; ++i) {
            Cell cell;
            cell.section = section;
            cell.u0 = static_cast<double>(i) / static_cast<double>(pieces);
            cell.u1 = static_cast<double>(i + 1) / static_cast<double>(pieces);
            evaluate(cell);
            if (edged_) {
                cells_.push_back(cell);
                continue;
            }
            for (const Cell& half : halves(cell))
                cells_.push_back(half);
        }
    }

    // If the halves' sum differs from the whole by more than its error estimate, the estimate missed an error; the
    // halves inherit it.
    std::array<Cell, 2> halves(const Cell& cell) {
        std::array<Cell, 2> made{cell, cell};
        if (cell.error_t > cell.error_u)
            made[0].t1 = made[1].t0 = 0.5 * (cell.t0 + cell.t1);
        else
            made[0].u1 = made[1].u0 = 0.5 * (cell.u0 + cell.u1);
        for (Cell& half : made)
            evaluate(half);
        const double moved = std::abs(made[0].value + made[1].value - cell.value);
        const double seen = made[0].error() + made[1].error();
        if (moved > cell.error_t + cell.error_u)
            for (Cell& half : made)
                half.rounding += inherited * moved * (seen > 0.0 ? half.error() / seen : 0.5);
        return made;
    }

    struct Ray {
        Vec tangent{0.0, 0.0, 0.0};
        double width = 1.0;
        double s0 = 0.0, s1 = 0.0; // the angle is width sinh s
        double measure = 0.0;      // dφ/dt
    };

    Ray cast(std::size_t section, double t) const {
        const auto [from, to, horizon, even] = sections_[section];
        const double rest = 1.0 - t;
        const double psi =
            even ? from + (to - from) * t : from + (to - from) * t * t * t * (10.0 - t * (15.0 - 6.0 * t));
        const double crowding = even ? 1.0 : 30.0 * t * t * rest * rest;
        const double c = std::cos(psi);
        const double s = squeeze_ * std::sin(psi);
        const double norm = std::sqrt(c * c + s * s);
        Ray ray;
        // The width along φ, where cos φ = c/norm and sin φ = s/norm.
        ray.width = width_ * norm;
        ray.measure = (to - from) * crowding * squeeze_ / (norm * norm);
        ray.tangent = tangent(stretched(psi) - offset_);
        const PolarInterval seen = region_.along(pole_, ray.tangent);
        if (seen.empty()) return ray;
        ray.s0 = std::asinh(seen.from / ray.width);
        ray.s1 = std::asinh(seen.to / ray.width);
        return ray;
    }

    // Sums by Kronrod's and by Gauss's rule.
    struct RayIntegral {
        double kronrod = 0.0;
        double gauss = 0.0;
    };

    // The directions of a cell at which the integrand is needed, of one ray after the other, and what its values there
    // are multiplied by.
    struct Nodes {
        std::vector<Vec> directions;
        std::vector<double> factors;
        std::vector<double> values;
        std::vector<double> shares; // of the pieces of rays: of u1 − u0

        void clear() {
            directions.clear();
            factors.clear();
            shares.clear();
        }
    };

    // Over u from u0 to u1, per du/2 there.
    template<std::size_t count>
    void add_piece(const GaussKronrod<count>& rule, const Ray& ray, bool horizon, double u0, double u1, double share) {
        const double reach = ray.s1 - ray.s0;
        for (std::size_t j = 0; j < count; ++j) {
            const double u = 0.5 * (u0 + u1) + 0.5 * (u1 - u0) * rule.node[j];
            const double left = 1.0 - u;
            const double s = ray.s0 + reach * (horizon ? 1.0 - left * left * left : u);
            const double theta = ray.width * std::sinh(s);
            const double sine = std::sin(theta);
            nodes_.directions.push_back(pole_ * std::cos(theta) + ray.tangent * sine);
            nodes_.factors.push_back(sine * std::sqrt(theta * theta + ray.width * ray.width) *
                                     (horizon ? 3.0 * left * left : 1.0));
        }
        nodes_.shares.push_back(share);
    }

    // The same, divided where the ray crosses edges.
    template<std::size_t count>
    void add_pieces(const GaussKronrod<count>& rule, const Ray& ray, double u0, double u1) {
        const double reach = ray.s1 - ray.s0;
        const auto angle_at = [&](double u) { return ray.width * std::sinh(ray.s0 + reach * u); };
        const double last = angle_at(u1);
        double from = u0;
        const auto add = [&](double to) {
            add_piece(rule, ray, false, from, to, (to - from) / (u1 - u0));
            from = to;
        };
        for (auto edge = std::upper_bound(edges_.angles.begin(), edges_.angles.end(), angle_at(u0));
             edge != edges_.angles.end() && *edge < last; ++edge) {
            const double to = (std::asinh(*edge / ray.width) - ray.s0) / reach;
            if (to > from && to < u1) add(to);
        }
        add(u1);
    }

    // Over pieces of a ray, from the first node on.
    template<std::size_t count>
    RayIntegral sum_of(const GaussKronrod<count>& rule, std::span<const double> shares, std::size_t node) const {
        RayIntegral sums;
        for (const double share : shares) {
            RayIntegral piece;
            for (std::size_t j = 0; j < count; ++j, ++node) {
                const double f = nodes_.values[node] * nodes_.factors[node];
                piece.kronrod += rule.kronrod[j] * f;
                piece.gauss += rule.gauss[j] * f;
            }
            sums.kronrod += share * piece.kronrod;
            sums.gauss += share * piece.gauss;
        }
        return sums;
    }

    void evaluate(Cell& cell) {
        if (edged_)
            evaluate_by(kronrod_7, cell);
        else
            evaluate_by(kronrod_15, cell);
    }

    template<std::size_t count>
    void evaluate_by(const GaussKronrod<count>& rule, Cell& cell) {
        std::array<double, count> measures{};  // of the rays
        std::array<std::size_t, count> ends{}; // of their pieces
        const bool horizon = sections_[cell.section].horizon;
        nodes_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const double t = 0.5 * (cell.t0 + cell.t1) + 0.5 * (cell.t1 - cell.t0) * rule.node[i];
            const Ray ray = cast(cell.section, t);
            const double reach = ray.s1 - ray.s0;
            if (reach > 0.0 && edged_)
                add_pieces(rule, ray, cell.u0, cell.u1);
            else if (reach > 0.0)
                add_piece(rule, ray, horizon, cell.u0, cell.u1, 1.0);
            measures[i] = ray.measure * reach;
            ends[i] = nodes_.shares.size();
        }
        nodes_.values.resize(nodes_.directions.size());
        integrand_(nodes_.directions, nodes_.values);
        evaluations_ += nodes_.directions.size();
        double kk = 0.0;
        double gk = 0.0; // Gauss over the azimuth
        double kg = 0.0; // Gauss along the rays
        for (std::size_t i = 0, first = 0; i < count; first = ends[i++]) {
            const auto shares = std::span<const double>(nodes_.shares).subspan(first, ends[i] - first);
            const RayIntegral sums = sum_of(rule, shares, first * count);
            kk += rule.kronrod[i] * sums.kronrod * measures[i];
            gk += rule.gauss[i] * sums.kronrod * measures[i];
            kg += rule.kronrod[i] * sums.gauss * measures[i];
        }
        const double area = 0.25 * (cell.t1 - cell.t0) * (cell.u1 - cell.u0);
        cell.value = kk * area;
        cell.error_t = std::abs(kk - gk) * area;
        cell.error_u = std::abs(kk - kg) * area;
        cell.rounding = (4e-15 + 2e-16 / region_.reach()) * std::abs(cell.value);
    }

    static constexpr double inherited = 0.25;
    static constexpr std::size_t patience = 512;

    const LightRegion& region_;
    const Integrand& integrand_;
    Vec pole_;
    double width_;
    double squeeze_;
    PolarEdges edges_;
    bool edged_;
    Vec along_{}, zero_{}, quarter_{};
    double offset_ = 0.0;
    std::vector<Section> sections_;
    std::vector<Cell> cells_;
    Nodes nodes_;
    std::size_t evaluations_ = 0;
};

} // namespace gonio::detail
