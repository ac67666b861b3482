// Suites: what `gonio bench` measures, by name. Each is a list of contests on named, seeded cases.
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
    unsigned threads = 0; // for the truths; 0 = as many as there are. Methods are timed on one.
};

// Cases and truths take time and memory, so each contest is made when it is its turn.
struct ContestMaker {
    std::string cases;
    std::string subset;
    std::function<Result<Contest>()> make;
};

struct Suite {
    std::string_view name; // "irradiance"
    std::string_view summary;
    std::vector<std::string> (*methods)(); // the names of all methods that any of its contests has
    std::vector<ContestMaker> (*contests)(const SuiteOptions& options);
};

// irradiance, specular, brdf, colour, profiles, bake, preview.
std::span<const Suite> suites();

// "irradiance,specular" or "all". Fails (usage) on an unknown name, naming all there are.
Result<std::vector<const Suite*>> parse_suites(std::string_view list);

// "exact,frostbite": names that one of `of` has. Fails (usage) on any other, naming all there are.
Result<std::vector<std::string>> parse_methods(std::string_view list, std::span<const Suite* const> of);

// How contests of a run are timed.
TimingOptions timing_of(const SuiteOptions& options);

} // namespace gonio::measure
