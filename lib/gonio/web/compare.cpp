#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
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
    Comparison(const Web& a, const Web& b, double smallest_deg) : a_(a), b_(b), smallest_deg_(smallest_deg) {}

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
        for (std::size_t i = 1; i < grid.horizontal.size(); ++i)
            for (std::size_t j = 1; j < grid.vertical.size(); ++j)
                cell({grid.horizontal[i - 1], grid.horizontal[i]}, {grid.vertical[j - 1], grid.vertical[j]},
                     steps_across[i] || steps_down[j]);
    }

    void over_directions() {
        constexpr double step = 0.5;
        for (int i = 0; i < 720; ++i)
            for (int j = 0; j <= 360; ++j) {
                const double c = step * i;
                const double gamma = step * j;
                const double a_cd = a_.candela(c, gamma);
                const double b_cd = b_.candela(c, gamma);
                look_at({c, gamma}, a_cd, b_cd);
                square_sum_ += (a_cd - b_cd) * (a_cd - b_cd) * std::sin(gamma * radians_per_degree) * step * step *
                               radians_per_degree * radians_per_degree;
            }
        for (const Web* const web : {&a_, &b_})
            for (const double h : web->horizontal_deg())
                for (const double v : web->vertical_deg()) {
                    const glm::dvec3 direction = direction_of(web->photometry(), {h, v});
                    look_at(angles_of(Photometry::c, direction), a_.candela(direction), b_.candela(direction));
                }
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

    // The corner values of a bilinear function in a cell, extrapolated from four points inside it, because the web may
    // jump at the cell's edges.
    // In the order (low, low), (low, high), (high, low), (high, high).
    using Corners = std::array<double, 4>;
    static Corners corners(const Web& web, Interval h, Interval v) {
        const auto at = [&](double x, double y) {
            return web.candela_at(h.low + x * (h.high - h.low), v.low + y * (v.high - v.low));
        };
        const auto ends = [](double quarter, double three_quarters) {
            return std::array{1.5 * quarter - 0.5 * three_quarters, 1.5 * three_quarters - 0.5 * quarter};
        };
        const std::array left = ends(at(0.25, 0.25), at(0.25, 0.75));
        const std::array right = ends(at(0.75, 0.25), at(0.75, 0.75));
        const std::array low = ends(left[0], right[0]);
        const std::array high = ends(left[1], right[1]);
        return {low[0], high[0], low[1], high[1]};
    }

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

    void cell(Interval h, Interval v, bool in_step) {
        const Corners a = corners(a_, h, v);
        const Corners b = corners(b_, h, v);
        Corners d{};
        for (std::size_t k = 0; k < 4; ++k) {
            d[k] = a[k] - b[k];
            if (in_step)
                found_.in_steps = Candelas(std::max(found_.in_steps.value, std::abs(d[k])));
            else
                look_at(c_gamma(k < 2 ? h.low : h.high, k % 2 == 0 ? v.low : v.high), a[k], b[k]);
        }
        add_squares(d, h, v);
    }

    const Web& a_;
    const Web& b_;
    double smallest_deg_;
    WebDifference found_;
    double square_sum_ = 0.0;
};

} // namespace

WebDifference difference(const Web& a, const Web& b, double smallest_deg) {
    Comparison comparison(a, b, smallest_deg);
    if (a.photometry() == b.photometry())
        comparison.over_cells(union_grid(a, b));
    else
        comparison.over_directions();
    return comparison.result();
}

} // namespace gonio
