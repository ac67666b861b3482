// Indirect light of every stage against the path tracer, which shares nothing with it but the surfaces: root mean
// square and mean of the differences where the camera looks, relative to the mean indirect illuminance. Two independent
// halves of the paths keep their noise out of the square: the mean of (x − a)(x − b). Then the luminance of what
// bounced, as a picture shows it where pixels show one surface: with the stage's own materials; and on the solids that
// the stage is there to show, in other materials, while all else is Lambertian, which is what reflections alone cost.
//
//   gonio-indirect-truth-table [PATHS [diffuse|luminance [STAGE]]]    paths for each half (8000); every stage
#include <gonio/base/parallel.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/measure/stage_lamp.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/interreflection.hpp>

#include "truth_pixels.hpp"
#include "two_way_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::bench;

constexpr int side = 24;              // points
constexpr double near_m = 0.3;        // of paths from the points
constexpr std::size_t from_lamp = 20; // paths from the lamp, which light all points, for each from a point

void print_diffuse(const StageKind& kind, std::size_t paths) {
    Stage stage = make_stage(kind.name).value();
    for (Surface& surface : stage.surfaces)
        surface.material = LambertMaterial{hemispherical_albedo(surface.material)};
    const std::vector<Light> lights{measure::lamp_over(stage)};

    std::vector<Hit> points;
    const CameraRays rays(stage.camera, side, side);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            if (const std::optional<Hit> hit = first_hit(stage, rays.ray(i + 0.5, j + 0.5))) points.push_back(*hit);

    LightingOptions options;
    options.bounces = all_bounces;
    const Interreflection indirect = Interreflection::of(stage, lights, options).value();
    const TwoWayPaths truth(stage, lights.front(), points, near_m);
    const std::vector<double> first = truth.lx(from_lamp * paths, paths, 0);
    const std::vector<double> second = truth.lx(from_lamp * paths, paths, 1);
    std::vector<Point> found;
    for (std::size_t i = 0; i < points.size(); ++i)
        found.push_back(
            {indirect.on_surface(points[i].surface, points[i].face, points[i].position).y, first[i], second[i]});
    const Errors errors = errors_of(found);
    std::printf("| %s | %.3g lx | %.2f %% | %+.2f %% | %.2f %% | %zu | %zu | %.0f MB |\n",
                std::string(kind.name).c_str(), errors.mean, 100.0 * errors.rms, 100.0 * errors.bias,
                100.0 * errors.noise, indirect.patch_count(), indirect.node_count(),
                static_cast<double>(indirect.memory()) / 1e6);
}

// `material`: of the solids that are subjects; null for the stage as it is.
void print_luminance(const StageKind& kind, const char* material, std::size_t paths) {
    Stage stage = make_stage(kind.name).value();
    const std::vector<std::uint8_t> counts = put_on_subjects(stage, material);
    if (std::find(counts.begin(), counts.end(), 1) == counts.end()) return;
    const std::vector<Light> lights{measure::lamp_over(stage)};
    RenderOptions options;
    options.width = options.height = pixels;
    options.shows_lights = false; // a lamp before a surface hides it from pictures, not from paths
    const Image direct = render(stage, lights, stage.camera, options).value().luminance_nt;
    options.bounces = all_bounces;
    const Image all = render(stage, lights, stage.camera, options).value().luminance_nt;

    const std::vector<Pixel> points = pixels_of_one_surface(stage, counts);
    detail::PathTracer::Options path_options;
    const detail::PathTracer of_direct(stage, lights, path_options);
    path_options.bounces = all_bounces;
    const detail::PathTracer of_all(stage, lights, path_options);
    std::vector<Point> found(points.size());
    parallel_for(points.size(), 0, [&](std::size_t i) {
        // The same numbers give the same direct light, so the difference is what bounced.
        const auto by_paths = [&](std::uint32_t seed) {
            double sum = 0.0;
            for (std::size_t pass = 0; pass < paths; ++pass) {
                const detail::PixelSequence numbers(pass, seed);
                sum += glm::dot(rec709_luminance, of_all.at(points[i].hit, points[i].view, numbers).rgb -
                                                      of_direct.at(points[i].hit, points[i].view, numbers).rgb);
            }
            return sum / static_cast<double>(paths);
        };
        const auto seed = static_cast<std::uint32_t>(2 * i);
        const std::size_t pixel = points[i].index;
        found[i] = {luminance_of(all, pixel) - luminance_of(direct, pixel), by_paths(seed), by_paths(seed + 1)};
    });
    const Errors errors = errors_of(found);
    std::printf("| %s | %s | %.3g nt | %.2f %% | %+.2f %% | %.2f %% | %zu |\n", std::string(kind.name).c_str(),
                material != nullptr ? material : "all its own", errors.mean, 100.0 * errors.rms, 100.0 * errors.bias,
                100.0 * errors.noise, points.size());
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t paths = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 8000;
    const std::string_view part = argc > 2 ? argv[2] : "";
    const std::string_view only = argc > 3 ? argv[3] : "";
    if (part != "luminance") {
        std::puts(
            "| stage | mean indirect | root mean square | bias | noise of the paths | patches | nodes | memory |\n"
            "|---|---|---|---|---|---|---|---|");
        for (const StageKind& kind : stage_kinds())
            if (only.empty() || only == kind.name) print_diffuse(kind, paths);
    }
    if (part == "diffuse") return 0;
    std::puts("| stage | materials | mean indirect | root mean square | bias | noise of the paths | pixels |\n"
              "|---|---|---|---|---|---|---|");
    for (const StageKind& kind : stage_kinds()) {
        if (!only.empty() && only != kind.name) continue;
        for (const char* material : {static_cast<const char*>(nullptr), "frostbite:base=0.5,smoothness=0.5",
                                     "ue4:base=0.9,metallic=1,roughness=0.6", "ue4:base=0.9,metallic=1,roughness=0.3"})
            print_luminance(kind, material, paths);
    }
}
