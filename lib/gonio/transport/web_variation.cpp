#include <gonio/base/quantity.hpp>
#include <gonio/transport/web_variation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace gonio::detail {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double unbounded = std::numeric_limits<double>::infinity();

// A web in the spherical coordinates of its goniometer.
struct Coordinates {
    explicit Coordinates(const Web& of_web) : web(of_web), is_transposed(of_web.photometry() == Photometry::b) {
        const bool has_latitudes = web.photometry() != Photometry::c;
        const Symmetry symmetry = web.stored_symmetry();
        const bool mirrors_x = mirrored_in_90_270(symmetry);
        const bool mirrors_y = mirrored_in_0_180(symmetry);
        for (const double deg : is_transposed ? web.vertical_deg() : web.horizontal_deg())
            longitudes.push_back(degrees(deg).value);
        for (const double deg : is_transposed ? web.horizontal_deg() : web.vertical_deg())
            gammas.push_back(degrees(has_latitudes ? deg + 90.0 : deg).value);
        if (web.photometry() == Photometry::a) axis = {0.0, -1.0, 0.0};
        if (web.photometry() == Photometry::b) axis = {-1.0, 0.0, 0.0};
        is_mirrored = has_latitudes && (is_transposed ? mirrors_x : mirrors_y);
        mirrors_first = has_latitudes ? (is_transposed ? mirrors_y : mirrors_x) : symmetry != Symmetry::none;
        mirrors_last = !has_latitudes && symmetry != Symmetry::none;
    }

    double at(std::size_t longitude, std::size_t gamma) const {
        return is_transposed ? web.column(gamma)[longitude] : web.column(longitude)[gamma];
    }
    bool is_dark(std::size_t longitude) const {
        for (std::size_t gamma = 0; gamma < gammas.size(); ++gamma)
            if (at(longitude, gamma) > 0.0) return false;
        return true;
    }

    const Web& web;
    bool is_transposed;
    std::vector<double> longitudes; // [rad]
    std::vector<double> gammas;     // from the axis [rad]
    glm::dvec3 axis{0.0, 0.0, -1.0};
    bool is_mirrored = false;   // at γ = 90°
    bool mirrors_first = false; // the grid at its first longitude
    bool mirrors_last = false;
};

// Whether the web is continuous where its longitudes end.
bool is_closed(const Coordinates& grid) {
    if (grid.longitudes.size() == 1) return grid.web.stored_symmetry() == Symmetry::axial;
    constexpr double deg = pi / 180.0;
    const auto is_at = [&](double longitude, double wanted_deg) {
        return std::abs(longitude - wanted_deg * deg) < 1e-12;
    };
    const double first = grid.longitudes.front();
    const double last = grid.longitudes.back();
    const std::size_t end = grid.longitudes.size() - 1;
    if (grid.mirrors_last) { // type C
        const Symmetry symmetry = grid.web.stored_symmetry();
        if (symmetry == Symmetry::quadrant) return is_at(first, 0.0) && is_at(last, 90.0);
        if (symmetry == Symmetry::bilateral_0_180) return is_at(first, 0.0) && is_at(last, 180.0);
        return is_at(first, 90.0) && is_at(last, 270.0);
    }
    if (grid.mirrors_first) return is_at(first, 0.0) && (grid.is_dark(end) || is_at(last, 180.0));
    if (grid.is_dark(0) && grid.is_dark(end)) return true;
    for (std::size_t gamma = 0; gamma < grid.gammas.size(); ++gamma)
        if (grid.at(0, gamma) != grid.at(end, gamma)) return false;
    return is_at(last - first, 360.0);
}

// A row of the grid: the greatest |∂I/∂C| [cd/rad], the greatest jump of it between planes, and the greatest jump of
// ∂I/∂γ between this row's sides.
struct Row {
    double gamma = 0.0; // [rad]
    double along_planes = 0.0;
    double plane_kink = 0.0;
    double gamma_kink = 0.0;
    double most = 0.0; // intensity [cd]
    bool is_dark = true;
};

// The cells between two rows.
struct Strip {
    double low = 0.0, high = 0.0; // γ [rad]
    double along_gamma = 0.0;     // |∂I/∂γ|
    double along_planes = 0.0;    // |∂I/∂C|/sinγ
    double twist = 0.0;           // |∂²I/∂γ∂C| [cd/rad²]
};

