// Measured light: reading files of three formats, the flux of a table, and the intensity between its angles.
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/strtod_baseline.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gonio::measure::detail {

namespace {

using Webs = std::vector<Web>;

constexpr std::array luminaires{"cosine", "downlight", "batwing", "wall-washer", "street"};

Web table_of(const char* luminaire, double horizontal_step_deg, double vertical_step_deg) {
    AuthorOptions options;
    options.horizontal_step_deg = horizontal_step_deg;
    options.vertical_step_deg = vertical_step_deg;
    return authored(parse_authored(luminaire).value(), options).value();
}

// --- Reading.

// A street luminaire of 2.5° by 1° in a format; its values after reading against those before writing.
Result<Contest> of_reading(const char* format) {
    const auto web = std::make_shared<const Web>(table_of("street", 2.5, 1.0));
    Result<MadeProfile> made = to_profile(*web, {}, *find_profile_target(format));
    if (!made) return pass_on(made);
    const auto bytes = std::make_shared<const std::string>(write_profile(made->profile, *find_profile_target(format)));
    const std::size_t values = web->horizontal_deg().size() * web->vertical_deg().size();
    const std::string name = std::string("lamp.") + format;
    const auto read = [bytes, name] { return resolve_web(read_profile(*bytes, name).value()).value(); };
    const double peak_cd = gonio::peak(*web).intensity.value;
    const auto errors = [read, web, peak_cd] {
        const Web found = read().web;
        std::vector<double> off;
        for (const double c : web->horizontal_deg())
            for (const double gamma : web->vertical_deg())
                off.push_back(std::fabs(found.candela(c, gamma) - web->candela(c, gamma)) / peak_cd);
        return off;
    };
    const auto sink = std::make_shared<double>();
    const auto numbers_alone = [bytes, sink] { *sink += sum_by_strtod(*bytes); };
    const auto none = [] { return std::vector<double>{std::numeric_limits<double>::quiet_NaN()}; };
    return Contest{
        {"profiles", std::string("reading ") + format, "all", "relative to the peak intensity", "candela value",
         "the web that was written; strtod reads the numbers alone"},
        0,
        {{"strtod", "double", {numbers_alone, values}, none},
         {"read-profile", "double", {[bytes, name] { (void)read_profile(*bytes, name).value(); }, values}, none},
         {"read-and-resolve", "double", {[read] { (void)read(); }, values}, errors}}};
}

// --- Flux.

// ∬ of the interpolant, 8 × 8 Gauss–Legendre points in each cell, over the full turn that its symmetry implies.
double flux_by_quadrature(const Web& web) {
    constexpr auto rule = gauss_legendre<8>();
    const std::span<const double> planes = web.planes_deg();
    const std::span<const double> gammas = web.gammas_deg();
    constexpr double degree = std::numbers::pi / 180.0;
    double sum = 0.0;
    const auto cell = [&](double c0, double c1, double g0, double g1) {
        for (const QuadratureNode& s : rule)
            for (const QuadratureNode& t : rule) {
                const double c = 0.5 * (c0 + c1) + 0.5 * (c1 - c0) * s.at;
                const double gamma = 0.5 * (g0 + g1) + 0.5 * (g1 - g0) * t.at;
                sum += s.weight * t.weight * 0.25 * (c1 - c0) * (g1 - g0) * degree * degree * web.candela(c, gamma) *
                       std::sin(gamma * degree);
            }
    };
    for (std::size_t j = 0; j + 1 < gammas.size(); ++j) {
        if (planes.size() == 1) cell(0.0, 360.0, gammas[j], gammas[j + 1]);
        for (std::size_t i = 0; i + 1 < planes.size(); ++i)
            cell(planes[i], planes[i + 1], gammas[j], gammas[j + 1]);
    }
    return planes.size() == 1 ? sum : sum * image_count(web.stored_symmetry());
}

// Intensities at the middle of cells of 1° by 1°, as scripts do it.
double flux_by_midpoints(const Web& web) {
    double sum = 0.0;
    constexpr double degree = std::numbers::pi / 180.0;
    for (int j = 0; j < 180; ++j) {
        const double zone = std::cos(j * degree) - std::cos((j + 1) * degree);
        for (int i = 0; i < 360; ++i)
            sum += zone * degree * web.candela(i + 0.5, j + 0.5);
    }
    return sum;
}

Result<Contest> of_flux() {
    const auto webs = std::make_shared<Webs>();
    for (const char* luminaire : luminaires)
        for (const double step : {1.0, 2.5, 5.0, 10.0})
            webs->push_back(table_of(luminaire, step < 2.0 ? 5.0 : 15.0, step));
    const auto truth = std::make_shared<std::vector<double>>();
    for (const Web& web : *webs)
        truth->push_back(flux_by_quadrature(web));
    Contest contest{{"profiles", "flux", "all", "relative to the flux", "luminaire",
                     "8 x 8 Gauss-Legendre points in each cell of the interpolant", "exact"},
                    1,
                    {}};
    const auto add = [&](const char* name, double (*flux_lm)(const Web&)) {
        const auto sink = std::make_shared<double>();
        const auto work = [webs, sink, flux_lm] {
            for (const Web& web : *webs)
                *sink += flux_lm(web);
        };
        const auto errors = [webs, truth, flux_lm] {
            std::vector<double> off;
            for (std::size_t i = 0; i < webs->size(); ++i)
                off.push_back(std::fabs(flux_lm((*webs)[i]) / (*truth)[i] - 1.0));
            return off;
        };
        contest.contestants.push_back({name, "double", {work, webs->size()}, errors});
    };
    add("exact", [](const Web& web) { return flux(web).value; });
    add("zonal", [](const Web& web) { return zonal_flux(web).value; });
    add("midpoints", flux_by_midpoints);
    return contest;
}

// --- Intensity.

// The nearest value of the table, as a loader without interpolation gives it.
double nearest_value(const Web& web, double c_deg, double gamma_deg) {
    const auto closest = [](std::span<const double> angles, double at) {
        return *std::min_element(angles.begin(), angles.end(),
                                 [&](double a, double b) { return std::fabs(a - at) < std::fabs(b - at); });
    };
    return web.candela(closest(web.planes_deg(), web.folded_c_deg(c_deg)), closest(web.gammas_deg(), gamma_deg));
}

// Tables of formulas, evaluated between their angles; the formulas give the truth.
Result<Contest> of_intensity(double horizontal_step_deg, double vertical_step_deg, const char* subset,
                             const SuiteOptions& options) {
    struct Luminaire {
        Web web;
        AuthoredShape formula;
        double cd_per_unit;
        double peak_cd;
    };
    const auto all = std::make_shared<std::vector<Luminaire>>();
    for (const char* name : luminaires) {
        Web web = table_of(name, horizontal_step_deg, vertical_step_deg);
        AuthoredShape formula = parse_authored(name).value();
        const Peak top = gonio::peak(web);
        const double unit = top.intensity.value / formula.relative(top.c_deg, top.gamma_deg);
        all->push_back({std::move(web), std::move(formula), unit, top.intensity.value});
    }
    Random random(options.seed);
    const auto angles = std::make_shared<std::vector<std::array<double, 2>>>();
    for (int i = 0; i < (options.quick ? 500 : 5000); ++i)
        angles->push_back({random.uniform(0.0, 360.0), random.uniform(0.0, 90.0)});
    Contest contest{{"profiles", "intensity between the table's angles", subset, "relative to the peak intensity",
                     "direction", "the formula that the table was made from", "interpolant"},
                    0,
                    {}};
    const auto add = [&](const char* name, double (*candela)(const Web&, double, double)) {
        const auto sink = std::make_shared<double>();
        const auto work = [all, angles, sink, candela] {
            for (const Luminaire& luminaire : *all)
                for (const auto& [c, gamma] : *angles)
                    *sink += candela(luminaire.web, c, gamma);
        };
        const auto errors = [all, angles, candela] {
            std::vector<double> off;
            for (const Luminaire& luminaire : *all)
                for (const auto& [c, gamma] : *angles) {
                    const double truth = luminaire.cd_per_unit * luminaire.formula.relative(c, gamma);
                    off.push_back(std::fabs(candela(luminaire.web, c, gamma) - truth) / luminaire.peak_cd);
                }
            return off;
        };
        contest.contestants.push_back({name, "double", {work, all->size() * angles->size()}, errors});
    };
    add("nearest", nearest_value);
    add("interpolant", [](const Web& web, double c, double gamma) { return web.candela(c, gamma); });
    return contest;
}

} // namespace

std::vector<std::string> profile_methods() {
    return {"strtod", "read-profile", "read-and-resolve", "exact", "zonal", "midpoints", "nearest", "interpolant"};
}

std::vector<ContestMaker> profile_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const char* format : {"ies", "ldt", "tm33"})
        makers.push_back({std::string("reading ") + format, "all", [format] { return of_reading(format); }});
    makers.push_back({"flux", "all", of_flux});
    const char* const cases = "intensity between the table's angles";
    makers.push_back({cases, "5 x 2.5 deg", [options] { return of_intensity(5.0, 2.5, "5 x 2.5 deg", options); }});
    makers.push_back({cases, "15 x 5 deg", [options] { return of_intensity(15.0, 5.0, "15 x 5 deg", options); }});
    return makers;
}

} // namespace gonio::measure::detail
