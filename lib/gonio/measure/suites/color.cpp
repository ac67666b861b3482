// Colour temperatures: fits and formulas of other programs against Planck's law, summed in steps of 1 nm.
#include <gonio/color/planckian.hpp>
#include <gonio/measure/color_methods.hpp>
#include <gonio/measure/suites/suites.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gonio::measure::detail {

namespace {

constexpr const char* sum = "Planck's law over the CIE's functions, a sum of 1 nm in double";

struct Range {
    Kelvin coolest;
    Kelvin hottest;
};

// `range`: the same temperatures for all methods; if empty, each method is measured over its own range.
Result<Contest> of_temperature(const char* subset, std::optional<Range> range, const SuiteOptions& options) {
    const std::size_t count = options.quick ? 500 : 2000;
    Contest contest{{"colour", "temperature to colour", subset, "Δu'v'", "temperature", sum, "fit"}, 0, {}};
    for (const ColorSubject& subject : color_subjects()) {
        if (subject.name == "krystek" && subject.code == "double") contest.baseline = contest.contestants.size();
        const std::vector<Kelvin> kelvin = temperatures_between(range ? range->coolest : subject.coolest,
                                                                range ? range->hottest : subject.hottest, count);
        const auto errors = [kelvin, xyz = subject.xyz] {
            std::vector<glm::dvec3> colors(kelvin.size());
            xyz(kelvin, colors);
            std::vector<double> off;
            for (std::size_t i = 0; i < kelvin.size(); ++i)
                off.push_back(delta_uv_prime(to_uv(colors[i]), to_uv(planckian_xyz(kelvin[i]))));
            return off;
        };
        contest.contestants.push_back({subject.name, subject.code, subject.timed, errors});
    }
    return contest;
}

Result<Contest> of_color(const char* subset, Range range, double greatest_duv, const SuiteOptions& options) {
    const std::vector<OffLocus> cases =
        chromaticities_between(range.coolest, range.hottest, greatest_duv, options.quick ? 300 : 2000);
    Contest contest{{"colour", "colour to temperature", subset, "kelvin", "chromaticity", sum, "fit"}, 0, {}};
    const std::vector<OffLocus> timed(cases.begin(), cases.begin() + 256);
    for (const CctSubject& subject : cct_subjects()) {
        if (subject.name == "mccamy") contest.baseline = contest.contestants.size();
        const auto errors = [cases, cct_k = subject.cct_k] {
            std::vector<double> off;
            for (const OffLocus& c : cases)
                off.push_back(std::fabs(cct_k(c.at) - c.truth.temperature.value));
            return off;
        };
        contest.contestants.push_back({subject.name, "double", timed_cct(subject.cct_k, timed), errors});
    }
    return contest;
}

} // namespace

std::vector<std::string> color_methods() {
    std::vector<std::string> names;
    add_names(color_subjects(), names);
    add_names(cct_subjects(), names);
    return names;
}

std::vector<ContestMaker> color_contests(const SuiteOptions& options) {
    const char* const own = "each method's own range";
    const char* const near = "2000-10000 K";
    const char* const near_locus = "2000-10000 K and Duv to 0.005";
    const char* const wide = "1500-40000 K and Duv to 0.05";
    return {{"temperature to colour", own, [=] { return of_temperature(own, std::nullopt, options); }},
            {"temperature to colour", near,
             [=] {
                 return of_temperature(near, Range{Kelvin(2000), Kelvin(10000)}, options);
             }},
            {"colour to temperature", near_locus,
             [=] {
                 return of_color(near_locus, Range{Kelvin(2000), Kelvin(10000)}, 0.005, options);
             }},
            {"colour to temperature", wide, [=] {
                 return of_color(wide, Range{Kelvin(1500), Kelvin(40000)}, 0.05, options);
             }}};
}

} // namespace gonio::measure::detail
