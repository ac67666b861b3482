#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/measured_light.hpp>
#include <gonio/bake/bake.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/measure/stage_lamp.hpp>
#include <gonio/measure/timing.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include "../facts_text.hpp"
#include "../interrupt.hpp"
#include "../json_text.hpp"
#include "../options/values.hpp"
#include "../stopwatch.hpp"
#include "modes.hpp"
#include "standings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

struct Spent {
    double elapsed_ms = 0.0;
    double processor_ms = 0.0; // of all threads together

    Spent operator-(const Spent& other) const {
        return {std::max(elapsed_ms - other.elapsed_ms, 0.0), std::max(processor_ms - other.processor_ms, 0.0)};
    }
};

Spent median(std::vector<Spent> runs) {
    const auto middle = [&](double Spent::*part) {
        std::vector<double> values;
        for (const Spent& run : runs)
            values.push_back(run.*part);
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    };
    return {middle(&Spent::elapsed_ms), middle(&Spent::processor_ms)};
}

// A part of a command's work, and the time that it takes alone.
struct Part {
    std::string_view name;
    std::function<Result<void>()> work;
    // The name of the part whose work this one repeats and adds to: its time is the difference.
    std::string_view adds_to = {};
};

struct TimedPart {
    std::string_view name;
    Spent spent;
};

struct TimeMap {
    std::string what; // "preview: 512 × 512 of the stage floor under a disk"
    std::string item; // "pixel"
    double items = 1.0;
    std::vector<TimedPart> parts;
};

struct TimeMapOptions {
    bool quick = false;
    unsigned threads = 0;
};

// The parts in turn, so that what slows the machine down slows all of them.
Result<std::vector<TimedPart>> timed(const std::vector<Part>& parts, bool quick) {
    const std::size_t rounds = quick ? 3 : 11;
    const measure::Clock processors = measure::process_clock();
    std::vector<std::vector<Spent>> runs(parts.size());
    for (std::size_t round = 0; round <= rounds; ++round)
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (interrupted()) break;
            const double before_s = processors();
            const Stopwatch watch;
            if (Result<void> done = parts[i].work(); !done) return pass_on(done);
            const Spent spent{watch.milliseconds(), 1e3 * (processors() - before_s)};
            if (round > 0) runs[i].push_back(spent); // the first one opens modules and makes tables
        }
    std::vector<TimedPart> all;
    const auto whole = [&](std::string_view name) {
        const auto found =
            std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
        return median(runs[static_cast<std::size_t>(found - parts.begin())]);
    };
    for (const Part& part : parts) {
        const std::size_t index = all.size();
        if (runs[index].empty()) break;
        const Spent spent = median(runs[index]);
        all.push_back({part.name, part.adds_to.empty() ? spent : spent - whole(part.adds_to)});
    }
    return all;
}

Result<TimeMap> of_preview(const TimeMapOptions& options) {
    const Stage stage = make_stage("room").value();
    const Light lamp = measure::lamp_over(stage);
    const std::span<const Light> one(&lamp, 1);
    RenderOptions drawn;
    drawn.width = options.quick ? 128 : 512;
    drawn.height = drawn.width;
    drawn.threads = options.threads;
    const auto rendered = [&](std::span<const Light> lights, Shadows shadows, int bounces) {
        return [&, lights, shadows, bounces]() -> Result<void> {
            RenderOptions chosen = drawn;
            chosen.shadows = shadows;
            chosen.bounces = bounces;
            Result<Rendering> picture = render(stage, lights, stage.camera, chosen);
            if (!picture) return pass_on(picture);
            return {};
        };
    };
    Result<Rendering> picture = render(stage, one, stage.camera, drawn);
    if (!picture) return pass_on(picture);
    const Ev100 exposure = auto_exposure(picture->luminance_nt, picture->shows_light, {}, drawn.threads);
    Image shown;
    const auto display = [&]() -> Result<void> {
        shown = picture->luminance_nt;
        expose(shown, exposure);
        const Result<media::DisplayUsed> used = media::apply_display(shown);
        if (!used) return Unexpected(used.error());
        return {};
    };
    const auto written = [&]() -> Result<void> {
        media::ImageWriteOptions writing;
        writing.color_space = "sRGB";
        writing.dither = true;
        const Result<std::string> bytes = media::encode_image(shown, *media::find_image_format("png"), writing);
        if (!bytes) return Unexpected(bytes.error());
        return {};
    };
    const std::vector<Part> parts{{"rays", rendered({}, Shadows::off, 0)},
                                  {"lights", rendered(one, Shadows::off, 0), "rays"},
                                  {"shadows", rendered(one, Shadows::soft, 0), "lights"},
                                  {"bounced light", rendered(one, Shadows::soft, all_bounces), "shadows"},
                                  {"display", display},
                                  {"writing", written}};
    Result<std::vector<TimedPart>> spent = timed(parts, options.quick);
    if (!spent) return pass_on(spent);
    return TimeMap{
        fmt::format("a picture of {} × {} of the stage room under a disk, as PNG", drawn.width, drawn.height), "pixel",
        static_cast<double>(drawn.width) * drawn.height, std::move(*spent)};
}