// The greatest |∂I/∂C|/sinγ between two rows, given its numerators there, between which it is linear.
double slope_across(const Row& a, const Row& b) {
    if (a.along_planes == 0.0 && b.along_planes == 0.0) return 0.0;
    const double sine_a = a.gamma > 0.0 ? std::sin(a.gamma) : 0.0;
    const double sine_b = b.gamma < pi ? std::sin(b.gamma) : 0.0;
    if (sine_a > 0.0 && sine_b > 0.0) return std::max(a.along_planes, b.along_planes) / std::min(sine_a, sine_b);
    if ((sine_a == 0.0 && a.along_planes > 0.0) || (sine_b == 0.0 && b.along_planes > 0.0)) return unbounded;
    return sine_a == 0.0 ? b.along_planes / sine_b : a.along_planes / sine_a; // γ/sinγ grows towards the other pole
}

class Grid {
public:
    explicit Grid(const Coordinates& web) : web_(web) {
        for (std::size_t row = 0; row < web.gammas.size(); ++row)
            rows.push_back(row_at(row));
        for (std::size_t row = 0; row + 1 < web.gammas.size(); ++row)
            strips.push_back(strip_at(row));
        for (std::size_t plane = 0; plane + 1 < web.longitudes.size(); ++plane)
            narrowest_rad = std::min(narrowest_rad, width_rad(plane));
    }

    std::vector<Row> rows;
    std::vector<Strip> strips;
    double narrowest_rad = unbounded; // between planes

private:
    double width_rad(std::size_t plane) const { return web_.longitudes[plane + 1] - web_.longitudes[plane]; }
    double slope_of_plane(std::size_t plane, std::size_t row) const {
        return (web_.at(plane + 1, row) - web_.at(plane, row)) / width_rad(plane);
    }
    double slope_of_gamma(std::size_t plane, std::size_t row) const {
        return (web_.at(plane, row + 1) - web_.at(plane, row)) / (web_.gammas[row + 1] - web_.gammas[row]);
    }

    Row row_at(std::size_t row) const {
        Row found;
        found.gamma = web_.gammas[row];
        for (std::size_t plane = 0; plane < web_.longitudes.size(); ++plane) {
            found.is_dark = found.is_dark && !(web_.at(plane, row) > 0.0);
            found.most = std::max(found.most, web_.at(plane, row));
            const bool has_after = row + 1 < web_.gammas.size();
            const double after = has_after ? slope_of_gamma(plane, row) : 0.0;
            double before = row > 0 ? slope_of_gamma(plane, row - 1) : 0.0;
            if (row == 0 && web_.is_mirrored) before = -after;
            found.gamma_kink = std::max(found.gamma_kink, std::abs(after - before));
        }
        const std::size_t last = web_.longitudes.size() - 1;
        for (std::size_t plane = 0; plane < last; ++plane) {
            const double slope = slope_of_plane(plane, row);
            found.along_planes = std::max(found.along_planes, std::abs(slope));
            const double before = plane > 0 ? slope_of_plane(plane - 1, row) : 0.0;
            found.plane_kink = std::max(found.plane_kink, std::abs(slope - before));
        }
        if (last == 0) return found;
        // At the ends the web is mirrored, dark beyond, or the turn closes.
        const double first = slope_of_plane(0, row);
        const double end = slope_of_plane(last - 1, row);
        found.plane_kink =
            std::max({found.plane_kink, 2.0 * std::abs(first), 2.0 * std::abs(end), std::abs(first - end)});
        return found;
    }

    Strip strip_at(std::size_t row) const {
        Strip found;
        found.low = rows[row].gamma;
        found.high = rows[row + 1].gamma;
        found.along_planes = slope_across(rows[row], rows[row + 1]);
        for (std::size_t plane = 0; plane < web_.longitudes.size(); ++plane)
            found.along_gamma = std::max(found.along_gamma, std::abs(slope_of_gamma(plane, row)));
        for (std::size_t plane = 0; plane + 1 < web_.longitudes.size(); ++plane)
            found.twist = std::max(found.twist, std::abs(slope_of_gamma(plane + 1, row) - slope_of_gamma(plane, row)) /
                                                    width_rad(plane));
        return found;
    }

    const Coordinates& web_;
};

