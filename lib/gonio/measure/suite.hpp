// Suites: what `gonio bench` measures, by name. Each is a list of comparisons on named, seeded cases.
#pragma once

#include <gonio/measure/contest.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::measure {

struct SuiteOptions {
    std::uint64_t seed = 1;
    bool quick = false;   // fewer cases, no subsets
    unsigned threads = 0; // for the reference values; 0 = as many as the machine has. Methods are timed on one.
};

// Cases and reference values take time and memory, so each comparison is made only when it is due.
struct ContestMaker {
    std::string cases;
    std::string subset;
    std::function<Result<Contest>()> make;
};

struct Suite {
    std::string_view name; // "irradiance"
    std::string_view summary;
    std::vector<std::string> (*methods)(); // the names of all methods in any of its comparisons
    std::vector<ContestMaker> (*contests)(const SuiteOptions& options);
};

// irradiance, specular, brdf, colour, profiles, bake, preview, indirect, prefilter, opening.
std::span<const Suite> suites();

// "irradiance,specular" or "all". Fails (usage) on an unknown name and lists all names.
Result<std::vector<const Suite*>> parse_suites(std::string_view list);

// "exact,frostbite": names of methods of at least one suite in `of`. Fails (usage) on any other and lists all names.
Result<std::vector<std::string>> parse_methods(std::string_view list, std::span<const Suite* const> of);

// The timing options for the comparisons of a run.
TimingOptions timing_of(const SuiteOptions& options);

} // namespace gonio::measure
