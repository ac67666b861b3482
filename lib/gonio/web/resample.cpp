#include <gonio/base/sort_unique.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/native_rows.hpp>
#include <gonio/web/plane_range.hpp>
#include <gonio/web/quick_web.hpp>
#include <gonio/web/refine_grid.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/resample_light.hpp>
#include <gonio/web/web_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace gonio {

namespace {

using web_detail::finest_step_deg;

constexpr double coarse_step_deg = 2.5;

class WorstError {
public:
    WorstError(const web_detail::Light& before, ResampledWeb& result) : before_(before), result_(result) {}

    void look_at(double c_deg, double gamma_deg) {
        const double error = std::abs(result_.web.candela(c_deg, gamma_deg) - before_.candela(c_deg, gamma_deg));
        if (error <= result_.max_error.value) return;
        if (is_narrow(result_.web.horizontal_deg(), c_deg) && is_narrow(result_.web.vertical_deg(), gamma_deg)) {
            result_.jump_error = Candelas(std::max(result_.jump_error.value, error));
            return;
        }
        result_.max_error = Candelas(error);
        result_.max_error_c_deg = c_deg;
        result_.max_error_gamma_deg = gamma_deg;
    }

private:
    // Whether a step that contains the angle is one of the finest; an angle of the grid is in two steps.
    static bool is_narrow(std::span<const double> angles, double angle) {
        const auto step_ends_at = [&](std::ptrdiff_t i) {
            return i > 0 && i < std::ssize(angles) &&
                   angles[static_cast<std::size_t>(i)] - angles[static_cast<std::size_t>(i) - 1] <= finest_step_deg;
        };
        const auto first = std::lower_bound(angles.begin(), angles.end(), angle - 1e-9) - angles.begin();
        const auto last = std::upper_bound(angles.begin(), angles.end(), angle + 1e-9) - angles.begin();
        return step_ends_at(first) || step_ends_at(last);
    }

    const web_detail::Light& before_;
    ResampledWeb& result_;
};

// The ends of all fifths of each step of a grid's axis.
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
    const std::vector<double> planes = fifths(result.web.horizontal_deg());
    web_detail::LightRows of_before(before, gammas);
    web_detail::WebRows of_result(result.web, gammas);
    for (const double c : planes) {
        const std::span<const double> here = of_before.quick(c);
        const std::span<const double> there = of_result.exact(c);
        for (std::size_t j = 0; j < gammas.size(); ++j)
            if (std::abs(there[j] - here[j]) + of_before.margin_cd() > result.max_error.value)
                worst.look_at(c, gammas[j]);
    }
    for (const GoniometerAngles& at : before.points)
        worst.look_at(at.horizontal_deg, at.vertical_deg);
}

// Lines of H and V cross the planes C0–C180 and C90–C270 at these γ, and the light bends there.
std::vector<double> gammas_of_native(const Web& web) {
    std::vector<double> gammas;
    for (const std::span<const double> angles : {web.horizontal_deg(), web.vertical_deg()})
        for (const double angle : angles)
            gammas.push_back(std::abs(angle));
    return gammas;
}

web_detail::Light light_of(const Web& web) {
    return {[&web](double c, double gamma) { return web.candela(c, gamma); }, web_detail::table_directions(web),
            web.photometry() == Photometry::c ? std::vector<double>() : gammas_of_native(web), &web};
}

Result<Web> sampled(const web_detail::Light& light, Symmetry stored, std::vector<double> planes_deg,
                    std::vector<double> gammas_deg) {
    std::vector<double> candela;
    candela.reserve(planes_deg.size() * gammas_deg.size());
    web_detail::LightRows rows(light, gammas_deg);
    for (const double c : planes_deg) {
        const std::span<const double> row = rows.exact(c);
        candela.insert(candela.end(), row.begin(), row.end());
    }
    return Web::create(stored, std::move(planes_deg), std::move(gammas_deg), std::move(candela));
}

