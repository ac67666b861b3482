#include <gonio/base/named.hpp>
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
    Suite{"indirect", "light that bounces between the surfaces of a stage", detail::indirect_methods,
          detail::indirect_contests},
    Suite{"prefilter", "what glossy surfaces mirror of an environment", detail::prefilter_methods,
          detail::prefilter_contests},
    Suite{"opening", "illuminance near the luminous opening of a measured luminaire", detail::opening_methods,
          detail::opening_contests},
    Suite{"image", "illuminance near a rectangle with an image", detail::image_methods, detail::image_contests},
};

} // namespace

std::span<const Suite> suites() {
    return all_suites;
}

Result<std::vector<const Suite*>> parse_suites(std::string_view list) {
    return find_all_named("suite", list, suites(), "all");
}

Result<std::vector<std::string>> parse_methods(std::string_view list, std::span<const Suite* const> of) {
    std::vector<std::string> known;
    for (const Suite* suite : of)
        for (std::string& name : suite->methods())
            if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(std::move(name));
    return find_all_named("method", list, known).map([](const std::vector<const std::string*>& found) {
        std::vector<std::string> names;
        for (const std::string* const name : found)
            names.push_back(*name);
        return names;
    });
}

TimingOptions timing_of(const SuiteOptions& options) {
    TimingOptions timing;
    timing.samples = options.quick ? 9 : 31;
    timing.sample_seconds = 0.002;
    return timing;
}

} // namespace gonio::measure
