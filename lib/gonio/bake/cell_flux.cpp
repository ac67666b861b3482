#include <gonio/bake/cell_flux.hpp>
#include <gonio/base/gauss_legendre.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr auto four = gauss_legendre<4>();
constexpr auto six = gauss_legendre<6>();
constexpr auto twelve = gauss_legendre<12>();

// Where f changes sign between a and b, by the Illinois method; f(a) and f(b) are given and differ in sign.
template<class F>
double root(double a, double b, double fa, double fb, F&& f) {
    for (int step = 0; step < 40 && b - a > 1e-13; ++step) {
        const double c = std::clamp((a * fb - b * fa) / (fb - fa), a, b);
        const double fc = f(c);
        if (fc == 0.0) return c;
        if ((fc < 0.0) == (fb < 0.0)) {
            if (std::abs(b - c) < 1e-13) return c;
            b = c;
            fb = fc;
            fa *= 0.5;
        } else {
            if (std::abs(c - a) < 1e-13) return c;
            a = c;
            fa = fc;
            fb *= 0.5;
        }
    }
    return 0.5 * (a + b);
}

// For a piece that ends where the map has a corner; edges run straight there.
constexpr int most_halvings = 4;

// Line integrals along one edge of a texel: one of s and t varies, the other is fixed.
class Edge {
public:
    Edge(const Meridians& meridians, const Chart& chart, bool along_s, double fixed)
        : meridians_(meridians), chart_(chart), along_s_(along_s), fixed_(fixed) {}

    EdgeSums between(double from, double to) {
        cuts_.assign({from, to});
        chart_.folds(along_s_, fixed_, from, to, cuts_);
        std::sort(cuts_.begin(), cuts_.end());
        EdgeSums sums;
        for (std::size_t i = 1; i < cuts_.size(); ++i)
            if (cuts_[i] > cuts_[i - 1]) sums += smooth(cuts_[i - 1], cuts_[i]);
        return sums;
    }

private:
    // A point of the edge in the goniometer's frame, and its derivative.
    struct Place {
        glm::dvec3 at; // of unit length
        glm::dvec3 moves;
    };

    [[nodiscard]] Place place(double x) const {
        const ChartPoint point = along_s_ ? chart_.at(x, fixed_) : chart_.at(fixed_, x);
        const double scale = 1.0 / glm::length(point.direction);
        const glm::dvec3 at = meridians_.local(point.direction) * scale;
        const glm::dvec3 moves = meridians_.local(along_s_ ? point.along_s : point.along_t) * scale;
        return {at, moves - glm::dot(moves, at) * at};
    }

    // A piece without folds: cut into short ones, so that θ turns at most once and α takes the short way.
    EdgeSums smooth(double from, double to) {
        // The ends may be the same direction, so the length of the path counts; sampled inside the folds, where the map
        // is that of the piece.
        double speed = 0.0;
        for (const double share : {0.001, 0.5, 0.999})
            speed = std::max(speed, glm::length(place(from + share * (to - from)).moves));
        const int pieces = std::max(1, static_cast<int>(std::ceil(speed * (to - from) / 0.2)));
        EdgeSums sums;
        for (int i = 0; i < pieces; ++i) {
            const double a = from + (to - from) * i / pieces;
            const double b = i + 1 == pieces ? to : from + (to - from) * (i + 1) / pieces;
            sums += short_piece(a, b);
        }
        return sums;
    }

    EdgeSums short_piece(double from, double to) {
        const auto turn = [&](double x) { return place(x).moves.z; };
        // The derivative on this side of the fold, not on the other side.
        const double inside = 1e-9 * (to - from);
        const double turn_from = turn(from + inside);
        const double turn_to = turn(to - inside);
        if ((turn_from < 0.0) == (turn_to < 0.0) || turn_from == 0.0 || turn_to == 0.0) return monotonic(from, to);
        const double middle = root(from + inside, to - inside, turn_from, turn_to, turn);
        EdgeSums sums = monotonic(from, middle);
        sums += monotonic(middle, to);
        return sums;
    }

