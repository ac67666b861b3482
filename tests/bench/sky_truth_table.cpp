// What stages show under a sky alone, before anything bounces, against sampled directions that share nothing with it
// but the sky and the surfaces: root mean square and mean of the differences of luminance, relative to the mean, where
// pixels show one surface. With the stage's own materials; and on the solids that the stage is there to show, in other
// materials.
//
//   gonio-sky-truth-table [DIRECTIONS [IMAGE…]]    directions for each half (4000); images beside the skies by formula
#include <gonio/base/parallel.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_description.hpp>

#include "truth_pixels.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

namespace {

using namespace gonio;
using namespace gonio::bench;

// An overcast sky with a window of 15° by 15°, as a photograph of a room has one: most of the light comes from a
// small part of the image.
Sky window_sky() {
    const EnvironmentGrid grid = environment_grid(EnvironmentLayout::latlong, 256).value();
    Image image;
    image.width = grid.width();
    image.height = grid.height();
    image.channels = 3;
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column) {
            const glm::dvec3 way = grid.direction({column + 0.5, row + 0.5});
            const bool window = way.z > 0.3 && way.z < 0.54 && std::abs(std::atan2(way.x, way.y) - 2.2) < 0.13;
            for (const double channel : {1.0, 0.9, 0.8})
                image.pixels.push_back(static_cast<float>(channel * (window ? 4000.0 : 20.0)));
        }
    return resolve_sky(parse_sky_description("image:window").value(),
                       std::make_shared<const EnvironmentMap>(EnvironmentMap::of_valid(grid, std::move(image), 1.0)))
        .value();
}

void print(const StageKind& kind, const char* sky_name, const Sky& sky, const char* material, std::size_t directions) {
    Stage stage = make_stage(kind.name).value();
    const std::vector<std::uint8_t> counts = put_on_subjects(stage, material);
    if (std::find(counts.begin(), counts.end(), 1) == counts.end()) return;
    RenderOptions options;
    options.width = options.height = pixels;
    options.sky = sky;
    const Image picture = render(stage, {}, stage.camera, options).value().luminance_nt;
    const std::vector<Pixel> points = pixels_of_one_surface(stage, counts);
    detail::PathTracer::Options path_options;
    path_options.sky = std::make_shared<const Sky>(sky);
    const detail::PathTracer tracer(stage, {}, path_options);
    std::vector<Point> found(points.size());
    parallel_for(points.size(), 0, [&](std::size_t i) {
        const auto by_directions = [&](std::uint32_t seed) {
            double sum = 0.0;
            for (std::size_t pass = 0; pass < directions; ++pass)
                sum += glm::dot(rec709_luminance,
                                tracer.at(points[i].hit, points[i].view, detail::PixelSequence(pass, seed)).rgb);
            return sum / static_cast<double>(directions);
        };
        const auto seed = static_cast<std::uint32_t>(2 * i);
        found[i] = {luminance_of(picture, points[i].index), by_directions(seed), by_directions(seed + 1)};
    });
    const Errors errors = errors_of(found);
    std::printf("| %s | %s | %s | %.3g nt | %.2f %% | %+.2f %% | %.2f %% | %zu |\n", std::string(kind.name).c_str(),
                sky_name, material != nullptr ? material : "all its own", errors.mean, 100.0 * errors.rms,
                100.0 * errors.bias, 100.0 * errors.noise, points.size());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t directions = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 4000;
    std::puts("| stage | sky | materials | mean | root mean square | bias | noise of the directions | pixels |\n"
              "|---|---|---|---|---|---|---|---|");
    const auto by_formula = [](const char* text) { return resolve_sky(parse_sky_description(text).value()).value(); };
    const std::pair<const char*, Sky> skies[] = {
        {"clear, sun at 40°", by_formula("cie:12,sun=120/40,horizontal=20klx")},
        {"overcast", by_formula("cie:1,horizontal=10klx")},
        {"image with a window", window_sky()}};
    for (const char* stage : {"floor", "spheres", "card"})
        for (const auto& [name, sky] : skies)
            for (const char* material :
                 {static_cast<const char*>(nullptr), "frostbite:base=0.5,smoothness=0.5",
                  "ue4:base=0.9,metallic=1,roughness=0.6", "ue4:base=0.9,metallic=1,roughness=0.3"})
                for (const StageKind& kind : stage_kinds())
                    if (kind.name == stage) print(kind, name, sky, material, directions);
}
