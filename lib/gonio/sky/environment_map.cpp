#include <gonio/base/amount_range.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_map.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace gonio {

namespace {

constexpr glm::dvec3 up{0.0, 0.0, 1.0};
constexpr float largest_half = 65504.0F;

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

struct BadCount {
    std::size_t nan = 0;
    std::size_t infinite = 0;
    std::size_t negative = 0;
    TexelIndex first;

    [[nodiscard]] std::size_t all() const { return nan + infinite + negative; }
};

BadCount count_bad(const Image& image) {
    BadCount bad;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const float* const pixel = image.at(column, row);
            std::size_t* kind = nullptr;
            for (int c = 0; c < 3; ++c) {
                if (std::isnan(pixel[c])) {
                    kind = &bad.nan;
                } else if (kind == nullptr && std::isinf(pixel[c])) {
                    kind = &bad.infinite;
                } else if (kind == nullptr && pixel[c] < 0.0F) {
                    kind = &bad.negative;
                }
            }
            if (kind == nullptr) continue;
            if (bad.all() == 0) bad.first = {column, row};
            ++*kind;
        }
    return bad;
}

std::string to_text(const BadCount& bad) {
    std::string kinds;
    for (const auto& [count, name] :
         {std::pair{bad.nan, "not a number"}, std::pair{bad.infinite, "infinite"}, std::pair{bad.negative, "negative"}})
        if (count > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, name);
    return fmt::format("{} pixel{} cannot be light ({}), the first in column {}, row {}", bad.all(),
                       bad.all() == 1 ? "" : "s", kinds, bad.first.column, bad.first.row);
}

void blacken_bad(Image& image) {
    for (std::size_t i = 0; i + 2 < image.pixels.size(); i += 3) {
        float* const pixel = image.pixels.data() + i;
        if (std::all_of(pixel, pixel + 3, [](float value) { return std::isfinite(value) && value >= 0.0F; })) continue;
        std::fill_n(pixel, 3, 0.0F);
    }
}

// Maxima that a sensor or a format has cut off.
void remark_on_clipping(const Image& image, Diagnostics& diagnostics) {
    std::size_t at_most = 0;
    float most = 0.0F;
    double sum = 0.0;
    for (const float value : image.pixels) {
        if (value > most) {
            most = value;
            at_most = 0;
        }
        if (value == most) ++at_most;
        sum += static_cast<double>(value);
    }
    // A few pixels are equal by chance, and a picture of a uniform room is flat.
    constexpr std::size_t few = 12;
    constexpr double far = 20.0;
    const double mean = sum / static_cast<double>(image.pixels.size());
    if (most == largest_half)
        diagnostics.push_back(result_diagnostic(
            "RES0502",
            fmt::format("{} value{} 65504, where half floats end, and none is greater: brighter light may be cut off",
                        at_most, at_most == 1 ? " is" : "s are"),
            "calibrate on a plane that does not see the sun, and give the sun as a light of its own"));
    else if (at_most >= few && static_cast<double>(most) > far * mean)
        diagnostics.push_back(
            result_diagnostic("RES0503",
                              fmt::format("{} values have the greatest one, {}: brighter light may be cut off", at_most,
                                          rounded(static_cast<double>(most))),
                              "the lux of the brightest light are then too low"));
}

// Sums of rows, added in their order: the same for any number of threads.
template<class Row>
auto sum_of_rows(int rows, unsigned threads, const Row& of_row) {
    using Sum = decltype(of_row(0));
    std::vector<Sum> sums(static_cast<std::size_t>(rows));
    parallel_for(sums.size(), threads, [&](std::size_t row) { sums[row] = of_row(static_cast<int>(row)); });
    return sums;
}

} // namespace

EnvironmentMap::EnvironmentMap(const EnvironmentGrid& grid, Image image, double nits_per_unit)
    : grid_(grid), image_(std::move(image)), nits_per_unit_(nits_per_unit) {}

Result<EnvironmentMap> EnvironmentMap::create(EnvironmentLayout layout, Image image, double nits_per_unit,
                                              BadPixels bad, Diagnostics& diagnostics) {
    if (image.channels != 3 || image.pixels.size() != image.index(0, image.height))
        return fail(Failure::internal, "an environment has three channels and a buffer of its size");
    Result<EnvironmentGrid> grid = EnvironmentGrid::create(layout, image.width, image.height);
    if (!grid) return pass_on(grid);
    // The corners of a cross are no light, whatever they hold.
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column)
            if (!grid->covers({column, row})) std::fill_n(image.at(column, row), 3, 0.0F);
    if (const BadCount found = count_bad(image); found.all() > 0) {
        if (bad == BadPixels::error)
            return fail(Failure::malformed, to_text(found),
                        "bad-pixels=black goes on with these as black: image:FILE,bad-pixels=black");
        diagnostics.push_back(result_diagnostic("RES0501", to_text(found) + ": they are black now"));
        blacken_bad(image);
    }
    remark_on_clipping(image, diagnostics);
    return EnvironmentMap(*grid, std::move(image), nits_per_unit);
}

EnvironmentMap EnvironmentMap::of_valid(const EnvironmentGrid& grid, Image image, double nits_per_unit) {
    return {grid, std::move(image), nits_per_unit};
}

glm::dvec3 EnvironmentMap::texel(TexelIndex index) const {
    const float* const pixel = image_.at(index.column, index.row);
    return nits_per_unit_ * glm::dvec3(pixel[0], pixel[1], pixel[2]);
}

