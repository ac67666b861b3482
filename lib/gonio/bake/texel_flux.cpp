#include <gonio/bake/texel_flux.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

// Gauss–Legendre on [−1, 1]: the nodes above 0 and their weights.
struct Node {
    double at;
    double weight;
};
constexpr std::array<Node, 2> four{{{0.33998104358485626, 0.65214515486254614}, //
                                    {0.86113631159405258, 0.34785484513745386}}};
constexpr std::array<Node, 3> six{{{0.23861918608319691, 0.46791393457269105},
                                   {0.66120938646626451, 0.36076157304813861},
                                   {0.93246951420315203, 0.17132449237917035}}};
constexpr std::array<Node, 6> twelve{{{0.12523340851146892, 0.24914704581340279},
                                      {0.36783149899818019, 0.23349253653835481},
                                      {0.58731795428661745, 0.20316742672306592},
                                      {0.76990267419430469, 0.16007832854334623},
                                      {0.90411725637047486, 0.10693932599531843},
                                      {0.98156063424671925, 0.04717533638651183}}};

// Around a texel, these are its flux and its solid angle up to a common sign: counted from the pole θ = 0, and from
// θ = π.
struct Sums {
    double flux = 0.0;
    double solid_angle = 0.0;
    double far_flux = 0.0;
    double far_solid_angle = 0.0;

    Sums& operator+=(const Sums& other) {
        flux += other.flux;
        solid_angle += other.solid_angle;
        far_flux += other.far_flux;
        far_solid_angle += other.far_solid_angle;
        return *this;
    }
    Sums& operator-=(const Sums& other) {
        flux -= other.flux;
        solid_angle -= other.solid_angle;
        far_flux -= other.far_flux;
        far_solid_angle -= other.far_solid_angle;
        return *this;
    }
};

// Where f changes its sign between a and b, by the Illinois method; f(a) and f(b) are given and differ in sign.
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

// Line integrals along one edge of a texel: s or t runs, the other is fixed.
class Edge {
public:
    Edge(const Meridians& meridians, const Chart& chart, bool along_s, double fixed)
        : meridians_(meridians), chart_(chart), along_s_(along_s), fixed_(fixed) {}

    Sums between(double from, double to) {
        cuts_.assign({from, to});
        chart_.folds(along_s_, fixed_, from, to, cuts_);
        std::sort(cuts_.begin(), cuts_.end());
        Sums sums;
        for (std::size_t i = 1; i < cuts_.size(); ++i)
            if (cuts_[i] > cuts_[i - 1]) sums += smooth(cuts_[i - 1], cuts_[i]);
        return sums;
    }

private:
    // A point of the edge in the goniometer's frame, and how it moves.
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

    // A piece without folds: cut into short ones, so that θ turns once at most and α goes the short way.
    Sums smooth(double from, double to) {
        // The ends may be one direction, so the way counts; taken inside the folds, where the map is the piece's own.
        double speed = 0.0;
        for (const double share : {0.001, 0.5, 0.999})
            speed = std::max(speed, glm::length(place(from + share * (to - from)).moves));
        const int pieces = std::max(1, static_cast<int>(std::ceil(speed * (to - from) / 0.2)));
        Sums sums;
        for (int i = 0; i < pieces; ++i) {
            const double a = from + (to - from) * i / pieces;
            const double b = i + 1 == pieces ? to : from + (to - from) * (i + 1) / pieces;
            sums += short_piece(a, b);
        }
        return sums;
    }

    Sums short_piece(double from, double to) {
        const auto turn = [&](double x) { return place(x).moves.z; };
        // The map's own derivative, not that of the fold's other side.
        const double inside = 1e-9 * (to - from);
        const double turn_from = turn(from + inside);
        const double turn_to = turn(to - inside);
        if ((turn_from < 0.0) == (turn_to < 0.0) || turn_from == 0.0 || turn_to == 0.0) return monotonic(from, to);
        const double middle = root(from + inside, to - inside, turn_from, turn_to, turn);
        Sums sums = monotonic(from, middle);
        sums += monotonic(middle, to);
        return sums;
    }

    // θ rises or falls all the way.
    Sums monotonic(double from, double to) {
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
        Sums sums;
        double last = from;
        for (const double next : breaks_) {
            if (next > last) sums += inside_cell(last, next);
            last = std::max(last, next);
        }
        return sums;
    }