// The range of whole degrees of γ that contains light; high is below low if there is none.
AngleRange bright_gammas(const web_detail::Light& light) {
    std::optional<QuickWeb> quick;
    if (light.web != nullptr) quick.emplace(*light.web);
    const auto is_lit = [&](int gamma) {
        if (quick) return web_detail::is_lit_at(*light.web, *quick, gamma);
        for (int c = 0; c < 360; ++c)
            if (light.candela(c, gamma) != 0.0) return true;
        return false;
    };
    AngleRange range{180.0, 0.0};
    for (int gamma = 0; gamma <= 180; ++gamma)
        if (is_lit(gamma)) {
            range.low = std::min(range.low, static_cast<double>(gamma));
            range.high = std::max(range.high, static_cast<double>(gamma));
        }
    return range;
}

// The half or full sphere that contains the light, as in LM-63 and EULUMDAT, with a tolerance of one step at the
// horizon.
AngleRange table_gammas(AngleRange bright, double step) {
    if (bright.low > bright.high) return {0.0, 180.0};
    const bool up = bright.high > 90.0;
    const bool down = bright.low < 90.0 - step;
    return {down ? 0.0 : 90.0, up ? 180.0 : 90.0};
}

// Uniform steps of at most coarse_step_deg between the listed angles.
std::vector<double> filled(std::vector<double> listed) {
    sort_unique(listed);
    std::vector<double> angles{listed.front()};
    for (std::size_t i = 1; i < listed.size(); ++i) {
        const double width = listed[i] - listed[i - 1];
        const auto cells = static_cast<std::size_t>(std::ceil(width / coarse_step_deg - 1e-9));
        const std::vector<double> between = even_angles(listed[i - 1], listed[i], std::max<std::size_t>(cells, 1));
        angles.insert(angles.end(), between.begin() + 1, between.end());
    }
    return angles;
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

LightRows::LightRows(const Light& light, std::span<const double> gammas_deg)
    : light_(light), gammas_deg_(gammas_deg), row_(gammas_deg.size()) {
    if (light.web != nullptr) of_web_.emplace(*light.web, gammas_deg);
}

std::span<const double> LightRows::exact(double c_deg) {
    if (of_web_) return of_web_->exact(c_deg);
    for (std::size_t j = 0; j < row_.size(); ++j)
        row_[j] = light_.candela(c_deg, gammas_deg_[j]);
    return row_;
}

std::span<const double> LightRows::quick(double c_deg) {
    return of_web_ ? of_web_->quick(c_deg) : exact(c_deg);
}

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
    Result<Web> made = sampled(light, stored, std::move(planes_deg), std::move(gammas_deg));
    if (!made) return pass_on(made);
    ResampledWeb result{std::move(*made), Candelas(0.0), 0.0, 0.0, Lumens(0.0), Candelas(0.0)};
    measure(light, result);
    result.flux_error = flux(result.web) - flux_before;
    return result;
}

ResampledWeb resample(const Light& light, Symmetry stored, Candelas peak, Lumens flux_before, double tolerance) {
    const AngleRange planes = plane_range(stored);
    const AngleRange gammas = table_gammas(bright_gammas(light), coarse_step_deg);
    std::vector<double> own{gammas.low, gammas.high};
    for (const double gamma : light.gammas_deg)
        if (gamma > gammas.low + finest_step_deg && gamma < gammas.high - finest_step_deg) own.push_back(gamma);
    AngleGrid grid = refined_grid(light, {filled({planes.low, planes.high}), filled(std::move(own))},
                                  Candelas(tolerance * std::abs(peak.value)));
    // Ascending angles within the range of a symmetry always form a grid.
    return *resample(light, stored, std::move(grid.planes_deg), std::move(grid.gammas_deg), flux_before);
}

} // namespace web_detail

Result<ResampledWeb> resampled_to_c(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                                    Symmetry stored) {
    return web_detail::resample(light_of(web), stored, std::move(planes_deg), std::move(gammas_deg), flux(web));
}

Result<Web> sampled_on_grid(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                            Symmetry stored) {
    return sampled(light_of(web), stored, std::move(planes_deg), std::move(gammas_deg));
}

Result<ResampledWeb> resampled_to_c(const Web& web, double tolerance) {
    if (web.photometry() == Photometry::c)
        return ResampledWeb{web, Candelas(0.0), 0.0, 0.0, Lumens(0.0), Candelas(0.0)};
    return web_detail::resample(light_of(web), web.stored_symmetry(), peak(web).intensity, flux(web), tolerance);
}

} // namespace gonio
