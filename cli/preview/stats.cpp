#include "stats.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>

namespace gonio::cli {

namespace {

double share(std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::string line(const char* what, std::size_t part, std::size_t whole) {
    return fmt::format("  {:<34}{:>14} {:>8.2f} %\n", what, part, 100.0 * share(part, whole));
}

} // namespace

std::string stats_text(const RenderStats& stats, double milliseconds, const std::vector<std::string>& modules) {
    std::string text = fmt::format("{} lights ({} without flux, {} with a web looked up by gamma alone), {} tiles, {} "
                                   "surface points\n",
                                   stats.lights, stats.dark_lights, stats.axial_webs, stats.tiles, stats.samples);
    text += line("points on surfaces without specular", stats.samples_without_specular, stats.samples);
    text += line("pairs of light and tile that meet", stats.pairs_lit, stats.pairs);
    text += fmt::format("  {:<34}{:>14}\n", "evaluations of all lights", stats.evaluations);
    text += line("done", stats.evaluated, stats.evaluations);
    text += line("as seen from the light's centre", stats.from_center, stats.evaluations);
    text += line("as a point at the light's centre", stats.as_point, stats.evaluations);
    text += line("skipped: without flux", stats.dark, stats.evaluations);
    text += line("skipped: out of range", stats.out_of_range, stats.evaluations);
    text += line("skipped: outside the light's cone", stats.outside_cone, stats.evaluations);
    text += line("skipped: behind the surface", stats.below_horizon, stats.evaluations);
    text += line("skipped: in shadow", stats.in_shadow, stats.evaluations);
    text += fmt::format("  {:<34}{:>14}\n", "shadow tests done", stats.shadow_tested);
    text += line("found a part of a light hidden", stats.in_penumbra, stats.shadow_tested);
    text += fmt::format("  {:<34}{:>14.1f} ms\n", "time", milliseconds);
    text += fmt::format("  {:<34}{}\n", "modules opened",
                        modules.empty() ? "none" : fmt::format("{}", fmt::join(modules, ", ")));
    return text;
}

Json stats_json(const RenderStats& stats, double milliseconds, const std::vector<std::string>& modules) {
    return {{"time_ms", milliseconds},
            {"lights", stats.lights},
            {"dark_lights", stats.dark_lights},
            {"axial_webs", stats.axial_webs},
            {"tiles", stats.tiles},
            {"samples", stats.samples},
            {"samples_without_specular", stats.samples_without_specular},
            {"pairs", stats.pairs},
            {"pairs_lit", stats.pairs_lit},
            {"evaluations", stats.evaluations},
            {"evaluated", stats.evaluated},
            {"from_center", stats.from_center},
            {"as_point", stats.as_point},
            {"skipped_dark", stats.dark},
            {"skipped_out_of_range", stats.out_of_range},
            {"skipped_outside_cone", stats.outside_cone},
            {"skipped_below_horizon", stats.below_horizon},
            {"skipped_in_shadow", stats.in_shadow},
            {"shadow_tested", stats.shadow_tested},
            {"in_penumbra", stats.in_penumbra},
            {"modules", modules}};
}

} // namespace gonio::cli