    void add_azimuth_breaks(double from, double to, const glm::dvec3& begin, const glm::dvec3& end) {
        // At a pole every azimuth is right: the piece has that of its other end.
        if (std::hypot(begin.x, begin.y) < 1e-12 || std::hypot(end.x, end.y) < 1e-12) return;
        const double first = std::atan2(begin.y, begin.x);
        const double turned = std::remainder(std::atan2(end.y, end.x) - first, 2.0 * pi);
        for (const double azimuth : meridians_.azimuth_breaks()) {
            const double ahead = std::remainder(azimuth - first, 2.0 * pi);
            // Both ways around, for turns of up to half a circle.
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

    // Between two cuts: one sector, one cell.
    Sums inside_cell(double from, double to) {
        const double middle = 0.5 * (from + to);
        const double half = 0.5 * (to - from);
        const Place center = place(middle);
        const double rho = std::hypot(center.at.x, center.at.y);
        const std::size_t sector = meridians_.sector_of(std::atan2(center.at.y, center.at.x));
        const std::size_t cell = meridians_.cell_of(std::atan2(rho, center.at.z));
        Sums sums;
        const auto add = [&](double at, double weight) {
            const auto [p, moves] = place(middle + half * at);
            const double across = p.x * p.x + p.y * p.y;
            if (!(across > 0.0)) return; // on the pole: G vanishes there
            const double sine = std::sqrt(across);
            const double d_azimuth = weight * half * (p.x * moves.y - p.y * moves.x) / across;
            const double polar = std::atan2(sine, p.z);
            const Meridians::Integral g = meridians_.integral(sector, std::atan2(p.y, p.x), cell, polar, p.z, sine);
            sums.flux += g.to_here * d_azimuth;
            sums.far_flux += (g.to_here - g.to_far_pole) * d_azimuth;
            // 1 − cosθ and −1 − cosθ, each where it does not cancel.
            const double from_near = p.z > 0.0 ? across / (1.0 + p.z) : 1.0 - p.z;
            const double from_far = p.z < 0.0 ? across / (1.0 - p.z) : 1.0 + p.z;
            sums.solid_angle += from_near * d_azimuth;
            sums.far_solid_angle -= from_far * d_azimuth;
        };
        // As fine as the piece is long, seen from the middle or around the pole.
        const double speed = glm::length(center.moves) * 2.0 * half;
        const double reach = std::max(speed, rho > 0.0 ? speed / rho : pi);
        const auto add_all = [&](const auto& nodes) {
            for (const Node& node : nodes) {
                add(-node.at, node.weight);
                add(node.at, node.weight);
            }
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

// A texel, or a part of one.
struct Cell {
    double s0, s1, t0, t1;
};

enum class Poles { near_or_none, far, both };

// Which poles a cell may hold or touch. Generous: a cell that counts from the far pole without need loses nothing.
Poles poles_in(const Meridians& meridians, const Chart& chart, const Cell& cell) {
    const auto unit = [&](double s, double t) { return glm::normalize(chart.at(s, t).direction); };
    const glm::dvec3 center = unit(0.5 * (cell.s0 + cell.s1), 0.5 * (cell.t0 + cell.t1));
    double radius = 0.0;
    for (const double s : {cell.s0, cell.s1})
        for (const double t : {cell.t0, cell.t1})
            radius = std::max(radius, glm::distance(center, unit(s, t)));
    const double reach = 1.6 * radius + 1e-9;
    const bool far = glm::distance(center, -meridians.pole()) <= reach;
    const bool near = glm::distance(center, meridians.pole()) <= reach;
    return far ? (near ? Poles::both : Poles::far) : Poles::near_or_none;
}

struct Texel {
    double lumens;
    double steradians;
};

Texel oriented(const Sums& around, bool from_far_pole) {
    const double flux = from_far_pole ? around.far_flux : around.flux;
    const double solid_angle = from_far_pole ? around.far_solid_angle : around.solid_angle;
    return solid_angle < 0.0 ? Texel{-flux, -solid_angle} : Texel{flux, solid_angle};
}

// A cell that may hold both poles is cut until none does.
Texel alone(const Meridians& meridians, const Chart& chart, const Cell& cell, int depth) {
    const Poles poles = poles_in(meridians, chart, cell);
    if (poles == Poles::both && depth < 12) {
        const double s = 0.5 * (cell.s0 + cell.s1);
        const double t = 0.5 * (cell.t0 + cell.t1);
        Texel sum{0.0, 0.0};
        for (const Cell& part : {Cell{cell.s0, s, cell.t0, t}, Cell{s, cell.s1, cell.t0, t},
                                 Cell{cell.s0, s, t, cell.t1}, Cell{s, cell.s1, t, cell.t1}}) {
            const Texel texel = alone(meridians, chart, part, depth + 1);
            sum.lumens += texel.lumens;
            sum.steradians += texel.steradians;
        }
        return sum;
    }
    Sums around = Edge(meridians, chart, true, cell.t0).between(cell.s0, cell.s1);
    around += Edge(meridians, chart, false, cell.s1).between(cell.t0, cell.t1);
    around -= Edge(meridians, chart, true, cell.t1).between(cell.s0, cell.s1);
    around -= Edge(meridians, chart, false, cell.s0).between(cell.t0, cell.t1);
    return oriented(around, poles == Poles::far);
}

} // namespace

void TexelFlux::row(int j, std::span<double> lumens, std::span<double> steradians) const {
    const auto s_of = [&](int i) { return static_cast<double>(i) / width_; };
    const double t0 = static_cast<double>(j) / height_;
    const double t1 = static_cast<double>(j + 1) / height_;
    Edge top(meridians_, chart_, true, t0);
    Edge bottom(meridians_, chart_, true, t1);
    Sums left = Edge(meridians_, chart_, false, 0.0).between(t0, t1);
    for (int i = 0; i < width_; ++i) {
        const Cell cell{s_of(i), s_of(i + 1), t0, t1};
        Sums right = Edge(meridians_, chart_, false, cell.s1).between(t0, t1);
        const Poles poles = poles_in(meridians_, chart_, cell);
        Texel texel{0.0, 0.0};
        if (poles == Poles::both) {
            texel = alone(meridians_, chart_, cell, 0);
        } else {
            Sums around = top.between(cell.s0, cell.s1);
            around += right;
            around -= bottom.between(cell.s0, cell.s1);
            around -= left;
            texel = oriented(around, poles == Poles::far);
        }
        lumens[static_cast<std::size_t>(i)] = texel.lumens;
        steradians[static_cast<std::size_t>(i)] = texel.steradians;
        left = right;
    }
}

} // namespace gonio
