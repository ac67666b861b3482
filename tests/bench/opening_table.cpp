// The near field of measured luminaires by every method of the suite `opening`: errors over all receivers of a
// distance, for the profiles that are named, as a table in Markdown.
//
//   gonio-opening-table FILE... [RECEIVERS]
//
// RECEIVERS (240) are those of each profile at each distance. Profiles without a rectangular opening are left out.
#include <gonio/light/luminaire.hpp>
#include <gonio/measure/opening_methods.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

namespace {

using namespace gonio;

double quantile(std::vector<double> values, double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

} // namespace

int main(int count, char** arguments) {
    std::size_t receivers = 240;
    std::vector<Light> lights;
    for (int i = 1; i < count; ++i) {
        const std::string text = arguments[i];
        if (text.find_first_not_of("0123456789") == std::string::npos) {
            receivers = std::strtoul(text.c_str(), nullptr, 10);
            continue;
        }
        LightDescription description;
        description.name = text;
        description.shape = ProfileShape{text, nullptr, ProfileSize::opening};
        Diagnostics ignored;
        Result<Light> light = resolve_light(std::move(description), ignored);
        if (!light || light->parts == nullptr || !std::holds_alternative<RectShape>(light->parts->front().shape)) {
            std::fprintf(stderr, "left out: %s\n", text.c_str());
            continue;
        }
        lights.push_back(std::move(*light));
    }
    std::printf("%zu profiles, %zu receivers each; errors in %%: median / 95th percentile\n\n| sides |", lights.size(),
                receivers);
    const auto methods = measure::opening_methods();
    for (const auto& method : methods)
        std::printf(" %s, %s |", method.name.c_str(), method.precision.c_str());
    std::printf("\n|---|");
    for (std::size_t i = 0; i < methods.size(); ++i)
        std::printf("---|");
    std::printf("\n");
    for (const double sides : measure::opening_distances) {
        std::vector<std::vector<double>> errors(methods.size());
        for (std::size_t l = 0; l < lights.size(); ++l) {
            const measure::OpeningCases cases = measure::opening_cases(lights[l], sides, receivers, l + 1);
            const std::vector<double> truth = measure::opening_truth(cases, 0);
            for (std::size_t m = 0; m < methods.size(); ++m) {
                const std::vector<double> lx = measure::evaluated(methods[m], cases);
                for (std::size_t i = 0; i < lx.size(); ++i)
                    if (truth[i] > 0.0) errors[m].push_back(100.0 * std::abs(lx[i] / truth[i] - 1.0));
            }
        }
        std::printf("| %g |", sides);
        for (const std::vector<double>& of : errors)
            std::printf(" %.3g / %.3g |", quantile(of, 0.5), quantile(of, 0.95));
        std::printf("\n");
    }
}
