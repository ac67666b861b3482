#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/rings.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

constexpr auto gamma_rule = gauss_legendre<8>();
constexpr auto c_rule = gauss_legendre<4>();

// Widest pieces for one quadrature rule.
constexpr double widest_gamma_deg = 2.5;
constexpr double widest_c_deg = 5.0;

} // namespace

Rings::Rings(const Web& web) : web_(web) {
    breaks_deg_.push_back(90.0);
    if (web.photometry() == Photometry::c) {
        for (const double gamma : web.vertical_deg())
            breaks_deg_.push_back(gamma);
        sort_unique(breaks_deg_);
        return;
    }
    const bool a = web.photometry() == Photometry::a;
    std::vector<double>& latitudes = a ? y_at_ : x_at_;
    std::vector<double>& longitudes = a ? x_slope_ : y_slope_;
    const auto touch = [&](double angle_deg) {
        const double from_axis = std::abs(angle_deg);
        breaks_deg_.push_back(from_axis);
        breaks_deg_.push_back(180.0 - from_axis);
    };
    // Both signs: if the table is mirrored, one of them is the image; otherwise the extra cut is harmless.
    for (const double angle : a ? web.vertical_deg() : web.horizontal_deg()) {
        for (const double sign : {-1.0, 1.0})
            latitudes.push_back(sign * std::sin(angle * radians_per_degree));
        touch(angle);
    }
    for (const double angle : a ? web.horizontal_deg() : web.vertical_deg()) {
        for (const double sign : {-1.0, 1.0})
            longitudes.push_back(sign * std::tan(angle * radians_per_degree));
        touch(angle);
    }
    // Where the table ends at a non-zero value, the ring integral bends wherever the ring leaves it at a grid point of
    // the edge.
    const auto edge_point = [&](std::size_t i, std::size_t j) {
        if (web.column(i)[j] == 0.0) return;
        const GoniometerAngles at{web.horizontal_deg()[i], web.vertical_deg()[j]};
        breaks_deg_.push_back(angles_of(Photometry::c, direction_of(web.photometry(), at)).vertical_deg);
    };
    const std::size_t last_h = web.horizontal_deg().size() - 1;
    const std::size_t last_v = web.vertical_deg().size() - 1;
    for (std::size_t i = 0; i <= last_h; ++i) {
        edge_point(i, 0);
        edge_point(i, last_v);
    }
    for (std::size_t j = 0; j <= last_v; ++j) {
        edge_point(0, j);
        edge_point(last_h, j);
    }
    for (std::vector<double>* list : {&x_at_, &y_at_, &x_slope_, &y_slope_, &breaks_deg_})
        sort_unique(*list);
}

void Rings::cut_at_gamma(double gamma_deg) {
    breaks_deg_.push_back(gamma_deg);
    sort_unique(breaks_deg_);
}

void Rings::cut_at_pyramid(double half_x_deg, double half_y_deg) {
    const double x = std::tan(half_x_deg * radians_per_degree);
    const double y = std::tan(half_y_deg * radians_per_degree);
    for (const double sign : {-1.0, 1.0}) {
        x_slope_.push_back(sign * x);
        y_slope_.push_back(sign * y);
    }
    // Where a ring touches a face, and where it leaves through an edge.
    for (const double gamma : {half_x_deg, half_y_deg, std::atan(std::hypot(x, y)) / radians_per_degree})
        breaks_deg_.push_back(gamma);
    sort_unique(breaks_deg_);
}

