#include <gonio/base/codes/result.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/smooth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

struct Sample {
    double at_deg;
    double value;
};

// The samples beyond the ends of a line, where it goes on: through the axis, or in a mirror.
struct Beyond {
    std::optional<Sample> before;
    std::optional<Sample> behind;
};

// The slope between two cells of widths h and secants s: that of the parabola through the three values, limited to what
// keeps both cells monotone; 0 at an extremum.
double inner_slope(double h0, double s0, double h1, double s1) {
    if (!(s0 * s1 > 0.0)) return 0.0;
    const double slope = (h1 * s0 + h0 * s1) / (h0 + h1);
    return std::copysign(std::min(std::abs(slope), 3.0 * std::min(std::abs(s0), std::abs(s1))), slope);
}

// The slope at an end, from the cell there and the next one: that of a parabola, limited to keep the cell monotone.
double end_slope(double h0, double s0, double h1, double s1) {
    const double slope = ((2.0 * h0 + h1) * s0 - h0 * s1) / (h0 + h1);
    if (!(slope * s0 > 0.0)) return 0.0;
    return std::abs(slope) > 3.0 * std::abs(s0) ? 3.0 * s0 : slope;
}

std::vector<double> slopes_of(std::span<const double> at, std::span<const double> value, const Beyond& beyond) {
    const std::size_t n = at.size();
    const auto width = [&](std::size_t i) { return at[i + 1] - at[i]; };
    const auto secant = [&](std::size_t i) { return (value[i + 1] - value[i]) / width(i); };
    std::vector<double> slopes(n);
    for (std::size_t i = 1; i + 1 < n; ++i)
        slopes[i] = inner_slope(width(i - 1), secant(i - 1), width(i), secant(i));
    const std::size_t last = n - 2;
    const auto end = [&](std::size_t cell, std::size_t next) {
        return n > 2 ? end_slope(width(cell), secant(cell), width(next), secant(next)) : secant(cell);
    };
    if (beyond.before) {
        const double h = at[0] - beyond.before->at_deg;
        slopes[0] = inner_slope(h, (value[0] - beyond.before->value) / h, width(0), secant(0));
    } else {
        slopes[0] = end(0, 1);
    }
    if (beyond.behind) {
        const double h = beyond.behind->at_deg - at[n - 1];
        slopes[n - 1] = inner_slope(width(last), secant(last), h, (beyond.behind->value - value[n - 1]) / h);
    } else {
        slopes[n - 1] = end(last, last - 1);
    }
    return slopes;
}

// Each cell divided into equal parts of at most `step`; the old angles stay as they are.
std::vector<double> divided(std::span<const double> angles, double step) {
    std::vector<double> finer;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        const double width = angles[i + 1] - angles[i];
        const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(width / step - 1e-9)));
        for (std::size_t k = 0; k < parts; ++k)
            finer.push_back(angles[i] + width * static_cast<double>(k) / static_cast<double>(parts));
    }
    finer.push_back(angles.back());
    return finer;
}

// The values of the cubics at the finer angles, which contain the old ones.
std::vector<double> on_finer(std::span<const double> at, std::span<const double> value, const Beyond& beyond,
                             std::span<const double> finer) {
    if (at.size() == 1) return {value[0]};
    const std::vector<double> slopes = slopes_of(at, value, beyond);
    std::vector<double> made;
    std::size_t cell = 0;
    for (const double angle : finer) {
        while (cell + 2 < at.size() && angle >= at[cell + 1])
            ++cell;
        const double h = at[cell + 1] - at[cell];
        const double t = (angle - at[cell]) / h;
        const double a = value[cell];
        const double b = value[cell + 1];
        // Hermite's form around the line between the values.
        const double bend =
            t * (1.0 - t) * ((1.0 - t) * (h * slopes[cell] - (b - a)) - t * (h * slopes[cell + 1] - (b - a)));
        const double cubic = a + t * (b - a) + bend;
        made.push_back(t <= 0.0 ? a : t >= 1.0 ? b : std::clamp(cubic, std::min(a, b), std::max(a, b))); // of rounding
    }
    return made;
}

// Whether the light is mirrored in the plane of a horizontal angle at which the stored ones end.
bool is_mirror(const Web& web, double angle_deg) {
    const Symmetry stored = web.stored_symmetry();
    if (stored == Symmetry::axial || stored == Symmetry::none) return false;
    if (web.photometry() != Photometry::c) return stored != Symmetry::bilateral_0_180 && angle_deg == 0.0;
    const AngleRange range = plane_range(stored);
    return angle_deg == range.low || angle_deg == range.high;
}

