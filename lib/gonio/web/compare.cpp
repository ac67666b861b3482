#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/greatest_difference.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plane_rows.hpp>
#include <gonio/web/quick_web.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/web_rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

void append(std::vector<double>& to, std::span<const double> from) {
    to.insert(to.end(), from.begin(), from.end());
}

// The angles between which both webs are bilinear, with mirrors written out.
struct Grid {
    std::vector<double> horizontal;
    std::vector<double> vertical;
};

Grid union_grid(const Web& a, const Web& b) {
    Grid grid;
    for (const Web* const web : {&a, &b}) {
        append(grid.vertical, web->vertical_deg());
        if (web->photometry() == Photometry::c) {
            append(grid.horizontal, plane_bends_deg(*web));
            append(grid.horizontal, std::array{0.0, 360.0});
            append(grid.vertical, std::array{0.0, 180.0});
            continue;
        }
        for (const double h : web->horizontal_deg())
            append(grid.horizontal, std::array{h, -h});
        for (const double v : web->vertical_deg())
            grid.vertical.push_back(-v);
    }
    // The measure of solid angle is not linear either: latitudes are cut every 15° for the mean square.
    std::vector<double>& latitudes = a.photometry() == Photometry::b ? grid.horizontal : grid.vertical;
    const auto [low, high] = std::minmax_element(latitudes.begin(), latitudes.end());
    const double first = *low;
    const double last = *high;
    for (int step = static_cast<int>(std::ceil(first / 15.0)); step * 15.0 < last; ++step)
        latitudes.push_back(step * 15.0);
    sort_unique(grid.horizontal);
    sort_unique(grid.vertical);
    return grid;
}

class Comparison {
public:
    Comparison(const Web& a, const Web& b, double smallest_deg, bool with_squares)
        : a_(a), b_(b), smallest_deg_(smallest_deg), with_squares_(with_squares) {}

    void look_at(GoniometerAngles c_gamma, double a_cd, double b_cd) {
        const double d = std::abs(a_cd - b_cd);
        if (d <= found_.greatest.value) return;
        found_.greatest = Candelas(d);
        found_.c_deg = c_gamma.horizontal_deg;
        found_.gamma_deg = c_gamma.vertical_deg;
        found_.a = Candelas(a_cd);
        found_.b = Candelas(b_cd);
    }

    void over_cells(const Grid& grid) {
        found_.exact = true;
        const std::vector<bool> steps_across = steps(grid.horizontal);
        const std::vector<bool> steps_down = steps(grid.vertical);
        QuarterPoints of_a(a_, grid.vertical);
        QuarterPoints of_b(b_, grid.vertical);
        for (std::size_t i = 1; i < grid.horizontal.size(); ++i) {
            const Interval across{grid.horizontal[i - 1], grid.horizontal[i]};
            of_a.move_to(across);
            of_b.move_to(across);
            for (std::size_t j = 1; j < grid.vertical.size(); ++j)
                cell(across, {grid.vertical[j - 1], grid.vertical[j]}, of_a.corners(j - 1), of_b.corners(j - 1),
                     steps_across[i] || steps_down[j]);
        }
    }

    // Of two types, of which one is A or B.
    void over_directions() {
        constexpr double step = 0.5;
        std::vector<double> gammas;
        for (int j = 0; j <= 360; ++j)
            gammas.push_back(step * j);
        web_detail::WebRows of_a(a_, gammas);
        web_detail::WebRows of_b(b_, gammas);
        const double margin_cd = of_a.margin_cd() + of_b.margin_cd();
        for (int i = 0; i < 720; ++i) {
            const double c = step * i;
            const std::span<const double> a_row = with_squares_ ? of_a.exact(c) : of_a.quick(c);
            const std::span<const double> b_row = with_squares_ ? of_b.exact(c) : of_b.quick(c);
            for (std::size_t j = 0; j < gammas.size(); ++j) {
                const double d = a_row[j] - b_row[j];
                if (with_squares_) {
                    look_at({c, gammas[j]}, a_row[j], b_row[j]);
                    square_sum_ += d * d * std::sin(gammas[j] * radians_per_degree) * step * step * radians_per_degree *
                                   radians_per_degree;
                } else if (std::abs(d) + margin_cd > found_.greatest.value) {
                    look_at({c, gammas[j]}, a_.candela(c, gammas[j]), b_.candela(c, gammas[j]));
                }
            }
        }
        over_tables();
    }