    // A piece along which θ is monotonic.
    EdgeSums monotonic(double from, double to) {
        const glm::dvec3 begin = place(from).at;
        const glm::dvec3 end = place(to).at;
        breaks_.clear();
        const double low = std::min(begin.z, end.z);
        const double high = std::max(begin.z, end.z);
        for (const double cosine : meridians_.polar_break_cosines())
            if (cosine > low && cosine < high)
                breaks_.push_back(
                    root(from, to, begin.z - cosine, end.z - cosine, [&](double x) { return place(x).at.z - cosine; }));
        add_azimuth_breaks(from, to, begin, end);
        breaks_.push_back(to);
        std::sort(breaks_.begin(), breaks_.end());
        EdgeSums sums;
        double last = from;
        for (const double next : breaks_) {
            if (next > last) sums += inside_cell(last, next);
            last = std::max(last, next);
        }
        return sums;
    }

    void add_azimuth_breaks(double from, double to, const glm::dvec3& begin, const glm::dvec3& end) {
        // At a pole every azimuth is valid: the piece takes that of its other end.
        if (std::hypot(begin.x, begin.y) < 1e-12 || std::hypot(end.x, end.y) < 1e-12) return;
        const double first = std::atan2(begin.y, begin.x);
        const double turned = std::remainder(std::atan2(end.y, end.x) - first, 2.0 * pi);
        for (const double azimuth : meridians_.azimuth_breaks()) {
            const double ahead = std::remainder(azimuth - first, 2.0 * pi);
            // In either direction, for turns of up to half a circle.
            const bool passed = turned > 0.0 ? ahead > 0.0 && ahead < turned : ahead < 0.0 && ahead > turned;
            if (!passed) continue;
            const double c = std::cos(azimuth);
            const double s = std::sin(azimuth);
            const auto beside = [&](const glm::dvec3& at) { return at.y * c - at.x * s; };
            const double at_begin = beside(begin);
            const double at_end = beside(end);
            if ((at_begin < 0.0) == (at_end < 0.0)) continue;
            breaks_.push_back(root(from, to, at_begin, at_end, [&](double x) { return beside(place(x).at); }));
        }
    }

    // Between two cuts: in one sector and one cell.
    EdgeSums inside_cell(double from, double to, int halvings = most_halvings) {
        const double middle = 0.5 * (from + to);
        const double half = 0.5 * (to - from);
        const Place center = place(middle);
        const double rho = std::hypot(center.at.x, center.at.y);
        const std::size_t sector = meridians_.sector_of(std::atan2(center.at.y, center.at.x));
        const std::size_t cell = meridians_.cell_of(std::atan2(rho, center.at.z));
        EdgeSums sums;
        const auto add = [&](double at, double weight) {
            const auto [p, moves] = place(middle + half * at);
            const double across = p.x * p.x + p.y * p.y;
            if (!(across > 0.0)) return; // on the pole: G vanishes there
            const double sine = std::sqrt(across);
            const double d_azimuth = weight * half * (p.x * moves.y - p.y * moves.x) / across;
            const double polar = std::atan2(sine, p.z);
            const Meridians::Integral g = meridians_.integral(sector, std::atan2(p.y, p.x), cell, polar, p.z, sine);
            sums.flux += g.to_here * d_azimuth;
            sums.far_flux += g.beyond * d_azimuth;
            // 1 − cosθ and −1 − cosθ, each in the form that does not cancel.
            const double from_near = p.z > 0.0 ? across / (1.0 + p.z) : 1.0 - p.z;
            const double from_far = p.z < 0.0 ? across / (1.0 - p.z) : 1.0 + p.z;
            sums.solid_angle += from_near * d_azimuth;
            sums.far_solid_angle -= from_far * d_azimuth;
        };
        // The number of nodes grows with the piece's length, estimated at its middle: in itself, around the pole, and
        // relative to the distance of a corner of the map.
        const double speed = glm::length(center.moves) * 2.0 * half;
        const double corner = 2.0 * half / chart_.smooth_within(along_s_ ? middle : fixed_, along_s_ ? fixed_ : middle);
        if (corner > 0.6 && halvings > 0) {
            sums = inside_cell(from, middle, halvings - 1);
            sums += inside_cell(middle, to, halvings - 1);
            return sums;
        }
        const double reach = std::max(std::max(speed, corner), rho > 0.0 ? speed / rho : pi);
        const auto add_all = [&](const auto& nodes) {
            for (const QuadratureNode& node : nodes)
                add(node.at, node.weight);
        };
        if (reach < 0.02)
            add_all(four);
        else if (reach < 0.15)
            add_all(six);
        else
            add_all(twelve);
        return sums;
    }

