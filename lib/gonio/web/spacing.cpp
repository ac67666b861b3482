#include <gonio/web/spacing.hpp>

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// tanγ at the first γ where the mean of the planes, times cos³γ, falls to `share` of the nadir's intensity.
std::optional<double> tangent_at(const Web& web, std::initializer_list<double> planes_deg, double share) {
    const auto illuminance = [&](double gamma_deg) {
        double sum = 0.0;
        for (const double c : planes_deg)
            sum += web.candela(c, gamma_deg);
        const double cosine = std::cos(gamma_deg * radians_per_degree);
        return sum / static_cast<double>(planes_deg.size()) * cosine * cosine * cosine;
    };
    const double threshold = share * illuminance(0.0);
    if (!(threshold > 0.0)) return std::nullopt;
    constexpr double step = 0.05;
    for (int i = 1; i * step < 90.0; ++i) {
        if (illuminance(i * step) >= threshold) continue;
        double bright = (i - 1) * step;
        double dark = i * step;
        for (int k = 0; k < 50; ++k) {
            const double middle = 0.5 * (bright + dark);
            (illuminance(middle) >= threshold ? bright : dark) = middle;
        }
        return std::tan(bright * radians_per_degree);
    }
    return std::nullopt;
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
