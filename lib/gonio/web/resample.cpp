#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/resample_light.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gonio {

namespace {

class WorstError {
public:
    WorstError(const web_detail::Light& before, ResampledWeb& result) : before_(before), result_(result) {}

    void look_at(double c_deg, double gamma_deg) {
        const double error = std::abs(result_.web.candela(c_deg, gamma_deg) - before_.candela(c_deg, gamma_deg));
        if (error <= result_.max_error.value) return;
        result_.max_error = Candelas(error);
        result_.max_error_c_deg = c_deg;
        result_.max_error_gamma_deg = gamma_deg;
    }

private:
    const web_detail::Light& before_;
    ResampledWeb& result_;
};

// Every fifth of each step of a grid's axis.
std::vector<double> fifths(std::span<const double> angles) {
    std::vector<double> all;
    for (std::size_t i = 1; i < angles.size(); ++i)
        for (int k = 0; k < 5; ++k)
            all.push_back(angles[i - 1] + 0.2 * k * (angles[i] - angles[i - 1]));
    all.push_back(angles.back());
    return all;
}

void measure(const web_detail::Light& before, ResampledWeb& result) {
    WorstError worst(before, result);
    const std::vector<double> gammas = fifths(result.web.vertical_deg());
    for (const double c : fifths(result.web.horizontal_deg()))
        for (const double gamma : gammas)
            worst.look_at(c, gamma);
    for (const GoniometerAngles& at : before.points)
        worst.look_at(at.horizontal_deg, at.vertical_deg);
}

web_detail::Light light_of(const Web& web) {
    return {[&web](double c, double gamma) { return web.candela(c, gamma); }, web_detail::table_directions(web)};
}

// The whole degrees of γ between which there is light; high below low where there is none.
AngleRange bright_gammas(const web_detail::Light& light) {
    AngleRange range{180.0, 0.0};
    for (int gamma = 0; gamma <= 180; ++gamma)
        for (int c = 0; c < 360; ++c)
            if (light.candela(c, gamma) != 0.0) {
                range.low = std::min(range.low, static_cast<double>(gamma));
                range.high = std::max(range.high, static_cast<double>(gamma));
                break;
            }
    return range;
}

// The half or whole sphere that holds the light, as LM-63 and EULUMDAT know them, with a step to spare at the horizon.
AngleRange table_gammas(AngleRange bright, double step) {
    if (bright.low > bright.high) return {0.0, 180.0};
    const bool up = bright.high > 90.0;
    const bool down = bright.low < 90.0 - step;
    return {down ? 0.0 : 90.0, up ? 180.0 : 90.0};
}

} // namespace

std::vector<double> even_angles(double first, double last, std::size_t count) {
    std::vector<double> angles(count + 1);
    for (std::size_t i = 0; i <= count; ++i)
        angles[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(count);
    angles.back() = last;
    return angles;
}

namespace web_detail {

std::vector<GoniometerAngles> table_directions(const Web& web) {
    std::vector<GoniometerAngles> all;
    for (const double h : web.horizontal_deg())
        for (const double v : web.vertical_deg()) {
            const bool c = web.photometry() == Photometry::c;
            all.push_back(c ? GoniometerAngles{h, v}
                            : angles_of(Photometry::c, direction_of(web.photometry(), {h, v})));
        }
    return all;
}

Result<ResampledWeb> resample(const Light& light, Symmetry stored, std::vector<double> planes_deg,
                              std::vector<double> gammas_deg, Lumens flux_before) {
    std::vector<double> candela;
    candela.reserve(planes_deg.size() * gammas_deg.size());
    for (const double c : planes_deg)
        for (const double gamma : gammas_deg)
            candela.push_back(light.candela(c, gamma));
    Result<Web> made = Web::create(stored, std::move(planes_deg), std::move(gammas_deg), std::move(candela));
    if (!made) return pass_on(made);
    ResampledWeb result{std::move(*made), Candelas(0.0), 0.0, 0.0, Lumens(0.0)};
    measure(light, result);
    result.flux_error = flux(result.web) - flux_before;
    return result;
}

ResampledWeb resample(const Light& light, Symmetry stored, Candelas peak, Lumens flux_before, double tolerance) {
    const AngleRange planes = plane_range(stored);
    const AngleRange bright = bright_gammas(light);
    for (double step = 5.0;; step *= 0.5) {
        const AngleRange gammas = table_gammas(bright, step);
        const auto cells = [&](AngleRange range) {
            return static_cast<std::size_t>(std::lround((range.high - range.low) / step));
        };
        // Even angles within the range of a symmetry are always a grid.
        ResampledWeb result = *resample(light, stored, even_angles(planes.low, planes.high, cells(planes)),
                                        even_angles(gammas.low, gammas.high, cells(gammas)), flux_before);
        if (result.max_error.value <= tolerance * std::abs(peak.value) || step <= 0.3125) return result;
    }
}

} // namespace web_detail

Result<ResampledWeb> resampled_to_c(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                                    Symmetry stored) {
    return web_detail::resample(light_of(web), stored, std::move(planes_deg), std::move(gammas_deg), flux(web));
}

Result<ResampledWeb> resampled_to_c(const Web& web, double tolerance) {
    if (web.photometry() == Photometry::c) return ResampledWeb{web, Candelas(0.0), 0.0, 0.0, Lumens(0.0)};
    return web_detail::resample(light_of(web), web.stored_symmetry(), peak(web).intensity, flux(web), tolerance);
}

} // namespace gonio
