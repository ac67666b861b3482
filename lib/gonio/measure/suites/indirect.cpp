// Light that bounces: interreflection in several finenesses, and paths, against a much finer solution.
#include <gonio/base/parallel.hpp>
#include <gonio/measure/stage_lamp.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/transport/interreflection.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace gonio::measure::detail {

namespace {

struct Scene {
    Stage stage;
    std::vector<Light> lights;
    std::vector<Hit> points; // what the pixels of a small picture see
};

// Every material as Lambert, since what is measured is its illuminance.
Scene scene_of(std::string_view name, int size) {
    Scene scene{make_stage(name).value(), {}, {}};
    for (Surface& surface : scene.stage.surfaces)
        surface.material = LambertMaterial{hemispherical_albedo(surface.material)};
    scene.lights.push_back(lamp_over(scene.stage));
    const CameraRays rays(scene.stage.camera, size, size);
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i)
            if (const std::optional<Hit> hit = first_hit(scene.stage, rays.ray(i + 0.5, j + 0.5)))
                scene.points.push_back(*hit);
    return scene;
}

LightingOptions options_of(unsigned threads) {
    LightingOptions options;
    options.bounces = all_bounces;
    options.threads = threads;
    return options;
}

// Rays of its own for each point, on six times as many patches.
std::vector<double> truth_of(const Scene& scene, const SuiteOptions& options) {
    ExchangeQuality fine;
    fine.patches = 48000.0;
    fine.cell_rays = 512;
    fine.node_rays = 2048;
    fine.receiver_rays = options.quick ? 16384 : 65536;
    const Interreflection indirect =
        Interreflection::of(scene.stage, scene.lights, options_of(options.threads), fine).value();
    std::vector<double> lx(scene.points.size());
    parallel_for(lx.size(), options.threads,
                 [&](std::size_t i) { lx[i] = indirect.at(scene.points[i].position, scene.points[i].normal).y; });
    return lx;
}

struct Fineness {
    const char* name;
    ExchangeQuality quality;
};

constexpr std::array finenesses{Fineness{"patches-2000", {2000.0, 64, 256, 1.0, 8192}}, Fineness{"patches-8000", {}},
                                Fineness{"patches-16000", {16000.0, 256, 1024, 1.0, 8192}}};
constexpr std::array path_counts{16, 256};

Result<Contest> of_stage(std::string_view name, const SuiteOptions& options) {
    const auto scene = std::make_shared<const Scene>(scene_of(name, options.quick ? 24 : 48));
    const auto truth = std::make_shared<const std::vector<double>>(truth_of(*scene, options));
    const double mean = std::accumulate(truth->begin(), truth->end(), 0.0) / static_cast<double>(truth->size());
    Contest contest{{"indirect", std::string(name), "all", "relative to the mean indirect illuminance",
                     fmt::format("point of {}", scene->points.size()),
                     "a solution on 48000 patches, with rays of its own for each point", "patches-8000"},
                    1,
                    {}};
    const auto add = [&](std::string method, const std::function<std::vector<double>()>& values) {
        const auto errors = [values, truth, mean] {
            std::vector<double> of_points = values();
            for (std::size_t i = 0; i < of_points.size(); ++i)
                of_points[i] = std::abs(of_points[i] - (*truth)[i]) / mean;
            return of_points;
        };
        contest.contestants.push_back({std::move(method),
                                       simd::to_text(simd::best_available()),
                                       {[values] { (void)values(); }, scene->points.size()},
                                       errors});
    };
    for (const Fineness& fineness : finenesses) {
        if (options.quick && fineness.quality.patches > 8000.0) continue;
        add(fineness.name, [scene, quality = fineness.quality] {
            const Interreflection indirect =
                Interreflection::of(scene->stage, scene->lights, options_of(1), quality).value();
            std::vector<double> lx;
            for (const Hit& point : scene->points)
                lx.push_back(indirect.on_surface(point.surface, point.face, point.position).y);
            return lx;
        });
    }
    for (const int count : path_counts) {
        if (options.quick && count > 16) continue;
        add(fmt::format("paths-{}", count), [scene, count] {
            gonio::detail::PathTracer::Options path_options;
            path_options.bounces = all_bounces;
            const gonio::detail::PathTracer paths(scene->stage, scene->lights, path_options);
            std::vector<double> lx;
            for (std::uint32_t i = 0; i < scene->points.size(); ++i)
                lx.push_back(
                    gonio::detail::indirect_by_paths(paths, scene->points[i], static_cast<std::size_t>(count), i).lx.y);
            return lx;
        });
    }
    return contest;
}

} // namespace

std::vector<std::string> indirect_methods() {
    std::vector<std::string> names;
    for (const Fineness& fineness : finenesses)
        names.emplace_back(fineness.name);
    for (const int count : path_counts)
        names.push_back(fmt::format("paths-{}", count));
    return names;
}

std::vector<ContestMaker> indirect_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const std::string_view name : {"room", "corridor", "floor", "wall", "spheres"}) {
        if (options.quick && name != "room") continue;
        makers.push_back({std::string(name), "all", [=] { return of_stage(name, options); }});
    }
    return makers;
}

} // namespace gonio::measure::detail