// A street luminaire of 2.5° by 1°: about 100 KB of text.
Result<std::string> made_profile() {
    AuthorOptions table;
    table.horizontal_step_deg = 2.5;
    table.vertical_step_deg = 1.0;
    const Web web = authored(parse_authored("street").value(), table).value();
    const ProfileTarget target = *find_profile_target("ies");
    Result<MadeProfile> made = to_profile(web, {}, target);
    if (!made) return pass_on(made);
    return write_profile(made->profile, target);
}

// What every command does with a profile, and then its own parts.
struct ProfileWork {
    std::string bytes;
    std::optional<Profile> profile;
    std::optional<ResolvedWeb> resolved;

    Result<void> read() {
        Result<Profile> found = read_profile(bytes, "lamp.ies");
        if (!found) return pass_on(found);
        profile = std::move(*found);
        return {};
    }
    Result<void> resolve() {
        Result<ResolvedWeb> found = resolve_web(*profile);
        if (!found) return pass_on(found);
        resolved = std::move(*found);
        return {};
    }
};

Result<TimeMap> of_profile(std::string_view end, const TimeMapOptions& options,
                           const std::function<std::vector<Part>(ProfileWork&)>& own) {
    Result<std::string> bytes = made_profile();
    if (!bytes) return pass_on(bytes);
    ProfileWork work{std::move(*bytes), {}, {}};
    const double kilobytes = 1e-3 * static_cast<double>(work.bytes.size());
    std::vector<Part> parts{{"reading", [&] { return work.read(); }}, {"resolving", [&] { return work.resolve(); }}};
    for (Part& part : own(work))
        parts.push_back(std::move(part));
    Result<std::vector<TimedPart>> spent = timed(parts, options.quick);
    if (!spent) return pass_on(spent);
    return TimeMap{fmt::format("an IES file of {:.0f} KB {}", kilobytes, end), "KB", kilobytes, std::move(*spent)};
}

Result<TimeMap> of_bake(const TimeMapOptions& options) {
    std::optional<Texture> texture;
    BakeOptions baked;
    baked.threads = options.threads;
    return of_profile(fmt::format("as a texture of {} × {}, as EXR", baked.width, baked.height), options,
                      [&](ProfileWork& work) {
                          return std::vector<Part>{{"evaluating",
                                                    [&]() -> Result<void> {
                                                        Result<Texture> made = bake_texture(work.resolved->web, baked);
                                                        if (!made) return pass_on(made);
                                                        texture = std::move(*made);
                                                        return {};
                                                    }},
                                                   {"writing", [&]() -> Result<void> {
                                                        media::ImageWriteOptions writing;
                                                        writing.pixel = media::Pixel::half;
                                                        const Result<std::string> bytes = media::encode_image(
                                                            texture->image, *media::find_image_format("exr"), writing);
                                                        if (!bytes) return Unexpected(bytes.error());
                                                        return {};
                                                    }}};
                      });
}

Result<TimeMap> of_import(const TimeMapOptions& options) {
    std::optional<MeasuredLight> light;
    return of_profile("for glTF and USD", options, [&](ProfileWork& work) {
        std::vector<Part> parts{
            {"one form for all", [&]() -> Result<void> {
                 Diagnostics diagnostics;
                 const ProfileHeader header = header_of(*work.profile);
                 const MeasuredLightSource source{"lamp.ies", work.bytes, work.resolved->web, header};
                 Result<MeasuredLight> made = measured_light(source, {}, diagnostics);
                 if (!made) return pass_on(made);
                 light = std::move(*made);
                 return {};
             }}};
        for (const char* const name : {"gltf", "usd"})
            parts.push_back({name, [&, name]() -> Result<void> {
                                 const Result<LightScene> scene = light_scene(*find_target(name).value(), *light);
                                 if (!scene) return Unexpected(scene.error());
                                 return {};
                             }});
        return parts;
    });
}

