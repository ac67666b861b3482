#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/sun_extraction.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {

namespace {

constexpr double region_radius_deg = 3.0;
constexpr double ring_radius_deg = 6.0;
constexpr double above_surroundings = 2.0;

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

glm::dvec3 middle_of(const EnvironmentGrid& grid, TexelIndex texel) {
    return grid.direction({texel.column + 0.5, texel.row + 0.5});
}

double angle_between_deg(const glm::dvec3& a, const glm::dvec3& b) {
    return to_degrees(Radians(2.0 * std::asin(std::min(0.5 * glm::length(a - b), 1.0))));
}

// The median of each channel over the ring; nothing if there is no texel in it.
std::optional<glm::dvec3> surroundings(const EnvironmentMap& map, const glm::dvec3& middle) {
    const EnvironmentGrid& grid = map.grid();
    std::array<std::vector<double>, 3> values;
    for (int row = 0; row < grid.height(); ++row)
        for (int column = 0; column < grid.width(); ++column) {
            const TexelIndex texel{column, row};
            if (!grid.covers(texel)) continue;
            const double away = angle_between_deg(middle_of(grid, texel), middle);
            if (!(away > region_radius_deg && away <= ring_radius_deg)) continue;
            const glm::dvec3 light = map.texel(texel);
            for (int c = 0; c < 3; ++c)
                values.at(static_cast<std::size_t>(c)).push_back(light[c]);
        }
    if (values[0].empty()) return std::nullopt;
    glm::dvec3 median(0.0);
    for (int c = 0; c < 3; ++c) {
        std::vector<double>& of = values.at(static_cast<std::size_t>(c));
        const auto half = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
        std::nth_element(of.begin(), half, of.end());
        median[c] = *half;
    }
    return median;
}

// Connected texels within the radius that are brighter than `least`.
std::vector<TexelIndex> region_around(const EnvironmentMap& map, TexelIndex start, double least) {
    const EnvironmentGrid& grid = map.grid();
    const glm::dvec3 middle = middle_of(grid, start);
    std::vector<bool> seen(static_cast<std::size_t>(grid.width()) * static_cast<std::size_t>(grid.height()));
    const auto take = [&](TexelIndex texel) {
        const std::size_t at = static_cast<std::size_t>(texel.row) * static_cast<std::size_t>(grid.width()) +
                               static_cast<std::size_t>(texel.column);
        const bool is_new = !seen[at];
        seen[at] = true;
        return is_new;
    };
    std::vector<TexelIndex> region{start};
    take(start);
    for (std::size_t i = 0; i < region.size(); ++i)
        for (int down = -1; down <= 1; ++down)
            for (int across = -1; across <= 1; ++across) {
                if (across == 0 && down == 0) continue;
                const TexelIndex next = grid.neighbor(region[i], across, down);
                if (!grid.covers(next) || !take(next)) continue;
                if (angle_between_deg(middle_of(grid, next), middle) > region_radius_deg) continue;
                if (luminance(map.texel(next)) > least) region.push_back(next);
            }
    return region;
}

} // namespace

Result<ExtractedSun> extract_sun(const EnvironmentMap& map) {
    const EnvironmentGrid& grid = map.grid();
    const TexelIndex brightest = map.brightest();
    const glm::dvec3 middle = middle_of(grid, brightest);
    const std::optional<glm::dvec3> around = surroundings(map, middle);
    if (!around)
        return fail("USE0106", "the image is too coarse to tell the sun from its surroundings",
                    "texels must be smaller than 3 degrees: a latlong of 128x64 or more");
    const double most = luminance(map.texel(brightest));
    const double least = above_surroundings * luminance(*around);
    if (!(most > least))
        return fail("USE0106",
                    fmt::format("there is no sun in the image: its brightest spot is {} times as bright as the "
                                "surroundings",
                                luminance(*around) > 0.0 ? rounded(most / luminance(*around), 3) : "0"),
                    "at least twice as bright is needed");
    const std::vector<TexelIndex> region = region_around(map, brightest, least);

    std::array<glm::dvec3, 3> vector{};
    Image image = map.image();
    ExtractedSun found{map, {}, region.size(), {}};
    for (const TexelIndex& texel : region) {
        const glm::dvec3 before = map.texel(texel);
        const glm::dvec3 omega = grid.direction_integral(texel);
        float* const pixel = image.at(texel.column, texel.row);
        for (int c = 0; c < 3; ++c) {
            pixel[c] = static_cast<float>((*around)[c] / map.nits_per_unit());
            // What the pixel holds then, not what it should: nothing is lost to its rounding.
            const double excess = before[c] - map.nits_per_unit() * static_cast<double>(pixel[c]);
            vector.at(static_cast<std::size_t>(c)) += excess * omega;
        }
        found.region = found.region + Steradians(grid.solid_angle(texel));
    }
    glm::dvec3 sum(0.0);
    for (int c = 0; c < 3; ++c)
        sum += rec709_luminance[c] * vector.at(static_cast<std::size_t>(c));
    const double illuminance = glm::length(sum);
    found.sun.direction = sum / illuminance;
    found.sun.illuminance = Lux(illuminance);
    for (int c = 0; c < 3; ++c)
        found.sun.color[c] = glm::dot(vector.at(static_cast<std::size_t>(c)), found.sun.direction) / illuminance;
    found.sky = EnvironmentMap::of_valid(grid, std::move(image), map.nits_per_unit());
    return found;
}

} // namespace gonio
