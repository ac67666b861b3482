// Near fields of rectangles with an image: a smooth one and one with edges, from a quarter of their longer side to
// eight of them.
#include <gonio/base/image.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/measure/image_methods.hpp>
#include <gonio/measure/suites/suites.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace gonio::measure::detail {

namespace {

struct Panel {
    const char* name;
    float (*pixel)(int column, int row);
};

constexpr int columns = 256;
constexpr int rows = 160;

float gradient(int column, int row) {
    const float x = static_cast<float>(column) / columns;
    const float y = static_cast<float>(row) / rows;
    return 0.02F + 0.98F * x * x * (0.5F + 0.5F * std::cos(6.0F * y));
}

// Letters of a sign: bright bars on dark ground.
float sign(int column, int row) {
    const bool bar = column % 40 < 12 || row % 53 < 9;
    return bar && row > 20 && row < 140 ? 1.0F : 0.01F;
}

constexpr std::array panels{Panel{"gradient", gradient}, Panel{"sign", sign}};

Result<Light> light_of(const Panel& panel) {
    Image image(columns, rows, 1);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            image.at(column, row)[0] = panel.pixel(column, row);
    Result<LightImage> made = LightImage::create(image);
    if (!made) return pass_on(made);
    RectShape rect{Meters(1.0), Meters(0.6)};
    rect.mask_file = fmt::format("{}.exr", panel.name);
    rect.image = std::make_shared<const LightImage>(std::move(*made));
    LightDescription description;
    description.name = panel.name;
    description.shape = std::move(rect);
    description.intensity = PhotometricValue{1000.0, {find_unit("lm"), std::nullopt, std::nullopt}};
    Diagnostics ignored;
    return resolve_light(std::move(description), ignored);
}

Result<Contest> of_distance(const Panel& panel, double sides, const SuiteOptions& options) {
    Result<Light> light = light_of(panel);
    if (!light) return pass_on(light);
    OpeningCases cases = opening_cases(*light, sides, options.quick ? 128 : 512, options.seed);
    std::vector<double> truth = opening_truth(cases, options.threads);
    const std::vector<Method<OpeningCases>> methods = measure::image_methods();
    const double floor_lx = 1e-2 * std::accumulate(truth.begin(), truth.end(), 0.0) / static_cast<double>(truth.size());
    return contest_of({"image", panel.name, fmt::format("{} sides", sides), "relative", "receiver",
                       "sums over pixels to 1e-6", "nodes"},
                      methods, place_of(methods, "samples-8", "float"), std::move(cases), std::move(truth), floor_lx);
}

} // namespace

std::vector<std::string> image_methods() {
    std::vector<std::string> names;
    add_names(measure::image_methods(), names);
    return names;
}

std::vector<ContestMaker> image_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const Panel& panel : panels)
        for (const double sides : opening_distances) {
            if (options.quick && (&panel != &panels[1] || (sides != 0.5 && sides != 2.0))) continue;
            makers.push_back({panel.name, fmt::format("{} sides", sides),
                              [=, &panel] { return of_distance(panel, sides, options); }});
        }
    return makers;
}

} // namespace gonio::measure::detail
