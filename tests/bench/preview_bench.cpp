// Google Benchmark of the preview's renderer; `process_time` is the CPU time of all threads together.
//
// How to read it: times vary with the machine; ratios within one run are stable. Baselines: `…/whole` is the picture of
// the same name without skipping (--no-skip); `pixels` is the smallest picture, `lights` the smallest rig;
// `shadows/…/off` is the picture of the same name without shadows; `indirect/…/off` the one of direct light alone,
// `indirect/…/known` with another amount of light and what is known of the stage, `indirect/…/relit` from the picture
// that was.
//   gonio-bench-preview                     everything
//   gonio-bench-preview --write-rig N FILE  writes the rig of N lights, with a side of 100 m
#include <gonio/base/file.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/preview/relit.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "many_lights.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace gonio;

const std::string profiles_folder = std::string(GONIO_TEST_SOURCE) + "/profiles";

std::vector<Light> lights_of(const std::string& rig_text) {
    Diagnostics diagnostics;
    return resolve_lights(read_rig(rig_text, "rig", profiles_folder).value(), diagnostics).value();
}

std::vector<Light> one_light(const char* shape) {
    return lights_of(std::string(R"({"schema": "gonio.rig/1", "lights": [{"shape": ")") + shape +
                     R"(", "intensity": "3000lm", "position": [0, -0.2, 2.4], "direction": [0, 0, -1]}]})");
}

Stage floor_with(const char* material) {
    Stage stage = make_stage("floor").value();
    for (Surface& surface : stage.surfaces)
        surface.material = parse_material(material).value();
    return stage;
}

// The square of the rigs, seen completely from above its edge.
Stage square(double side_m) {
    Stage stage;
    stage.surfaces.push_back({"ground", Plane{}, parse_material("frostbite:base=0.4,smoothness=0.4").value()});
    stage.camera = {{0.0, -0.75 * side_m, 0.35 * side_m}, {0.0, -0.05 * side_m, 0.0}, {0.0, 0.0, 1.0}, 40.0};
    return stage;
}

struct Picture {
    Stage stage;
    std::vector<Light> lights;
    RenderOptions options;
};

void add(const std::string& name, Picture picture) {
    benchmark::RegisterBenchmark(
        name.c_str(),
        [picture = std::move(picture)](benchmark::State& state) {
            RenderStats stats;
            for (auto _ : state)
                stats = render(picture.stage, picture.lights, picture.stage.camera, picture.options).value().stats;
            state.counters["evaluated"] = static_cast<double>(stats.evaluated);
            state.counters["of"] = static_cast<double>(stats.evaluations);
        })
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

RenderOptions sized(int width, int height, bool skip = true) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.skip = skip;
    return options;
}

Picture twice_as_bright(Picture picture) {
    for (Light& light : picture.lights) {
        light.intensity = Candelas(2.0 * light.intensity.value);
        light.luminance = Nits(2.0 * light.luminance.value);
    }
    return picture;
}

// What comes before takes seconds and counts for nothing: only where it is measured.
template<class Measure>
void add_prepared(const std::string& name, const Measure& measure) {
    benchmark::RegisterBenchmark(name.c_str(), measure)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

void add_indirect(const std::string& name, const Picture& direct) {
    add(name + "/off", direct);
    Picture bounced = direct;
    bounced.options.bounces = all_bounces;
    add(name + "/all", bounced);
    add_prepared(name + "/known", [bounced](benchmark::State& state) {
        Picture again = twice_as_bright(bounced);
        again.options.known =
            render(bounced.stage, bounced.lights, bounced.stage.camera, bounced.options).value().indirect;
        for (auto _ : state)
            benchmark::DoNotOptimize(render(again.stage, again.lights, again.stage.camera, again.options));
    });
    add_prepared(name + "/relit", [bounced](benchmark::State& state) {
        const std::vector<Light> now = twice_as_bright(bounced).lights;
        const Rendering before = render(bounced.stage, bounced.lights, bounced.stage.camera, bounced.options).value();
        for (auto _ : state)
            benchmark::DoNotOptimize(relit(before, bounced.lights, now));
    });
}

void add_all() {
    const Stage floor = floor_with("frostbite");
    for (const char* shape : {"rect:w=60cm,h=60cm", "disk:r=30cm", "sphere:r=10cm", "tube:r=2cm,l=1.2m", "point"})
        add(std::string("512x512/") + shape, {floor, one_light(shape), sized(512, 512)});
    add("512x512/ies", {floor,
                        lights_of(R"({"schema": "gonio.rig/1", "lights": [{"shape": "ies:)" + profiles_folder +
                                  R"(/wall-washer.ies", "position": [0, -0.2, 2.4]}]})"),
                        sized(512, 512)});
    for (const char* stage : {"floor", "spheres", "room"})
        for (const char* shape : {"rect:w=60cm,h=60cm", "disk:r=30cm", "sphere:r=10cm", "tube:r=2cm,l=1.2m"})
            for (const auto& [name, shadows] : {std::pair{"soft", Shadows::soft}, std::pair{"off", Shadows::off}}) {
                RenderOptions options = sized(512, 512);
                options.shadows = shadows;
                const Stage shown = make_stage(stage).value();
                std::vector<Light> light = one_light(shape);
                light.front().frame.origin = shown.light.position;
                add(std::string("shadows/") + stage + "/" + shape + "/" + name, {shown, light, options});
            }
    for (const int size : {256, 512, 1024, 2048})
        add("pixels/" + std::to_string(size) + "x" + std::to_string(size),
            {floor, one_light("rect:w=60cm,h=60cm"), sized(size, size)});
    const auto rig = [](std::size_t count, double side_m) {
        return lights_of(bench::many_lights(count, side_m, profiles_folder));
    };
    // A constant density per square metre, with more and more lights.
    for (const std::size_t count : {10UL, 100UL, 1000UL, 10000UL}) {
        const double side_m = 100.0 * std::sqrt(static_cast<double>(count) / 1000.0);
        add("lights/spread/" + std::to_string(count), {square(100.0), rig(count, side_m), sized(640, 360)});
    }
    for (const std::size_t count : {10UL, 100UL, 1000UL, 10000UL})
        add("lights/dense/" + std::to_string(count), {square(100.0), rig(count, 100.0), sized(640, 360)});
    add("1000 lights", {square(100.0), rig(1000, 100.0), sized(1280, 720)});
    add("1000 lights/whole", {square(100.0), rig(1000, 100.0), sized(1280, 720, false)});
    for (const char* stage : {"room", "corridor", "floor", "spheres"}) {
        const Stage shown = make_stage(stage).value();
        std::vector<Light> light = one_light("rect:w=60cm,h=30cm");
        light.front().frame.origin = shown.light.position;
        add_indirect(std::string("indirect/") + stage, {shown, light, sized(512, 512)});
    }
    add_indirect("indirect/1000 lights", {square(100.0), rig(1000, 100.0), sized(1280, 720)});
}

int write_rig(const char* count, const char* file) {
    const std::string text = bench::many_lights(std::strtoul(count, nullptr, 10), 100.0, profiles_folder);
    return write_file(file, text) ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::string_view(argv[1]) == "--write-rig") return write_rig(argv[2], argv[3]);
    add_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
