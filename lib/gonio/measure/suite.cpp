#include <gonio/base/kind_text.hpp>
#include <gonio/measure/suite.hpp>
#include <gonio/measure/suites/suites.hpp>

#include <algorithm>
#include <array>

namespace gonio::measure {

namespace {

constexpr std::array all_suites{
    Suite{"irradiance", "illuminance of spheres, disks, rectangles and tubes", detail::irradiance_methods,
          detail::irradiance_contests},
    Suite{"specular", "highlights of the same lights", detail::specular_methods, detail::specular_contests},
    Suite{"brdf", "materials, and the energy that they lose or gain", detail::brdf_methods, detail::brdf_contests},
    Suite{"colour", "the colour of a temperature and the temperature of a colour", detail::color_methods,
          detail::color_contests},
    Suite{"profiles", "files of luminaires, their flux, and intensities between their angles", detail::profile_methods,
          detail::profile_contests},
    Suite{"bake", "textures of a luminaire", detail::bake_methods, detail::bake_contests},
    Suite{"preview", "pictures under one light and under many", detail::preview_methods, detail::preview_contests},
};

std::vector<std::string_view> split(std::string_view list) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t comma = list.find(',');
        parts.push_back(list.substr(0, comma));
        if (comma == std::string_view::npos) return parts;
        list.remove_prefix(comma + 1);
    }
}

} // namespace

std::span<const Suite> suites() {
    return all_suites;
}

Result<std::vector<const Suite*>> parse_suites(std::string_view list) {
    std::vector<const Suite*> found;
    std::vector<std::string_view> names;
    for (const Suite& suite : suites())
        names.push_back(suite.name);
    names.emplace_back("all");
    for (const std::string_view name : split(list)) {
        const std::size_t before = found.size();
        for (const Suite& suite : suites()) {
            const bool named = name == "all" || name == suite.name;
            if (named && std::find(found.begin(), found.end(), &suite) == found.end()) found.push_back(&suite);
        }
        const bool known = std::find(names.begin(), names.end(), name) != names.end();
        if (found.size() == before && !known) return unknown_name("suite", name, names);
    }
    return found;
}

Result<std::vector<std::string>> parse_methods(std::string_view list, std::span<const Suite* const> of) {
    std::vector<std::string> known;
    for (const Suite* suite : of)
        for (std::string& name : suite->methods())
            if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(std::move(name));
    const std::vector<std::string_view> names(known.begin(), known.end());
    std::vector<std::string> found;
    for (const std::string_view name : split(list)) {
        if (std::find(names.begin(), names.end(), name) == names.end()) return unknown_name("method", name, names);
        found.emplace_back(name);
    }
    return found;
}

TimingOptions timing_of(const SuiteOptions& options) {
    TimingOptions timing;
    timing.samples = options.quick ? 9 : 31;
    timing.sample_seconds = 0.002;
    return timing;
}

} // namespace gonio::measure