void Rings::add_ring(double gamma_rad, double factor, std::span<const double> c_edges_deg, std::span<double> lumens,
                     const Weight& weight) const {
    const double s = std::sin(gamma_rad);
    const double k = std::cos(gamma_rad);
    std::vector<double> cuts{0.0, 90.0, 180.0, 270.0, 360.0};
    const auto cut = [&](std::initializer_list<double> azimuths_rad) {
        for (const double c : azimuths_rad) {
            const double deg = c / radians_per_degree;
            cuts.push_back(deg < 0.0 ? deg + 360.0 : deg);
        }
    };
    const auto at_cosine = [&](double cosine) {
        if (std::abs(cosine) >= 1.0) return;
        const double c = std::acos(cosine);
        cut({c, -c});
    };
    const auto at_sine = [&](double sine) {
        if (std::abs(sine) >= 1.0) return;
        const double c = std::asin(sine);
        cut({c, pi - c});
    };
    for (const double q : x_at_)
        at_cosine(q / s);
    for (const double t : x_slope_)
        at_cosine(t * k / s);
    for (const double q : y_at_)
        at_sine(q / s);
    for (const double t : y_slope_)
        at_sine(t * k / s);
    if (web_.photometry() != Photometry::c) {
        // Near the native poles, on the horizon, the longitude turns within a range of azimuths as narrow as the ring's
        // distance from the pole.
        const double near = std::abs(0.5 * pi - gamma_rad) / radians_per_degree;
        const double pole = web_.photometry() == Photometry::a ? 90.0 : 0.0;
        double offset = std::max(0.5 * near, 1e-6);
        for (; offset < 45.0; offset *= 2.0) // NOLINT(clang-analyzer-security.FloatLoopCounter): doubling is exact
            for (const double c : {pole - offset, pole + offset, pole + 180.0 - offset, pole + 180.0 + offset})
                cuts.push_back(c < 0.0 ? c + 360.0 : c);
    } else {
        for (const double c : web_.horizontal_deg())
            for (const double image : {c, 180.0 - c, 180.0 + c, -c})
                cuts.push_back(std::fmod(image + 1080.0, 360.0));
    }
    std::sort(cuts.begin(), cuts.end());

    auto next = cuts.begin();
    for (std::size_t i = 0; i + 1 < c_edges_deg.size(); ++i) {
        double from = c_edges_deg[i];
        while (next != cuts.end() && *next <= from)
            ++next;
        double sum = 0.0;
        while (from < c_edges_deg[i + 1]) {
            double to = std::min(c_edges_deg[i + 1], from + widest_c_deg);
            if (next != cuts.end() && *next < to) to = *next++;
            const double middle = 0.5 * (from + to) * radians_per_degree;
            const double half = 0.5 * (to - from) * radians_per_degree;
            for (const QuadratureNode& node : c_rule) {
                const double c = middle + half * node.at;
                const glm::dvec3 direction(s * std::cos(c), s * std::sin(c), -k);
                const double cd = web_.candela(direction);
                sum += node.weight * half * (weight ? weight(direction) * cd : cd);
            }
            from = to;
        }
        lumens[i] += factor * s * sum;
    }
}

void Rings::add(double gamma_low_deg, double gamma_high_deg, std::span<const double> c_edges_deg,
                std::span<double> lumens, const Weight& weight) const {
    double from = gamma_low_deg;
    auto next = std::upper_bound(breaks_deg_.begin(), breaks_deg_.end(), from);
    while (from < gamma_high_deg) {
        double to = std::min(gamma_high_deg, from + widest_gamma_deg);
        if (next != breaks_deg_.end() && *next < to) to = *next++;
        const double middle = 0.5 * (from + to) * radians_per_degree;
        const double half = 0.5 * (to - from) * radians_per_degree;
        for (const QuadratureNode& node : gamma_rule) {
            const double t = node.at;
            const double at = 0.5 * t * (3.0 - t * t);
            const double slope = 1.5 * (1.0 - t * t);
            add_ring(middle + half * at, node.weight * half * slope, c_edges_deg, lumens, weight);
        }
        from = to;
    }
}

double Rings::zone(double gamma_low_deg, double gamma_high_deg, const Weight& weight) const {
    constexpr std::array whole{0.0, 360.0};
    std::array<double, 1> lumens{0.0};
    add(gamma_low_deg, gamma_high_deg, whole, lumens, weight);
    return lumens[0];
}

} // namespace gonio
