// Specular luminance of lights with a size: ltc against its former way and the methods of one direction.
#include <gonio/measure/specular_methods.hpp>
#include <gonio/measure/suites/suites.hpp>

#include <array>

namespace gonio::measure::detail {

namespace {

using Kind = shading::LightConstants::Kind;

constexpr std::array kinds{std::pair{"sphere", Kind::sphere},   std::pair{"disk", Kind::disk},
                           std::pair{"ellipse", Kind::ellipse}, std::pair{"rectangle", Kind::rectangle},
                           std::pair{"tube", Kind::tube},       std::pair{"cylinder", Kind::cylinder}};

// Where the lobe does not reach the light, there is no value for a relative error.
constexpr double floor_luminance = 1e-3;

Result<Contest> of_shape(Kind kind, const char* shape, const SuiteOptions& options) {
    SpecularCases cases = specular_cases(kind, options.quick ? 512 : 4096, options.seed);
    std::vector<double> truth = specular_truth(cases, options.threads);
    const auto methods = measure::specular_methods(kind);
    return contest_of({"specular", shape, "all", "relative to the luminance by GGX with F = 1", "receiver",
                       "adaptive quadrature over the light's solid angle", "ltc"},
                      methods, place_of(methods, "representative-point", "float"), std::move(cases), std::move(truth),
                      floor_luminance);
}

} // namespace

std::vector<std::string> specular_methods() {
    std::vector<std::string> names;
    add_names(measure::specular_methods(Kind::sphere), names);
    return names;
}

std::vector<ContestMaker> specular_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const auto& [name, kind] : kinds)
        makers.push_back({name, "all", [=, n = name, k = kind] { return of_shape(k, n, options); }});
    return makers;
}

} // namespace gonio::measure::detail
