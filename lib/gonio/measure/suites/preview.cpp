// Pictures: the renderer of every instruction set, with and without skipping what cannot affect the picture, against
// the illuminance that probe computes in double at the point that each pixel sees.
#include <gonio/measure/random.hpp>
#include <gonio/measure/suites/suites.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio::measure::detail {

namespace {

struct Scene {
    Stage stage;
    std::vector<Light> lights;
};

Light light_of(const char* shape, glm::dvec3 position, double cd, double range_m) {
    LightDescription description;
    description.shape = parse_shape(shape).value();
    description.intensity = {cd, parse_photometric_unit("cd").value()};
    description.position = position;
    if (range_m > 0.0) description.range = Meters(range_m);
    Diagnostics ignored;
    return resolve_light(std::move(description), ignored).value();
}

Scene one_light(const char* shape) {
    Scene scene{make_stage("floor").value(), {}};
    // Above the field of view: a pixel that sees a light has no illuminance.
    scene.lights.push_back(light_of(shape, {0.0, 0.0, 4.0}, 800.0, 0.0));
    return scene;
}

// Small spots over the stage, each with a range of a few metres.
Scene many_lights(std::size_t count, std::uint64_t seed) {
    Scene scene{make_stage("floor").value(), {}};
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i)
        scene.lights.push_back(
            light_of("spot:outer=35deg,inner=20deg",
                     {random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0), random.uniform(1.5, 3.0)}, 50.0, 4.0));
    return scene;
}

// The result of probe at the middle of each pixel; 0 where no surface is visible, and where a pixel and its neighbours
// see different surfaces: there a picture has the means of several points.
std::vector<double> truth_of(const Scene& scene, int size) {
    const CameraRays rays(scene.stage.camera, size, size);
    const auto hit = [&](double x, double y) { return first_hit(scene.stage, rays.ray(x, y)); };
    std::vector<Receiver> receivers;
    std::vector<std::size_t> pixels;
    for (int j = 0; j < size; ++j)
        for (int i = 0; i < size; ++i) {
            const std::optional<Hit> seen = hit(i + 0.5, j + 0.5);
            bool whole = seen.has_value();
            for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {1.5, -0.5}, {-0.5, 1.5}, {1.5, 1.5}}) {
                const std::optional<Hit> other = hit(i + x, j + y);
                whole = whole && other && other->surface == seen->surface;
            }
            if (!whole) continue;
            receivers.push_back({seen->position, seen->normal});
            pixels.push_back(static_cast<std::size_t>(j) * static_cast<std::size_t>(size) +
                             static_cast<std::size_t>(i));
        }
    const std::vector<double> lx = probe(scene.lights, receivers, {}).value().illuminance_lx;
    std::vector<double> truth(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        truth[pixels[i]] = lx[i];
    return truth;
}

Result<Contest> of_scene(const char* name, Scene made, const SuiteOptions& options) {
    const int size = options.quick ? 96 : 192;
    const auto scene = std::make_shared<const Scene>(std::move(made));
    const auto truth = std::make_shared<const std::vector<double>>(truth_of(*scene, size));
    const double brightest = *std::max_element(truth->begin(), truth->end());
    Contest contest{{"preview", name, "all", "relative to the illuminance where it is above 1e-3 of the greatest",
                     "pixel", "probe in double at the middle of each pixel", "skip"},
                    0,
                    {}};
    const auto add = [&](const char* method, bool skip, simd::InstructionSet set) {
        RenderOptions render_options;
        render_options.width = size;
        render_options.height = size;
        render_options.shadows = Shadows::off;
        render_options.illuminance = true;
        render_options.skip = skip;
        render_options.threads = 1;
        render_options.instruction_set = set;
        const auto picture = [scene, render_options] {
            return render(scene->stage, scene->lights, scene->stage.camera, render_options).value();
        };
        const auto errors = [picture, truth, brightest] {
            const Rendering found = picture();
            const std::vector<double> lx(found.illuminance_lx.pixels.begin(), found.illuminance_lx.pixels.end());
            return relative_errors(lx, *truth, 1e-3 * brightest);
        };
        const auto pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        contest.contestants.push_back({method, simd::to_text(set), {[picture] { (void)picture(); }, pixels}, errors});
    };
    for (const simd::InstructionSet set : simd::available_sets()) {
        add("every-light", false, set);
        add("skip", true, set);
    }
    return contest;
}

constexpr std::array shapes{std::pair{"point", "point"},
                            std::pair{"sphere", "sphere:r=10cm"},
                            std::pair{"disk", "disk:r=20cm"},
                            std::pair{"ellipse", "ellipse:w=60cm,h=20cm"},
                            std::pair{"rectangle", "rect:w=60cm,h=30cm"},
                            std::pair{"tube", "tube:r=2cm,l=1m"}};

} // namespace

std::vector<std::string> preview_methods() {
    return {"every-light", "skip"};
}

std::vector<ContestMaker> preview_contests(const SuiteOptions& options) {
    std::vector<ContestMaker> makers;
    for (const auto& [name, shape] : shapes)
        makers.push_back({name, "all", [=, n = name, s = shape] { return of_scene(n, one_light(s), options); }});
    const char* const many = "64 spots";
    makers.push_back({many, "all", [=] { return of_scene(many, many_lights(64, options.seed), options); }});
    return makers;
}

} // namespace gonio::measure::detail