    WebDifference result() {
        found_.rms = Candelas(std::sqrt(square_sum_ / (4.0 * pi)));
        found_.flux_a = flux(a_);
        found_.flux_b = flux(b_);
        const double top = std::max(peak(a_).intensity.value, peak(b_).intensity.value);
        settle(a_, top, found_.a);
        settle(b_, top, found_.b);
        found_.greatest = Candelas(std::abs(found_.a.value - found_.b.value));
        found_.relative = found_.greatest.value > 0.0 ? found_.greatest.value / std::abs(top) : 0.0;
        return found_;
    }

private:
    // Of each cell, by its upper end, whether it belongs to a run of cells that is narrower than the smallest angle:
    // cells are a run while they are narrower than that themselves.
    std::vector<bool> steps(const std::vector<double>& angles) const {
        std::vector<bool> in_step(angles.size(), false);
        for (std::size_t first = 1; first < angles.size();) {
            std::size_t end = first;
            while (end < angles.size() && angles[end] - angles[end - 1] < smallest_deg_)
                ++end;
            if (end > first && angles[end - 1] - angles[first - 1] < smallest_deg_)
                std::fill(in_step.begin() + static_cast<std::ptrdiff_t>(first),
                          in_step.begin() + static_cast<std::ptrdiff_t>(end), true);
            first = end + 1;
        }
        return in_step;
    }

    struct Interval {
        double low;
        double high;
    };

    // At the points of the tables of two webs of different types, which are asked exactly only where the difference may
    // be the greatest.
    void over_tables() {
        const QuickWeb quick_a(a_);
        const QuickWeb quick_b(b_);
        const double margin_cd = quick_a.margin_cd() + quick_b.margin_cd();
        std::vector<glm::dvec3> directions;
        std::vector<double> a_row;
        std::vector<double> b_row;
        for (const Web* const web : {&a_, &b_}) {
            const std::span<const double> vertical_deg = web->vertical_deg();
            directions.resize(vertical_deg.size());
            a_row.resize(vertical_deg.size());
            b_row.resize(vertical_deg.size());
            for (const double h : web->horizontal_deg()) {
                for (std::size_t j = 0; j < vertical_deg.size(); ++j)
                    directions[j] = direction_of(web->photometry(), {h, vertical_deg[j]});
                quick_a.candela(directions, a_row);
                quick_b.candela(directions, b_row);
                for (std::size_t j = 0; j < vertical_deg.size(); ++j) {
                    if (std::abs(a_row[j] - b_row[j]) + margin_cd <= found_.greatest.value) continue;
                    const glm::dvec3& direction = directions[j];
                    look_at(angles_of(Photometry::c, direction), a_.candela(direction), b_.candela(direction));
                }
            }
        }
    }

    // In the order (low, low), (low, high), (high, low), (high, high).
    using Corners = std::array<double, 4>;

    // The corner values of a bilinear function in a cell, extrapolated from four points inside it, because the web may
    // jump at the cell's edges.
    class QuarterPoints {
    public:
        QuarterPoints(const Web& web, const std::vector<double>& vertical) : rows_(web, quarters(vertical)) {}

        // To the cells between two horizontal angles.
        void move_to(Interval h) {
            fill(h.low + 0.25 * (h.high - h.low), left_);
            fill(h.low + 0.75 * (h.high - h.low), right_);
        }