Result<TimeMap> of_info(const TimeMapOptions& options) {
    std::optional<ProfileFacts> facts;
    return of_profile("to facts", options, [&](ProfileWork& work) {
        return std::vector<Part>{{"facts",
                                  [&]() -> Result<void> {
                                      facts = profile_facts(*work.profile, work.resolved->web, {}, FactsExtent::report);
                                      return {};
                                  }},
                                 {"text", [&]() -> Result<void> {
                                      (void)fact_lines(*facts);
                                      return {};
                                  }}};
    });
}

struct TimeMapKind {
    std::string_view name; // of the command
    Result<TimeMap> (*make)(const TimeMapOptions& options);
};

constexpr std::array kinds{TimeMapKind{"preview", of_preview}, TimeMapKind{"bake", of_bake},
                           TimeMapKind{"import", of_import}, TimeMapKind{"info", of_info}};

Spent sum(const TimeMap& map) {
    Spent all;
    for (const TimedPart& part : map.parts) {
        all.elapsed_ms += part.spent.elapsed_ms;
        all.processor_ms += part.spent.processor_ms;
    }
    return all;
}

// Of the time that so many processors had, what they did not work.
double waiting(const Spent& spent, unsigned threads) {
    return spent.elapsed_ms > 0.0 ? std::max(1.0 - spent.processor_ms / (spent.elapsed_ms * threads), 0.0) : 0.0;
}

std::string text_of(std::string_view command, const TimeMap& map, unsigned threads) {
    const Spent all = sum(map);
    std::string text = fmt::format("\n{}: {}\n  {:<16} {:>10} {:>7} {:>13} {:>10} {:>12}\n", command, map.what, "part",
                                   "elapsed", "share", "processor", "waiting", "ns per " + map.item);
    const auto row = [&](std::string_view name, const Spent& spent) {
        text += fmt::format("  {:<16} {:>7.2f} ms {:>5.1f} % {:>10.2f} ms {:>8.0f} % {:>12.1f}\n", name,
                            spent.elapsed_ms, 100.0 * spent.elapsed_ms / all.elapsed_ms, spent.processor_ms,
                            100.0 * waiting(spent, threads), 1e6 * spent.processor_ms / map.items);
    };
    for (const TimedPart& part : map.parts)
        row(part.name, part.spent);
    row("all", all);
    return text;
}

Json json_of(std::string_view command, const TimeMap& map, unsigned threads) {
    Json parts = Json::array();
    for (const TimedPart& part : map.parts)
        parts.push_back({{"part", part.name},
                         {"elapsed_ms", part.spent.elapsed_ms},
                         {"processor_ms", part.spent.processor_ms},
                         {"waiting", waiting(part.spent, threads)}});
    const Spent all = sum(map);
    return {{"command", command},
            {"work", map.what},
            {"item", map.item},
            {"items", map.items},
            {"elapsed_ms", all.elapsed_ms},
            {"processor_ms", all.processor_ms},
            {"parts", std::move(parts)}};
}

} // namespace

Result<int> bench_time_map(const Arguments& arguments, Console& console) {
    constexpr std::array<std::string_view, 10> others{"--jsonl",   "--suite", "--method",   "--stress", "--count",
                                                      "--scaling", "--seed",  "--markdown", "--csv",    "--output"};
    if (Result<void> fine = refuse_beside("--profile", others, arguments); !fine) return pass_on(fine);
    Result<std::vector<const TimeMapKind*>> chosen =
        find_all_named("command", arguments.value("--profile").value_or("all"), std::span(kinds), "all");
    if (!chosen) return pass_on(chosen);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    const unsigned used = *threads == 0 ? available_threads() : *threads;
    const TimeMapOptions options{arguments.has("--quick"), used};
    BenchRun run;
    run.quick = options.quick;
    const bool words = !arguments.has("--json");
    if (words) console.print(run_text(run) + "\n");
    listen_for_interrupt();
    Json report = run_json(run);
    report["schema"] = "gonio.bench-profile/1";
    report["commands"] = Json::array();
    int status = 0;
    for (const TimeMapKind* const one : *chosen) {
        Result<TimeMap> map = one->make(options);
        if (!map) return pass_on(map);
        if (interrupted()) break;
        if (words)
            console.print(text_of(one->name, *map, used));
        else
            report["commands"].push_back(json_of(one->name, *map, used));
        status = console.flush(status);
    }
    report["complete"] = !interrupted();
    report["diagnostics"] = Json::array();
    if (!words) console.print(dump(report, 2));
    if (!interrupted()) return status;
    console.note("stopped by Ctrl-C");
    return worse(status, interrupted_status);
}

} // namespace gonio::cli
