// Indirect light of every stage against the path tracer, which shares nothing with it but the surfaces: root mean
// square and mean of the differences where the camera looks, relative to the mean indirect illuminance. Two independent
// halves of the paths keep their noise out of the square: the mean of (x − a)(x − b). Arguments: paths for each half
// (8000).
#include <gonio/base/parallel.hpp>
#include <gonio/preview/path_tracer.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/interreflection.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio;

constexpr int side = 24; // points

void print_row(const StageKind& kind, std::size_t paths) {
    Stage stage = make_stage(kind.name).value();
    for (Surface& surface : stage.surfaces)
        surface.material = LambertMaterial{hemispherical_albedo(surface.material)};
    LightDescription description;
    description.shape = parse_shape("disk:r=15cm").value();
    description.intensity = {1000.0, parse_photometric_unit("lm").value()};
    hang(description, stage.light);
    Diagnostics ignored;
    const std::vector<Light> lights{resolve_light(std::move(description), ignored).value()};

    std::vector<Hit> points;
    const CameraRays rays(stage.camera, side, side);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            if (const std::optional<Hit> hit = first_hit(stage, rays.ray(i + 0.5, j + 0.5))) points.push_back(*hit);

    LightingOptions options;
    options.bounces = all_bounces;
    const Interreflection indirect = Interreflection::of(stage, lights, options).value();
    detail::PathTracer::Options path_options;
    path_options.bounces = all_bounces;
    const detail::PathTracer tracer(stage, lights, path_options);
    struct Point {
        double lx, first, second;
    };
    std::vector<Point> found(points.size());
    parallel_for(points.size(), 0, [&](std::size_t i) {
        const auto seed = static_cast<std::uint32_t>(2 * i);
        found[i] = {indirect.on_surface(points[i].surface, points[i].face, points[i].position).y,
                    detail::indirect_by_paths(tracer, points[i], paths, seed).lx.y,
                    detail::indirect_by_paths(tracer, points[i], paths, seed + 1).lx.y};
    });
    double mean = 0.0;
    double bias = 0.0;
    double square = 0.0;
    double noise = 0.0;
    for (const Point& point : found) {
        const double truth = 0.5 * (point.first + point.second);
        mean += truth;
        bias += point.lx - truth;
        square += (point.lx - point.first) * (point.lx - point.second);
        noise += 0.25 * (point.first - point.second) * (point.first - point.second);
    }
    const auto count = static_cast<double>(found.size());
    mean /= count;
    std::printf("| %s | %.3g lx | %.2f %% | %+.2f %% | %.2f %% | %zu | %zu | %.0f MB |\n",
                std::string(kind.name).c_str(), mean, 100.0 * std::sqrt(std::max(square / count, 0.0)) / mean,
                100.0 * bias / count / mean, 100.0 * std::sqrt(noise / count) / mean, indirect.patch_count(),
                indirect.node_count(), static_cast<double>(indirect.memory()) / 1e6);
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t paths = argc > 1 ? static_cast<std::size_t>(std::atoll(argv[1])) : 8000;
    std::puts("| stage | mean indirect | root mean square | bias | noise of the paths | patches | nodes | memory |\n"
              "|---|---|---|---|---|---|---|---|");
    for (const StageKind& kind : stage_kinds())
        print_row(kind, paths);
}
