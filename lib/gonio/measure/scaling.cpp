#include <gonio/bake/bake.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/measure/scaling.hpp>
#include <gonio/measure/strtod_baseline.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace gonio::measure {

namespace {

// One call per sample if the work is long, and only as many samples as a median needs.
constexpr TimingOptions timing{5, 0.002, std::size_t{1} << 20U};

// Adds the time of the work to the curve; false if measuring was stopped, so this is the last point.
Result<bool> add(ScalingCurve& curve, double size, const std::function<void()>& work, const Clock& clock,
                 const ScalingOptions& options) {
    const TimedWork one{work, 1};
    const auto timed = time_in_turn({&one, 1}, 0, timing, clock, options.stop);
    if (!timed) {
        if (options.stop && options.stop()) return false;
        return Unexpected(timed.error());
    }
    if (timed->front()) curve.points.push_back({size, timed->front()->timing});
    return !(options.stop && options.stop());
}

// Small spots of 4 m range, with the same number per square metre for any count.
std::vector<Light> spots(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const double side = std::sqrt(static_cast<double>(count)) * 2.0;
    std::vector<Light> lights;
    for (std::size_t i = 0; i < count; ++i) {
        LightDescription description;
        description.shape = parse_shape("spot:outer=35deg,inner=20deg").value();
        description.intensity = {50.0, parse_photometric_unit("cd").value()};
        description.position = {random.uniform(-side, side), random.uniform(-side, side), random.uniform(1.5, 3.0)};
        description.range = Meters(4.0);
        Diagnostics ignored;
        lights.push_back(resolve_light(std::move(description), ignored).value());
    }
    return lights;
}

RenderOptions picture_of(int size, bool skip, unsigned threads) {
    RenderOptions options;
    options.width = size;
    options.height = size;
    options.skip = skip;
    options.threads = threads;
    return options;
}

// A work of variable size, and its name.
struct Growing {
    const char* name;
    std::function<std::function<void()>(std::size_t size)> make; // prepared; called to be timed
};

Result<std::vector<ScalingCurve>> grow(const std::vector<Growing>& works, const std::vector<std::size_t>& sizes,
                                       const std::function<double(std::size_t)>& x, const Clock& clock,
                                       const ScalingOptions& options) {
    std::vector<ScalingCurve> curves;
    for (const Growing& work : works) {
        curves.push_back({work.name, {}});
        for (const std::size_t size : sizes) {
            const Result<bool> more = add(curves.back(), x(size), work.make(size), clock, options);
            if (!more) return Unexpected(more.error());
            if (!*more) return curves;
            // A work that takes more than a second per call ends the curve: its trend is known by then.
            if (!curves.back().points.empty() && curves.back().points.back().timing.lowest_ns > 1e9) break;
        }
    }
    return curves;
}

double as_is(std::size_t size) {
    return static_cast<double>(size);
}

Result<std::vector<ScalingCurve>> by_lights(const ScalingOptions& options) {
    const Stage stage = make_stage("floor").value();
    Random random(options.seed);
    std::vector<Receiver> receivers;
    for (int i = 0; i < 64; ++i)
        receivers.push_back({{random.uniform(-4.0, 4.0), random.uniform(-4.0, 4.0), 0.0}, {0.0, 0.0, 1.0}});
    const auto render_lights = [&](bool skip) {
        return [&, skip](std::size_t count) -> std::function<void()> {
            return [&stage, lights = spots(count, options.seed), skip] {
                (void)render(stage, lights, stage.camera, picture_of(96, skip, 1)).value();
            };
        };
    };
    const std::vector<Growing> works{{"probe of 64 points",
                                      [&](std::size_t count) -> std::function<void()> {
                                          return [&receivers, lights = spots(count, options.seed)] {
                                              ProbeOptions one_thread;
                                              one_thread.threads = 1;
                                              (void)probe(lights, receivers, one_thread).value();
                                          };
                                      }},
                                     {"picture of 96 x 96, every light", render_lights(false)},
                                     {"picture of 96 x 96", render_lights(true)}};
    const std::vector<std::size_t> sizes =
        options.quick ? std::vector<std::size_t>{1, 16, 256} : std::vector<std::size_t>{1, 4, 16, 64, 256, 1024, 4096};
    return grow(works, sizes, as_is, thread_clock(), options);
}

Result<std::vector<ScalingCurve>> by_pixels(const ScalingOptions& options) {
    const Stage stage = make_stage("floor").value();
    const auto lights = spots(16, options.seed);
    const Web web = authored(parse_authored("street").value(), {}).value();
    const auto bake = [&](Layout layout) {
        return [&web, layout](std::size_t side) -> std::function<void()> {
            return [&web, layout, side] {
                BakeOptions baked;
                baked.layout = layout;
                baked.width = static_cast<int>(side);
                baked.height = static_cast<int>(side);
                baked.threads = 1;
                (void)bake_texture(web, baked).value();
            };
        };
    };
    const std::vector<Growing> works{
        {"picture under 16 spots",
         [&](std::size_t side) -> std::function<void()> {
             return [&, side] {
                 (void)render(stage, lights, stage.camera, picture_of(static_cast<int>(side), true, 1)).value();
             };
         }},
        {"latlong texture", bake(Layout::latlong)},
        {"octahedral texture", bake(Layout::octahedral)}};
    const std::vector<std::size_t> sides =
        options.quick ? std::vector<std::size_t>{32, 128} : std::vector<std::size_t>{32, 64, 128, 256, 512, 1024};
    return grow(
        works, sides, [](std::size_t side) { return static_cast<double>(side * side); }, thread_clock(), options);
}

// A street luminaire's IES file with `count` planes per quadrant and as many γ.
std::string file_of(std::size_t count) {
    AuthorOptions options;
    options.horizontal_step_deg = 90.0 / static_cast<double>(count);
    options.vertical_step_deg = 90.0 / static_cast<double>(count);
    const Web web = authored(parse_authored("street").value(), options).value();
    const MadeProfile made = to_profile(web, {}, *find_profile_target("ies")).value();
    return write_profile(made.profile, *find_profile_target("ies"));
}

Result<std::vector<ScalingCurve>> by_file_size(const ScalingOptions& options) {
    const std::vector<std::size_t> steps =
        options.quick ? std::vector<std::size_t>{6, 30, 90}
                      : std::vector<std::size_t>{3, 6, 15, 30, 90, 180, 450, 600}; // within profile-bytes
    std::vector<std::pair<std::size_t, std::string>> files;
    for (const std::size_t count : steps)
        files.emplace_back(count, file_of(count));
    const auto bytes_of = [&](std::size_t count) -> const std::string& {
        return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.first == count; })->second;
    };
    const std::vector<Growing> works{
        {"strtod over the bytes",
         [&](std::size_t count) -> std::function<void()> {
             return [&bytes = bytes_of(count), sink = std::make_shared<double>()] { *sink += sum_by_strtod(bytes); };
         }},
        {"read",
         [&](std::size_t count) -> std::function<void()> {
             return [&bytes = bytes_of(count)] { (void)read_profile(bytes, "lamp.ies").value(); };
         }},
        {"read and resolve", [&](std::size_t count) -> std::function<void()> {
             return [&bytes = bytes_of(count)] { (void)resolve_web(read_profile(bytes, "lamp.ies").value()).value(); };
         }}};
    return grow(
        works, steps, [&](std::size_t count) { return static_cast<double>(bytes_of(count).size()); }, thread_clock(),
        options);
}

