// Irradiance of lights with a size: the closed forms against the approximations of renderers.
#include <gonio/measure/area_methods.hpp>
#include <gonio/measure/sphere_methods.hpp>
#include <gonio/measure/suites/suites.hpp>

#include <array>
#include <optional>

namespace gonio::measure::detail {

namespace {

using Kind = shading::LightConstants::Kind;

// Relative errors are taken where E/L is above this; below it a method's absolute error is more informative.
constexpr double floor_e_over_l = 1e-6;

ContestTitle title(const char* shape, std::optional<Stratum> stratum, const char* truth) {
    return {"irradiance", shape, stratum ? to_text(*stratum) : "all", "relative to E/L", "receiver", truth, "exact"};
}

Result<Contest> of_sphere(std::optional<Stratum> stratum, const SuiteOptions& options) {
    const std::size_t count = options.quick ? 1000 : 4000;
    SphereCases cases = stratum ? sphere_cases_of(*stratum, count, options.seed) : sphere_cases(count, options.seed);
    std::vector<double> truth = sphere_truth(cases, options.threads);
    const auto methods = sphere_methods();
    return contest_of(title("sphere", stratum, "double-exponential quadrature in long double"), methods,
                      place_of(methods, "exact", "float"), std::move(cases), std::move(truth), floor_e_over_l);
}

Result<Contest> of_area(Kind kind, const char* shape, std::optional<Stratum> stratum, const SuiteOptions& options) {
    const std::size_t count = options.quick ? 1024 : 4096; // stays in the second-level cache
    AreaCases cases =
        stratum ? area_cases_of(kind, *stratum, count, options.seed) : area_cases(kind, count, options.seed);
    std::vector<double> truth = area_truth(cases);
    const auto methods = area_methods(kind);
    return contest_of(title(shape, stratum, "the closed form in double, which tests hold against quadrature"), methods,
                      place_of(methods, "exact", "float"), std::move(cases), std::move(truth), floor_e_over_l);
}

constexpr std::array kinds{std::pair{"disk", Kind::disk}, std::pair{"ellipse", Kind::ellipse},
                           std::pair{"rectangle", Kind::rectangle}, std::pair{"tube", Kind::tube},
                           std::pair{"cylinder", Kind::cylinder}};

} // namespace

std::vector<std::string> irradiance_methods() {
    std::vector<std::string> names;
    add_names(sphere_methods(), names);
    for (const auto& [name, kind] : kinds)
        add_names(area_methods(kind), names);
    return names;
}

std::vector<ContestMaker> irradiance_contests(const SuiteOptions& options) {
    std::vector<std::optional<Stratum>> strata{std::nullopt};
    // Not `below`: there the light is not visible, so there is nothing to measure.
    if (!options.quick) strata.insert(strata.end(), {Stratum::above, Stratum::straddling, Stratum::near, Stratum::far});
    std::vector<ContestMaker> makers;
    for (const std::optional<Stratum> stratum : strata) {
        const char* const subset = stratum ? to_text(*stratum) : "all";
        makers.push_back({"sphere", subset, [=] { return of_sphere(stratum, options); }});
        for (const auto& [name, kind] : kinds)
            makers.push_back({name, subset, [=, n = name, k = kind] { return of_area(k, n, stratum, options); }});
    }
    return makers;
}

} // namespace gonio::measure::detail