bool is_vertical_mirror(const Web& web, double angle_deg) {
    return web.photometry() != Photometry::c && angle_deg == 0.0 && mirrored_in_0_180(web.stored_symmetry());
}

Beyond beyond_column(const Web& web, std::size_t horizontal) {
    const std::span<const double> at = web.vertical_deg();
    const std::span<const double> value = web.column(horizontal);
    Beyond beyond;
    if (at.size() == 1) return beyond;
    if (is_vertical_mirror(web, at[0])) beyond.before = Sample{-at[1], value[1]};
    if (web.photometry() != Photometry::c) return beyond;
    // The opposite plane goes on behind the axis.
    const double opposite = web.horizontal_deg()[horizontal] + 180.0;
    const double next_to_last = at[at.size() - 2];
    if (at[0] == 0.0) beyond.before = Sample{-at[1], web.candela(opposite, at[1])};
    if (at.back() == 180.0) beyond.behind = Sample{360.0 - next_to_last, web.candela(opposite, next_to_last)};
    return beyond;
}

Beyond beyond_row(const Web& web, std::span<const double> row) {
    const std::span<const double> at = web.horizontal_deg();
    const std::size_t n = at.size();
    Beyond beyond;
    if (n == 1) return beyond;
    const bool full_turn = web.photometry() == Photometry::c && web.stored_symmetry() == Symmetry::none &&
                           at.front() == 0.0 && at.back() == 360.0 && row.front() == row.back();
    if (full_turn) {
        beyond.before = Sample{at[n - 2] - 360.0, row[n - 2]};
        beyond.behind = Sample{at[1] + 360.0, row[1]};
    }
    if (is_mirror(web, at.front())) beyond.before = Sample{2.0 * at.front() - at[1], row[1]};
    if (is_mirror(web, at.back())) beyond.behind = Sample{2.0 * at.back() - at[n - 2], row[n - 2]};
    return beyond;
}

} // namespace

Result<Web> smoothed(const Web& web, double step_deg) {
    if (!(step_deg >= 0.05 && step_deg <= 90.0))
        return fail("USE0106", fmt::format("a step of {}° is not from 0.05° to 90°", step_deg), "for example 1deg");
    const std::span<const double> old_horizontal = web.horizontal_deg();
    const std::span<const double> old_vertical = web.vertical_deg();
    std::vector<double> horizontal = divided(old_horizontal, step_deg);
    std::vector<double> vertical = divided(old_vertical, step_deg);
    constexpr std::size_t most = 2'000'000;
    if (horizontal.size() > most / vertical.size())
        return fail("USE0106", fmt::format("the table would have {} by {} angles", horizontal.size(), vertical.size()),
                    "take a longer step, for example 1deg");
    std::vector<std::vector<double>> columns; // old horizontal, new vertical
    for (std::size_t i = 0; i < old_horizontal.size(); ++i)
        columns.push_back(on_finer(old_vertical, web.column(i), beyond_column(web, i), vertical));
    std::vector<double> candela(horizontal.size() * vertical.size());
    std::vector<double> row(old_horizontal.size());
    for (std::size_t k = 0; k < vertical.size(); ++k) {
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = columns[i][k];
        const std::vector<double> finer = on_finer(old_horizontal, row, beyond_row(web, row), horizontal);
        for (std::size_t i = 0; i < finer.size(); ++i)
            candela[i * vertical.size() + k] = finer[i];
    }
    return Web::create(web.photometry(), web.stored_symmetry(), std::move(horizontal), std::move(vertical),
                       std::move(candela));
}

Result<Web> smoothed(const Web& web, double step_deg, const std::string& file, Diagnostics& diagnostics) {
    Result<Web> smooth = smoothed(web, step_deg);
    if (!smooth) return smooth;
    diagnostics.push_back(result_diagnostic(
        "RES0208",
        fmt::format("a smooth curve through {} by {} angles: {:.6g} lm instead of {:.6g} lm",
                    web.horizontal_deg().size(), web.vertical_deg().size(), flux(*smooth).value, flux(web).value),
        {}, file));
    return smooth;
}

} // namespace gonio