Result<std::vector<ScalingCurve>> by_threads(const ScalingOptions& options) {
    const Stage stage = make_stage("floor").value();
    const auto lights = spots(64, options.seed);
    const Web web = authored(parse_authored("street").value(), {}).value();
    Random random(options.seed);
    std::vector<Receiver> receivers;
    for (int i = 0; i < (options.quick ? 4096 : 16384); ++i)
        receivers.push_back({{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), 0.0}, {0.0, 0.0, 1.0}});
    const std::vector<Growing> works{
        {"picture of 512 x 512 under 64 spots",
         [&](std::size_t threads) -> std::function<void()> {
             return [&, threads] {
                 (void)render(stage, lights, stage.camera, picture_of(512, true, static_cast<unsigned>(threads)))
                     .value();
             };
         }},
        {"probe of points under 64 spots",
         [&](std::size_t threads) -> std::function<void()> {
             return [&, threads] {
                 ProbeOptions probe_options;
                 probe_options.threads = static_cast<unsigned>(threads);
                 (void)probe(lights, receivers, probe_options).value();
             };
         }},
        {"octahedral texture of 256 x 256", [&](std::size_t threads) -> std::function<void()> {
             return [&, threads] {
                 BakeOptions baked;
                 baked.layout = Layout::octahedral;
                 baked.width = 256;
                 baked.height = 256;
                 baked.threads = static_cast<unsigned>(threads);
                 (void)bake_texture(web, baked).value();
             };
         }}};
    std::vector<std::size_t> threads;
    for (std::size_t count = 1; count < available_threads(); count *= 2)
        threads.push_back(count);
    threads.push_back(available_threads());
    // Wall-clock time, which includes the effect of other programs on the machine.
    return grow(works, threads, as_is, steady_clock(), options);
}

constexpr std::array all_scalings{
    Scaling{"lights", "probe and pictures under more and more lights of the same density", "lights", by_lights},
    Scaling{"pixels", "pictures and textures of more and more pixels", "pixels", by_pixels},
    Scaling{"file-size", "IES files of larger and larger tables", "bytes", by_file_size},
    Scaling{"threads", "the same work on more threads, in wall-clock time", "threads", by_threads},
};

} // namespace

std::span<const Scaling> scalings() {
    return all_scalings;
}

Result<std::vector<const Scaling*>> parse_scalings(std::string_view list) {
    return find_all_named("scaling", list, scalings(), "all");
}

} // namespace gonio::measure
