#include <gonio/base/sort_unique.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

namespace {

// A section through the web along a great circle: intensity against the signed angle from a pole, positive towards C.
class Section {
public:
    Section(const Web& web, double c_deg, bool around_zenith) : web_(web), c_deg_(c_deg), zenith_(around_zenith) {}

    double candela(double signed_deg) const {
        const double from_pole = std::abs(signed_deg);
        return web_.candela(signed_deg >= 0.0 ? c_deg_ : c_deg_ + 180.0, zenith_ ? 180.0 - from_pole : from_pole);
    }

    // Whether the section is linear between its knots; sections of types A and B are only nearly linear.
    bool linear() const { return web_.photometry() == Photometry::c; }

    // The angles from the pole at which the section bends, ascending, including 0 and 180; for types A and B, every
    // twentieth of a degree.
    std::vector<double> knots_deg() const {
        if (!linear()) return even_angles(0.0, 180.0, 3600);
        std::vector<double> knots{0.0, 180.0};
        for (const double gamma : web_.gammas_deg())
            knots.push_back(zenith_ ? 180.0 - gamma : gamma);
        sort_unique(knots);
        return knots;
    }

private:
    const Web& web_;
    double c_deg_;
    bool zenith_;
};

// The angle at which the section falls below the threshold, between one that is bright enough and one that is not.
double crossing(const Section& section, double sign, double bright, double dark, double threshold) {
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (bright + dark);
        (section.candela(sign * middle) >= threshold ? bright : dark) = middle;
    }
    return bright;
}

// The outermost angle from the pole on one side (sign ±1) that is at least as bright as the threshold; empty if there
// is none. The search covers 90°, and goes beyond 90° only while the light stays that bright.
std::optional<double> outermost(const Section& section, double sign, double threshold) {
    const std::vector<double> knots = section.knots_deg();
    std::optional<double> best;
    double from = knots.front();
    double from_cd = section.candela(0.0);
    if (from_cd >= threshold) best = 0.0;
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const double to = knots[k];
        const double to_cd = section.candela(sign * to);
        if (to_cd >= threshold) {
            best = to;
        } else if (from_cd >= threshold) {
            // At the end of a table the intensity drops, and it is not linear beyond the edge.
            const double inside = section.candela(sign * (from + 1e-9));
            if (inside < threshold)
                best = from;
            else if (section.linear())
                best = from + (from_cd - threshold) / (from_cd - to_cd) * (to - from);
            else
                best = crossing(section, sign, from, to, threshold);
        }
        if (to >= 90.0 && to_cd < threshold) break;
        from = to;
        from_cd = to_cd;
    }
    return best;
}

// The innermost angle on one side that is bright enough; needed if the other side is dark.
std::optional<double> innermost(const Section& section, double sign, double threshold) {
    const std::vector<double> knots = section.knots_deg();
    double before_cd = section.candela(0.0);
    if (before_cd >= threshold) return 0.0;
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const double here_cd = section.candela(sign * knots[k]);
        if (here_cd >= threshold) {
            const double inside = section.candela(sign * (knots[k] - 1e-9));
            if (inside < threshold * (1.0 - 1e-6) && inside <= 0.0) return knots[k];
            if (!section.linear()) return crossing(section, sign, knots[k], knots[k - 1], threshold);
            return knots[k - 1] + (threshold - before_cd) / (here_cd - before_cd) * (knots[k] - knots[k - 1]);
        }
        before_cd = here_cd;
    }
    return std::nullopt;
}

} // namespace

Peak peak(const Web& web) {
    Peak best{Candelas(web.column(0)[0]), web.horizontal_deg()[0], web.vertical_deg()[0]};
    for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i) {
        const std::span<const double> column = web.column(i);
        for (std::size_t j = 0; j < column.size(); ++j)
            if (column[j] > best.intensity.value)
                best = {Candelas(column[j]), web.horizontal_deg()[i], web.vertical_deg()[j]};
    }
    if (web.photometry() == Photometry::c) return best;
    const GoniometerAngles at = angles_of(Photometry::c, direction_of(web.photometry(), {best.c_deg, best.gamma_deg}));
    // Without the rounding of sines: 90°, not 89.99999999999999°.
    const auto settled = [](double deg) { return std::round(deg * 1e9) / 1e9; };
    return {best.intensity, std::fmod(settled(at.horizontal_deg), 360.0), settled(at.vertical_deg)};
}

namespace {

// Whether the beam's axis points to the zenith.
bool points_up(const Web& web, const Peak& top) {
    return top.gamma_deg > 90.0 || (web.photometry() == Photometry::c && web.gammas_deg().front() >= 90.0);
}

} // namespace

std::optional<Radians> spread_angle(const Web& web, double c_deg, double fraction) {
    return spread_angle(web, c_deg, fraction * peak(web).intensity);
}

std::optional<Radians> spread_angle(const Web& web, double c_deg, Candelas threshold) {
    if (!(threshold.value > 0.0)) return std::nullopt;
    const Section section(web, c_deg, points_up(web, peak(web)));
    const double limit = threshold.value;
    const std::optional<double> right = outermost(section, 1.0, limit);
    const std::optional<double> left = outermost(section, -1.0, limit);
    if (right && left) return degrees(std::min(*right + *left, 360.0));
    if (right) return degrees(*right - *innermost(section, 1.0, limit));
    if (left) return degrees(*left - *innermost(section, -1.0, limit));
    return std::nullopt;
}

Candelas center_beam(const Web& web) {
    return Candelas(web.candela(0.0, points_up(web, peak(web)) ? 180.0 : 0.0));
}

std::optional<Radians> cie_beam_angle(const Web& web, double c_deg) {
    return spread_angle(web, c_deg, 0.5 * center_beam(web));
}

int nema_type(Radians field_angle) {
    constexpr std::array limits{18.0, 29.0, 46.0, 70.0, 100.0, 130.0};
    const double angle = to_degrees(field_angle);
    int type = 1;
    for (const double limit : limits)
        type += angle > limit + 1e-9 ? 1 : 0; // tolerance because the degrees were converted from radians
    return type;
}

} // namespace gonio