glm::dvec3 EnvironmentMap::radiance(const glm::dvec3& direction) const {
    const glm::dvec2 point = grid_.locate(direction);
    const TexelIndex at{std::clamp(static_cast<int>(point.x), 0, grid_.width() - 1),
                        std::clamp(static_cast<int>(point.y), 0, grid_.height() - 1)};
    const double right = point.x - at.column - 0.5;
    const double below = point.y - at.row - 0.5;
    const int across = right < 0.0 ? -1 : 1;
    const int down = below < 0.0 ? -1 : 1;
    const double s = std::abs(right);
    const double t = std::abs(below);
    return (1.0 - s) * (1.0 - t) * texel(at) + s * (1.0 - t) * texel(grid_.neighbor(at, across, 0)) +
           (1.0 - s) * t * texel(grid_.neighbor(at, 0, down)) + s * t * texel(grid_.neighbor(at, across, down));
}

std::vector<glm::dvec3> EnvironmentMap::irradiance(std::span<const glm::dvec3> normals, unsigned threads) const {
    using Sums = std::vector<glm::dvec3>;
    const double reach = grid_.texel_reach();
    const std::vector<Sums> rows = sum_of_rows(grid_.height(), threads, [&](int row) {
        Sums sums(normals.size(), glm::dvec3(0.0));
        for (int column = 0; column < grid_.width(); ++column) {
            const TexelIndex index{column, row};
            const glm::dvec3 light = texel(index);
            if (light == glm::dvec3(0.0) || !grid_.covers(index)) continue;
            const glm::dvec3 middle = grid_.direction({column + 0.5, row + 0.5});
            std::optional<glm::dvec3> whole;
            for (std::size_t i = 0; i < normals.size(); ++i) {
                const double height = glm::dot(middle, normals[i]);
                if (height < -reach) continue;
                // Once for all planes that see the whole texel.
                if (height > reach && !whole) whole = grid_.direction_integral(index);
                const glm::dvec3 above = height > reach ? *whole : grid_.direction_integral_above(index, normals[i]);
                sums[i] += light * glm::dot(above, normals[i]);
            }
        }
        return sums;
    });
    Sums total(normals.size(), glm::dvec3(0.0));
    for (const Sums& row : rows)
        for (std::size_t i = 0; i < total.size(); ++i)
            total[i] += row[i];
    return total;
}

glm::dvec3 EnvironmentMap::irradiance(const glm::dvec3& normal, unsigned threads) const {
    return irradiance(std::span(&normal, 1), threads).front();
}

glm::dvec3 EnvironmentMap::light(unsigned threads) const {
    const std::vector<glm::dvec3> rows = sum_of_rows(grid_.height(), threads, [&](int row) {
        glm::dvec3 sum(0.0);
        for (int column = 0; column < grid_.width(); ++column)
            if (grid_.covers({column, row})) sum += grid_.solid_angle({column, row}) * texel({column, row});
        return sum;
    });
    glm::dvec3 total(0.0);
    for (const glm::dvec3& row : rows)
        total += row;
    return total;
}

glm::dvec3 EnvironmentMap::light_within(const glm::dvec3& direction, Radians radius) const {
    const double cosine = std::cos(radius.value);
    glm::dvec3 sum(0.0);
    for (int row = 0; row < grid_.height(); ++row)
        for (int column = 0; column < grid_.width(); ++column)
            if (grid_.covers({column, row}) &&
                glm::dot(grid_.direction({column + 0.5, row + 0.5}), direction) >= cosine)
                sum += grid_.solid_angle({column, row}) * texel({column, row});
    return sum;
}

TexelIndex EnvironmentMap::brightest() const {
    TexelIndex best;
    double most = -1.0;
    for (int row = 0; row < grid_.height(); ++row)
        for (int column = 0; column < grid_.width(); ++column) {
            if (!grid_.covers({column, row})) continue;
            const double here = luminance(texel({column, row}));
            if (!(here > most)) continue;
            most = here;
            best = {column, row};
        }
    return best;
}

Result<double> calibration(const EnvironmentMap& map, const Calibration& to, unsigned threads) {
    if (!(to.value > 0.0))
        return fail("USE0106", "an environment is calibrated to more than 0", "for example to 500lx");
    double now = 0.0;
    std::string_view what;
    switch (to.of) {
    case Calibration::Of::illuminance:
        now = luminance(map.irradiance(to.normal, threads));
        what = "gives no light on the plane";
        break;
    case Calibration::Of::mean_luminance:
        now = luminance(map.light(threads)) / (4.0 * std::numbers::pi);
        what = "is black";
        break;
    case Calibration::Of::zenith_luminance:
        now = luminance(map.radiance(up));
        what = "is black at the zenith";
        break;
    }
    if (!(now > 0.0))
        return fail("USE0106", fmt::format("the environment {}: it cannot be calibrated", what),
                    "check that the image has the layout that it is read in");
    const double scale = to.value / now;
    if (!in_amount_range(scale))
        return fail("USE0106",
                    fmt::format("the calibration would make a pixel of 1 more than {} cd/m2", greatest_amount));
    return scale;
}

Result<void> calibrate(EnvironmentMap& map, const Calibration& to, unsigned threads) {
    Result<double> factor = calibration(map, to, threads);
    if (!factor) return pass_on(factor);
    map.set_nits_per_unit(map.nits_per_unit() * *factor);
    return {};
}

} // namespace gonio
