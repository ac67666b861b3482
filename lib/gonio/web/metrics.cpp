#include <gonio/web/metrics.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

namespace {

// Every C at which the interpolant may bend, over [0°, 360°].
std::vector<double> bends_deg(const Web& web) {
    std::vector<double> all;
    for (const double c : web.planes_deg())
        for (const double image : {c, 180.0 - c, 180.0 + c, 360.0 - c})
            all.push_back(std::fmod(image + 720.0, 360.0));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// Whether I(C) = I(mirror(C)) for every C: both sides are piecewise linear and bend only at the listed angles.
template<class Mirror>
bool mirrors(const Web& web, const std::vector<double>& bends, double limit_cd, Mirror&& mirror) {
    for (const double c : bends)
        for (const double gamma : web.gammas_deg())
            if (std::abs(web.candela(c, gamma) - web.candela(mirror(c), gamma)) > limit_cd) return false;
    return true;
}

// A section through the web along a great circle: intensity against the signed angle from a pole, towards C positive.
class Section {
public:
    Section(const Web& web, double c_deg, bool around_zenith) : web_(web), c_deg_(c_deg), zenith_(around_zenith) {}

    double candela(double signed_deg) const {
        const double from_pole = std::abs(signed_deg);
        return web_.candela(signed_deg >= 0.0 ? c_deg_ : c_deg_ + 180.0, zenith_ ? 180.0 - from_pole : from_pole);
    }

    // The angles from the pole at which the section bends, ascending, 0 and 180 included.
    std::vector<double> knots_deg() const {
        std::vector<double> knots{0.0, 180.0};
        for (const double gamma : web_.gammas_deg())
            knots.push_back(zenith_ ? 180.0 - gamma : gamma);
        std::sort(knots.begin(), knots.end());
        knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
        return knots;
    }

private:
    const Web& web_;
    double c_deg_;
    bool zenith_;
};

// The outermost angle from the pole on one side (sign ±1) that is at least as bright as the threshold; nothing when the
// side has none. Searched inside 90°, and outwards from 90° while the light stays that bright.
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
            // A table that ends in the dark drops at its edge and is not linear behind it.
            const double inside = section.candela(sign * (from + 1e-9));
            best = inside < threshold ? from : from + (from_cd - threshold) / (from_cd - to_cd) * (to - from);
        }
        if (to >= 90.0 && to_cd < threshold) break;
        from = to;
        from_cd = to_cd;
    }
    return best;
}

// The side's innermost angle that is bright enough, needed when the other side is dark.
std::optional<double> innermost(const Section& section, double sign, double threshold) {
    const std::vector<double> knots = section.knots_deg();
    double before_cd = section.candela(0.0);
    if (before_cd >= threshold) return 0.0;
    for (std::size_t k = 1; k < knots.size(); ++k) {
        const double here_cd = section.candela(sign * knots[k]);
        if (here_cd >= threshold) {
            const double inside = section.candela(sign * (knots[k] - 1e-9));
            if (inside < threshold * (1.0 - 1e-6) && inside <= 0.0) return knots[k];
            return knots[k - 1] + (threshold - before_cd) / (here_cd - before_cd) * (knots[k] - knots[k - 1]);
        }
        before_cd = here_cd;
    }
    return std::nullopt;
}

} // namespace

Peak peak(const Web& web) {
    Peak best{Candelas(web.column(0)[0]), web.planes_deg()[0], web.gammas_deg()[0]};
    for (std::size_t i = 0; i < web.planes_deg().size(); ++i) {
        const std::span<const double> column = web.column(i);
        for (std::size_t j = 0; j < column.size(); ++j)
            if (column[j] > best.intensity.value)
                best = {Candelas(column[j]), web.planes_deg()[i], web.gammas_deg()[j]};
    }
    return best;
}

Symmetry detected_symmetry(const Web& web, double tolerance) {
    if (web.stored_symmetry() == Symmetry::axial) return Symmetry::axial;
    const double limit = tolerance * std::abs(peak(web).intensity.value);
    const std::vector<double> bends = bends_deg(web);
    if (mirrors(web, bends, limit, [&](double) { return bends.front(); })) return Symmetry::axial;
    const bool across_0_180 = mirrors(web, bends, limit, [](double c) { return 360.0 - c; });
    const bool across_90_270 = mirrors(web, bends, limit, [](double c) { return 540.0 - c; });
    if (across_0_180 && across_90_270) return Symmetry::quadrant;
    if (across_0_180) return Symmetry::bilateral_0_180;
    if (across_90_270) return Symmetry::bilateral_90_270;
    return Symmetry::none;
}

std::optional<Radians> spread_angle(const Web& web, double c_deg, double fraction) {
    const Peak top = peak(web);
    if (!(top.intensity.value > 0.0)) return std::nullopt;
    const double threshold = fraction * top.intensity.value;
    const bool upwards = top.gamma_deg > 90.0 || web.gammas_deg().front() >= 90.0;
    const Section section(web, c_deg, upwards);
    const std::optional<double> right = outermost(section, 1.0, threshold);
    const std::optional<double> left = outermost(section, -1.0, threshold);
    if (right && left) return degrees(std::min(*right + *left, 360.0));
    if (right) return degrees(*right - *innermost(section, 1.0, threshold));
    if (left) return degrees(*left - *innermost(section, -1.0, threshold));
    return std::nullopt;
}

} // namespace gonio
