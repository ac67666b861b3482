// Near fields of luminaires: rectangles of made profiles, from a quarter of their longer side to eight of them.
#include <gonio/light/light.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/measure/opening_methods.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/web/author.hpp>

#include <fmt/format.h>

#include <array>
#include <memory>
#include <numeric>
#include <utility>

namespace gonio::measure::detail {

namespace {

struct Luminaire {
    const char* name;
    const char* profile; // the grammar of `gonio make`
    const char* opening;
};
constexpr std::array luminaires{
    Luminaire{"panel", "cosine:power=1", "rect:w=0.6m,h=0.6m"},
    Luminaire{"batwing", "batwing", "rect:w=1.2m,h=0.06m"},
    Luminaire{"wall-washer", "wall-washer", "rect:w=0.3m,h=0.1m"},
    Luminaire{"spot", "gaussian:beam=24deg", "rect:w=0.2m,h=0.2m"},
};

Result<Light> luminaire_of(const Luminaire& luminaire) {
    Result<AuthoredShape> shape = parse_authored(luminaire.profile);
    if (!shape) return pass_on(shape);
    Result<Web> web = authored(*shape, AuthorOptions{});
    if (!web) return pass_on(web);
    Result<Opening> opening = parse_opening(luminaire.opening);
    if (!opening) return pass_on(opening);
    LightDescription description;
    description.name = luminaire.name;
    ProfileShape profile;
    profile.web = std::make_shared<const Web>(std::move(*web));
    profile.size = ProfileSize::opening;
    profile.given = std::make_shared<const Opening>(*opening);
    description.shape = std::move(profile);
    Diagnostics ignored;
    return resolve_light(std::move(description), ignored);
}

Result<Contest> of_distance(const Luminaire& luminaire, double sides, const SuiteOptions& options) {
    Result<Light> light = luminaire_of(luminaire);
    if (!light) return pass_on(light);
    OpeningCases cases = opening_cases(*light, sides, options.quick ? 128 : 512, options.seed);
    std::vector<double> truth = opening_truth(cases, options.threads);
    const std::vector<Method<OpeningCases>> methods = measure::opening_methods();
    // A luminaire that is cut off sharply leaves some receivers almost dark.
    const double floor_lx = 1e-2 * std::accumulate(truth.begin(), truth.end(), 0.0) / static_cast<double>(truth.size());
    return contest_of({"opening", luminaire.name, fmt::format("{} sides", sides), "relative", "receiver",
                       "adaptive quadrature to 1e-6", "columns"},
                      methods, place_of(methods, "samples-8", "float"), std::move(cases), std::move(truth), floor_lx);
}

} // namespace

std::vector<std::string> opening_methods() {
    std::vector<std::string> names;
    add_names(measure::opening_methods(), names);
    return names;
}

std::vector<ContestMaker> opening_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const Luminaire& luminaire : luminaires)
        for (const double sides : opening_distances) {
            if (options.quick && (&luminaire != &luminaires[1] || (sides != 0.5 && sides != 2.0))) continue;
            makers.push_back({luminaire.name, fmt::format("{} sides", sides),
                              [=, &luminaire] { return of_distance(luminaire, sides, options); }});
        }
    return makers;
}

} // namespace gonio::measure::detail
