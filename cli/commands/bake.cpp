#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/bake/latlong.hpp>
#include <gonio/base/atomic_file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/media/image_file.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array bake_options{
    Option{"--layout", "LAYOUT", "how directions are laid out (latlong)", "layouts"},
    Option{"-s,--size", "WxH", "texels across and down (512x256)"},
    Option{"--normalize", "HOW", "what a texel of 1 means: none (candela), peak, mean, flux (none)", "normalizations"},
    Option{"--sidecar", "FILE", "where the JSON that describes the texture goes (OUTPUT.json)"},
    Option{"--no-sidecar", "", "write no such file"},
};
constexpr std::array groups{OptionGroup{"texture", bake_options},
                            output_group,
                            picture_format_group,
                            profile_input_group,
                            json_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio bake lamp.ies --layout latlong -s 512x256 -o lamp.exr",
            "candela in 32-bit float, and lamp.exr.json"},
    Example{"gonio bake lamp.ies --normalize peak -o lamp.exr", "texels between 0 and 1, for engines that scale them"},
    Example{"gonio bake profiles/*.ies -O textures", "a whole folder"},
};

struct Request {
    BakeOptions bake;
    ProfileInputOptions input;
    std::optional<std::string> sidecar;
    bool no_sidecar = false;
};

Result<Request> parse(const Arguments& arguments) {
    Request request;
    const std::string layout = arguments.value("--layout").value_or("latlong");
    if (layout != "latlong") return unknown_name("layout", layout, std::array<std::string_view, 1>{"latlong"});
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        request.bake.width = size->width;
        request.bake.height = size->height;
    }
    if (const auto text = arguments.value("--normalize")) {
        Result<Normalization> normalization = parse_normalization(*text);
        if (!normalization) return pass_on(normalization);
        request.bake.normalization = *normalization;
    }
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.bake.threads = *threads;
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    request.input = *input;
    request.sidecar = arguments.value("--sidecar");
    request.no_sidecar = arguments.has("--no-sidecar");
    return request;
}

media::ImageWriteOptions write_options(const Texture& texture, media::Pixel pixel) {
    media::ImageWriteOptions options;
    options.pixel = pixel;
    options.channel_names = {"Y"};
    const auto number = [](double value) { return std::vector<float>{static_cast<float>(value)}; };
    options.attributes = {{"gonio:layout", texture.layout},
                          {"gonio:normalization", std::string(to_text(texture.normalization))},
                          {"gonio:cd_per_unit", number(texture.cd_per_unit)},
                          {"gonio:peak_cd", number(texture.peak.value)},
                          {"gonio:flux_lm", number(texture.flux.value)}};
    return options;
}

// A texture to make: from where, to where, how stored.
struct TextureJob {
    Job files;
    const media::ImageFormat* format = nullptr;
};

Result<std::vector<TextureJob>> plan(const Arguments& arguments, const std::vector<std::string>& inputs) {
    const std::optional<std::string> named = arguments.value("--to");
    Result<std::vector<Job>> outputs = plan_outputs(arguments, inputs, named.value_or("exr"));
    if (!outputs) return pass_on(outputs);
    std::vector<TextureJob> jobs;
    for (Job& files : *outputs) {
        Result<const media::ImageFormat*> format = picture_format(named, files.output);
        if (!format) return pass_on(format);
        if (!files.skip) jobs.push_back({std::move(files), *format});
    }
    return jobs;
}

Result<Outcome> bake(const TextureJob& job, const Request& request, ReportKind kind) {
    Outcome outcome;
    const Stopwatch reading;
    Result<LoadedProfile> loaded = load(job.files.input, request.input);
    if (!loaded) return pass_on(loaded);
    const double read_ms = reading.milliseconds();
    const Stopwatch baking;
    Result<Texture> texture = bake_latlong(loaded->web, request.bake);
    if (!texture) return pass_on(texture);
    outcome.remarks.push_back(
        fmt::format("{}: read in {:.2f} ms, baked in {:.2f} ms", job.files.input, read_ms, baking.milliseconds()));
    // An 8-bit texture of candela would be white all over: integers hold [0, 1].
    const bool holds_floats = has_pixel(*job.format, media::Pixel::float32);
    const media::Pixel pixel = holds_floats ? media::Pixel::float32 : job.format->pixels.front();
    if (!holds_floats && request.bake.normalization != Normalization::peak)
        return fail(Failure::usage, fmt::format("{} stores values from 0 to 1 only", job.format->title),
                    "add --normalize peak, or write .exr");
    Result<std::string> bytes = media::encode_image(texture->image, *job.format, write_options(*texture, pixel));
    if (!bytes) return pass_on(bytes);
    const std::string sidecar =
        texture_sidecar(*texture, {job.files.input, sha256(loaded->bytes)}, media::to_text(pixel));
    Result<void> written = write_output(job.files.output, *bytes);
    const bool beside = request.sidecar || (job.files.output != "-" && !request.no_sidecar);
    if (written && beside) written = write_file(request.sidecar.value_or(job.files.output + ".json"), sidecar);
    if (!written) return pass_on(written);
    if (kind != ReportKind::words) {
        outcome.report = {{"schema", "gonio.bake/1"}, {"output", job.files.output}};
        outcome.report["texture"] = Json::parse(sidecar);
        outcome.report["diagnostics"] = diagnostics_json(loaded->diagnostics);
    }
    outcome.diagnostics = std::move(loaded->diagnostics);
    return outcome;
}

Result<int> bake_all(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);
    if (request->sidecar && inputs->size() > 1)
        return fail(Failure::usage, "--sidecar names one file, but there are several inputs");
    Result<std::vector<TextureJob>> jobs = plan(arguments, *inputs);
    if (!jobs) return pass_on(jobs);
    const ReportKind kind = report_kind(arguments);
    if (kind != ReportKind::words && arguments.value("--output") == "-") return both_to_standard_output();
    if (arguments.has("--dry-run")) {
        for (const TextureJob& job : *jobs)
            console.print(fmt::format("{} -> {}\n", job.files.input, job.files.output));
        return 0;
    }
    std::vector<std::string> names;
    for (const TextureJob& job : *jobs)
        names.push_back(job.files.input);
    const unsigned threads = request->bake.threads;
    // Threads work on different profiles, or together on the only one.
    if (names.size() > 1) request->bake.threads = 1;
    return run_batch({names, "gonio.bake/1", "baked", threads}, kind, console, [&](std::size_t index) {
        Result<Outcome> outcome = bake((*jobs)[index], *request, kind);
        if (outcome) return std::move(*outcome);
        Outcome failed;
        failed.error = std::move(outcome.error());
        return failed;
    });
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = bake_all(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command bake_command;
const Command bake_command{"bake",
                           "a profile as a texture whose texels are exact means, with a sidecar",
                           "FILE… --layout LAYOUT -s WxH -o OUT",
                           "FILE is an IES or EULUMDAT profile, a folder of them, '-' for standard input,\n"
                           "or @LIST for a list of files.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
