// Prefiltered environments: the tree of moments in several tolerances, and what engines sample, against quadrature.
#include <gonio/ibl/environment_tree.hpp>
#include <gonio/ibl/prefilter_methods.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_description.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

namespace gonio::measure::detail {

namespace {

struct Source {
    const char* name;
    const char* sky;
};
constexpr std::array sources{
    Source{"clear", "cie:12,sun=180/40,horizontal=20klx,ground=0.2"},
    Source{"evening", "cie:15,sun=260/4,horizontal=5klx,ground=0.1"},
};
constexpr std::array roughnesses{0.1, 0.25, 0.5, 0.75, 1.0};

struct Environment {
    EnvironmentMap map;
    EnvironmentTree tree;
    EnvironmentMips mips;

    Environment(EnvironmentMap of, unsigned threads) : map(std::move(of)), tree(map, threads), mips(map, threads) {}
};

constexpr std::array tolerances{1e-3, 1e-4, 1e-5, 1e-6};
constexpr std::array sample_counts{64, 1024};
constexpr std::array filtered_counts{32, 256, 1024};

struct PrefilterMethod {
    std::string name;
    std::function<glm::dvec3(const Environment&, const LobeQuery&)> texel;
};

std::vector<PrefilterMethod> all_methods() {
    std::vector<PrefilterMethod> methods;
    for (const double tolerance : tolerances)
        methods.push_back({fmt::format("tree-{:.0e}", tolerance), [=](const Environment& of, const LobeQuery& query) {
                               return of.tree.mean(GgxLobe(query.roughness), query.direction, tolerance);
                           }});
    for (const int count : sample_counts)
        methods.push_back({fmt::format("samples-{}", count), [=](const Environment& of, const LobeQuery& query) {
                               return prefiltered_by_samples(of.map, query, count);
                           }});
    for (const int count : filtered_counts)
        methods.push_back({fmt::format("filtered-{}", count), [=](const Environment& of, const LobeQuery& query) {
                               return prefiltered_by_filtered_samples(of.mips, query, count);
                           }});
    return methods;
}

constexpr std::string_view baseline = "samples-1024";

// On a spiral of the golden angle, turned by the seed.
std::vector<LobeQuery> queries_of(double roughness, const SuiteOptions& options) {
    const int count = options.quick ? 48 : 192;
    constexpr double golden_angle = 2.399963229728653;
    std::vector<LobeQuery> queries;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double r = std::sqrt((1.0 - z) * (1.0 + z));
        const double turn = golden_angle * (i + 0.1 * static_cast<double>(options.seed % 1000));
        queries.push_back({{r * std::cos(turn), r * std::sin(turn), z}, roughness});
    }
    return queries;
}

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

Result<Contest> of_level(const Source& source, double roughness, const SuiteOptions& options) {
    Result<SkyDescription> description = parse_sky_description(source.sky);
    if (!description) return pass_on(description);
    Result<Sky> sky = resolve_sky(*description);
    if (!sky) return pass_on(sky);
    Result<EnvironmentGrid> grid = environment_grid(EnvironmentLayout::cube_strip, options.quick ? 32 : 128);
    if (!grid) return pass_on(grid);
    const auto environment =
        std::make_shared<const Environment>(rendered(*sky, *grid, options.threads), options.threads);
    const auto queries = std::make_shared<const std::vector<LobeQuery>>(queries_of(roughness, options));
    const auto truth = std::make_shared<const std::vector<glm::dvec3>>(
        prefiltered_by_quadrature(environment->map, *queries, options.threads));
    double mean = 0.0;
    for (const glm::dvec3& light : *truth)
        mean += luminance(light) / static_cast<double>(truth->size());

    Contest contest{{"prefilter", source.name, fmt::format("roughness {}", roughness),
                     "relative to the mean luminance of the level", "texel",
                     "quadrature along the outlines of the source's texels", "tree-1e-05"},
                    0,
                    {}};
    for (const PrefilterMethod& method : all_methods()) {
        if (method.name == baseline) contest.baseline = contest.contestants.size();
        const auto values = [environment, queries, texel = method.texel] {
            std::vector<double> nits;
            for (const LobeQuery& query : *queries)
                nits.push_back(luminance(texel(*environment, query)));
            return nits;
        };
        const auto errors = [values, truth, mean] {
            std::vector<double> of_texels = values();
            for (std::size_t i = 0; i < of_texels.size(); ++i)
                of_texels[i] = std::abs(of_texels[i] - luminance((*truth)[i])) / mean;
            return of_texels;
        };
        contest.contestants.push_back({method.name, "double", {[values] { (void)values(); }, queries->size()}, errors});
    }
    return contest;
}

} // namespace

std::vector<std::string> prefilter_methods() {
    std::vector<std::string> names;
    add_names(all_methods(), names);
    return names;
}

std::vector<ContestMaker> prefilter_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const Source& source : sources)
        for (const double roughness : roughnesses) {
            if (options.quick && (&source != sources.data() || (roughness != 0.25 && roughness != 0.75))) continue;
            makers.push_back({source.name, fmt::format("roughness {}", roughness),
                              [=, &source] { return of_level(source, roughness, options); }});
        }
    return makers;
}

} // namespace gonio::measure::detail