        // Of the cell that begins at a vertical angle.
        [[nodiscard]] Corners corners(std::size_t at) const {
            const auto ends = [](double quarter, double three_quarters) {
                return std::array{1.5 * quarter - 0.5 * three_quarters, 1.5 * three_quarters - 0.5 * quarter};
            };
            const std::array left = ends(left_[2 * at], left_[2 * at + 1]);
            const std::array right = ends(right_[2 * at], right_[2 * at + 1]);
            const std::array low = ends(left[0], right[0]);
            const std::array high = ends(left[1], right[1]);
            return {low[0], high[0], low[1], high[1]};
        }

    private:
        static std::vector<double> quarters(const std::vector<double>& vertical) {
            std::vector<double> angles;
            for (std::size_t j = 1; j < vertical.size(); ++j)
                for (const double y : {0.25, 0.75})
                    angles.push_back(vertical[j - 1] + y * (vertical[j] - vertical[j - 1]));
            return angles;
        }

        void fill(double horizontal_deg, std::vector<double>& to) const {
            to.clear();
            rows_.append(horizontal_deg, to);
        }

        web_detail::PlaneRows rows_;
        std::vector<double> left_;
        std::vector<double> right_;
    };

    // Uses the table's own number if it equals the corner value found from within a cell, except for rounding.
    void settle(const Web& web, double top, Candelas& found) const {
        const double cd = web.candela(found_.c_deg, found_.gamma_deg);
        if (std::abs(cd - found.value) <= 1e-12 * std::abs(top)) found = Candelas(cd);
    }

    GoniometerAngles c_gamma(double h, double v) const {
        if (a_.photometry() == Photometry::c) return {h == 360.0 ? 0.0 : h, v};
        return angles_of(Photometry::c, direction_of(a_.photometry(), {h, v}));
    }

    // ∬ d² dω: three Gauss–Legendre nodes in each direction, exact in the angles and to 1e-9 in the measure.
    void add_squares(const Corners& d, Interval h, Interval v) {
        constexpr auto rule = gauss_legendre<3>();
        double sum = 0.0;
        for (const QuadratureNode& across : rule)
            for (const QuadratureNode& down : rule) {
                const double x = 0.5 * (1.0 + across.at);
                const double y = 0.5 * (1.0 + down.at);
                const double low = d[0] + y * (d[1] - d[0]);
                const double high = d[2] + y * (d[3] - d[2]);
                const double here = low + x * (high - low);
                const double horizontal = h.low + x * (h.high - h.low);
                const double vertical = v.low + y * (v.high - v.low);
                double measure = std::sin(vertical * radians_per_degree);
                if (a_.photometry() == Photometry::a) measure = std::cos(vertical * radians_per_degree);
                if (a_.photometry() == Photometry::b) measure = std::cos(horizontal * radians_per_degree);
                sum += 0.25 * across.weight * down.weight * here * here * measure;
            }
        square_sum_ += sum * (h.high - h.low) * (v.high - v.low) * radians_per_degree * radians_per_degree;
    }

    void cell(Interval h, Interval v, const Corners& a, const Corners& b, bool in_step) {
        Corners d{};
        for (std::size_t k = 0; k < 4; ++k) {
            d[k] = a[k] - b[k];
            if (in_step)
                found_.in_steps = Candelas(std::max(found_.in_steps.value, std::abs(d[k])));
            else
                look_at(c_gamma(k < 2 ? h.low : h.high, k % 2 == 0 ? v.low : v.high), a[k], b[k]);
        }
        if (with_squares_) add_squares(d, h, v);
    }

    const Web& a_;
    const Web& b_;
    double smallest_deg_;
    bool with_squares_;
    WebDifference found_;
    double square_sum_ = 0.0;
};

WebDifference compared(const Web& a, const Web& b, double smallest_deg, bool with_squares) {
    Comparison comparison(a, b, smallest_deg, with_squares);
    if (a.photometry() == b.photometry())
        comparison.over_cells(union_grid(a, b));
    else
        comparison.over_directions();
    return comparison.result();
}

} // namespace

WebDifference difference(const Web& a, const Web& b, double smallest_deg) {
    return compared(a, b, smallest_deg, true);
}

WebDifference web_detail::greatest_difference(const Web& a, const Web& b) {
    return compared(a, b, 0.0, false);
}

} // namespace gonio
