#include <gonio/web/spacing.hpp>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

double mean_candela(const Web& web, std::initializer_list<double> planes_deg, double gamma_deg) {
    double sum = 0.0;
    for (const double c : planes_deg)
        sum += web.candela(c, gamma_deg);
    return sum / static_cast<double>(planes_deg.size());
}

double cube_of_cosine(double gamma_deg) {
    const double cosine = std::cos(gamma_deg * radians_per_degree);
    return cosine * cosine * cosine;
}

// The angle between a γ where `illuminance` is at least `threshold` and one where it is below.
template<class Illuminance>
double crossing_deg(double bright, double dark, double threshold, const Illuminance& illuminance) {
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (bright + dark);
        (illuminance(middle) >= threshold ? bright : dark) = middle;
    }
    return bright;
}

// Type C: between two angles of the table the mean is linear in γ, and a linear function times cos³γ is log-concave
// where it is above 0. So it can fall below the threshold between two of them only if it is below it at the second.
std::optional<double> first_dark_deg(const Web& web, std::initializer_list<double> planes_deg, double threshold) {
    double before_deg = 0.0;
    double before_cd = mean_candela(web, planes_deg, 0.0);
    for (const double table_deg : web.gammas_deg()) {
        if (table_deg <= 0.0) continue;
        const double at_deg = std::fmin(table_deg, 90.0);
        const double at_cd = mean_candela(web, planes_deg, at_deg);
        if (at_deg == 90.0 || at_cd * cube_of_cosine(at_deg) < threshold)
            return crossing_deg(before_deg, at_deg, threshold, [&](double gamma_deg) {
                const double share = (gamma_deg - before_deg) / (at_deg - before_deg);
                return (before_cd + share * (at_cd - before_cd)) * cube_of_cosine(gamma_deg);
            });
        before_deg = at_deg;
        before_cd = at_cd;
    }
    return before_deg; // the table ends at a non-zero value
}

// Types A and B: the angles of the table are not on a C-plane.
std::optional<double> first_dark_by_steps_deg(const Web& web, std::initializer_list<double> planes_deg,
                                              double threshold) {
    const auto illuminance = [&](double gamma_deg) {
        return mean_candela(web, planes_deg, gamma_deg) * cube_of_cosine(gamma_deg);
    };
    constexpr double step = 0.05;
    for (int i = 1; i * step < 90.0; ++i)
        if (illuminance(i * step) < threshold) return crossing_deg((i - 1) * step, i * step, threshold, illuminance);
    return std::nullopt;
}

// tanγ at the first γ where the mean of the planes, times cos³γ, falls to `share` of the nadir's intensity.
std::optional<double> tangent_at(const Web& web, std::initializer_list<double> planes_deg, double share) {
    const double threshold = share * mean_candela(web, planes_deg, 0.0);
    if (!(threshold > 0.0)) return std::nullopt;
    const std::optional<double> gamma_deg = web.photometry() == Photometry::c
                                                ? first_dark_deg(web, planes_deg, threshold)
                                                : first_dark_by_steps_deg(web, planes_deg, threshold);
    return gamma_deg ? std::optional(std::tan(*gamma_deg * radians_per_degree)) : std::nullopt;
}

std::optional<double> times(double factor, const std::optional<double>& value) {
    return value ? std::optional(factor * *value) : std::nullopt;
}

} // namespace

SpacingCriterion spacing_criterion(const Web& web) {
    return {times(2.0, tangent_at(web, {0.0, 180.0}, 0.5)), times(2.0, tangent_at(web, {90.0, 270.0}, 0.5)),
            times(std::numbers::sqrt2, tangent_at(web, {45.0, 135.0, 225.0, 315.0}, 0.25))};
}

} // namespace gonio