// Over the γ in [low, high].
WebVariation::Bounds bounds_between(const Grid& grid, bool is_mirrored, double low, double high) {
    WebVariation::Bounds bounds;
    const bool has_pole = low <= 0.0 || high >= pi;
    const double sine = has_pole ? 0.0 : std::min(std::sin(low), std::sin(high));
    double cotangent = unbounded;
    if (!has_pole) cotangent = std::max(std::abs(1.0 / std::tan(low)), std::abs(1.0 / std::tan(high)));
    bounds.bend_rad = std::min(WebVariation::reach_rad, 0.5 * sine * grid.narrowest_rad);
    double gamma_kink = 0.0;
    double plane_kink = 0.0;
    for (std::size_t i = 0; i < grid.rows.size(); ++i) {
        const Row& row = grid.rows[i];
        const bool is_end = (i == 0 && !is_mirrored) || i + 1 == grid.rows.size();
        const bool is_within = row.gamma >= low && row.gamma <= high;
        if (is_within && is_end && row.gamma > 0.0 && row.gamma < pi && !row.is_dark) bounds.slope = unbounded;
        if (is_within) bounds.most = std::max(bounds.most, row.most);
        if (is_within) gamma_kink = std::max(gamma_kink, row.gamma_kink);
    }
    for (std::size_t i = 0; i < grid.strips.size(); ++i) {
        const Strip& strip = grid.strips[i];
        if (strip.low > high || strip.high < low) continue;
        bounds.slope = std::max(bounds.slope, std::hypot(strip.along_gamma, strip.along_planes));
        bounds.most = std::max({bounds.most, grid.rows[i].most, grid.rows[i + 1].most});
        plane_kink = std::max({plane_kink, grid.rows[i].plane_kink, grid.rows[i + 1].plane_kink});
        bounds.bend_rad = std::min(bounds.bend_rad, 0.5 * (strip.high - strip.low));
        if (!has_pole)
            bounds.curve =
                std::max(bounds.curve, cotangent * (strip.along_gamma + strip.along_planes) + strip.twist / sine);
    }
    bounds.bend_rad *= 1.0 - 1e-6; // so that no arc reaches from one line to the next
    if (has_pole || bounds.slope == unbounded) {
        bounds.bend_rad = 0.0;
        return bounds;
    }
    bounds.kink = gamma_kink * (1.0 + 4.0 * bounds.bend_rad * cotangent) + plane_kink / sine;
    return bounds;
}

} // namespace

WebVariation::WebVariation(const Web& web) {
    for (Bounds& bounds : bounds_)
        bounds.slope = unbounded;
    const Coordinates coordinates(web);
    axis_ = coordinates.axis;
    is_mirrored_ = coordinates.is_mirrored && std::abs(coordinates.gammas.front() - 0.5 * pi) < 1e-12;
    if (coordinates.is_mirrored != is_mirrored_ || !is_closed(coordinates)) return;
    is_bounded_ = true;
    const Grid grid(coordinates);
    const auto gamma_at = [](std::size_t edge) {
        return std::acos(std::clamp(1.0 - 2.0 * static_cast<double>(edge) / static_cast<double>(bins), -1.0, 1.0));
    };
    constexpr double room = 1e-4; // for cosines in float
    for (std::size_t bin = 0; bin < bins; ++bin)
        bounds_[bin] =
            bounds_between(grid, is_mirrored_, gamma_at(bin) - reach_rad - room, gamma_at(bin + 1) + reach_rad + room);
}

WebVariation::Bounds WebVariation::over(double least, double most) const {
    std::size_t first = bin_of(most);
    std::size_t last = bin_of(least);
    if (is_mirrored_) { // the half that is stored has cosines ≤ 0
        const bool has_equator = least <= 0.0 && most >= 0.0;
        const double low = has_equator ? 0.0 : std::min(std::abs(least), std::abs(most));
        first = bin_of(-low);
        last = bin_of(-std::max(std::abs(least), std::abs(most)));
    }
    Bounds all = bounds_[first];
    for (std::size_t bin = first + 1; bin <= last; ++bin) {
        const Bounds& more = bounds_[bin];
        all.slope = std::max(all.slope, more.slope);
        all.kink = std::max(all.kink, more.kink);
        all.curve = std::max(all.curve, more.curve);
        all.bend_rad = std::min(all.bend_rad, more.bend_rad);
        all.most = std::max(all.most, more.most);
    }
    return all;
}

} // namespace gonio::detail