    const Meridians& meridians_;
    const Chart& chart_;
    bool along_s_;
    double fixed_;
    std::vector<double> cuts_;
    std::vector<double> breaks_;
};

enum class Poles { none, near, far, both };

// Which poles a cell may contain or touch. Overestimates: counting a cell from the far pole without need loses nothing.
Poles poles_in(const Meridians& meridians, const Chart& chart, const ChartCell& cell) {
    const auto unit = [&](double s, double t) { return glm::normalize(chart.at(s, t).direction); };
    const glm::dvec3 center = unit(0.5 * (cell.s0 + cell.s1), 0.5 * (cell.t0 + cell.t1));
    double radius = 0.0;
    for (const double s : {cell.s0, cell.s1})
        for (const double t : {cell.t0, cell.t1})
            radius = std::max(radius, glm::distance(center, unit(s, t)));
    const double reach = 1.6 * radius + 1e-9;
    const bool far = glm::distance(center, -meridians.pole()) <= reach;
    const bool near = glm::distance(center, meridians.pole()) <= reach;
    if (far) return near ? Poles::both : Poles::far;
    return near ? Poles::near : Poles::none;
}

} // namespace

EdgeSums& EdgeSums::operator+=(const EdgeSums& other) {
    flux += other.flux;
    solid_angle += other.solid_angle;
    far_flux += other.far_flux;
    far_solid_angle += other.far_solid_angle;
    return *this;
}

EdgeSums& EdgeSums::operator-=(const EdgeSums& other) {
    flux -= other.flux;
    solid_angle -= other.solid_angle;
    far_flux -= other.far_flux;
    far_solid_angle -= other.far_solid_angle;
    return *this;
}

EdgeSums edge_sums(const Meridians& meridians, const Chart& chart, bool along_s, double fixed, double from, double to) {
    return Edge(meridians, chart, along_s, fixed).between(from, to);
}

CellFlux inside(const EdgeSums& around, bool from_far_pole) {
    const double flux = from_far_pole ? around.far_flux : around.flux;
    const double solid_angle = from_far_pole ? around.far_solid_angle : around.solid_angle;
    return solid_angle < 0.0 ? CellFlux{-flux, -solid_angle} : CellFlux{flux, solid_angle};
}

bool may_hold_far_pole(const Meridians& meridians, const Chart& chart, const ChartCell& cell) {
    const Poles poles = poles_in(meridians, chart, cell);
    return poles == Poles::far || poles == Poles::both;
}

CellFlux cell_flux(const Meridians& meridians, const Chart& chart, const ChartCell& cell, int depth) {
    const Poles poles = poles_in(meridians, chart, cell);
    if (poles == Poles::both && depth < 12) {
        const double s = 0.5 * (cell.s0 + cell.s1);
        const double t = 0.5 * (cell.t0 + cell.t1);
        CellFlux sum;
        for (const ChartCell& part : {ChartCell{cell.s0, s, cell.t0, t}, ChartCell{s, cell.s1, cell.t0, t},
                                      ChartCell{cell.s0, s, t, cell.t1}, ChartCell{s, cell.s1, t, cell.t1}}) {
            const CellFlux flux = cell_flux(meridians, chart, part, depth + 1);
            sum.lumens += flux.lumens;
            sum.steradians += flux.steradians;
        }
        return sum;
    }
    EdgeSums around = edge_sums(meridians, chart, true, cell.t0, cell.s0, cell.s1);
    around += edge_sums(meridians, chart, false, cell.s1, cell.t0, cell.t1);
    around -= edge_sums(meridians, chart, true, cell.t1, cell.s0, cell.s1);
    around -= edge_sums(meridians, chart, false, cell.s0, cell.t0, cell.t1);
    // Away from the poles, count from the nearer pole; for a dark cell from the pole on its side of the light, so that
    // zero flux is exactly 0.
    const glm::dvec3 middle = chart.at(0.5 * (cell.s0 + cell.s1), 0.5 * (cell.t0 + cell.t1)).direction;
    const double cosine = glm::dot(middle, meridians.pole()) / glm::length(middle);
    const bool behind = cosine < std::cos(meridians.lit_polar_to());
    const bool before = cosine > std::cos(meridians.lit_polar_from());
    const bool beyond = poles == Poles::none && (behind || (cosine < 0.0 && !before));
    return inside(around, poles == Poles::far || beyond);
}

} // namespace gonio
