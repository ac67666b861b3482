#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/bake/latlong.hpp>
#include <gonio/base/atomic_file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/media/image_file.hpp>

#include "../arguments.hpp"
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
    Option{"-j,--jobs", "N", "threads (all processors)"},
};
constexpr std::array groups{OptionGroup{"texture", bake_options}, output_group, profile_input_group, json_group,
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
    bool dry_run = false;
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
    request.dry_run = arguments.has("--dry-run");
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

struct Baked {
    std::string sidecar; // the JSON text
    Diagnostics diagnostics;
};

Result<Baked> bake(const Job& job, const Request& request, const Console& console) {
    const Stopwatch reading;
    Result<LoadedProfile> loaded = load(job.input, request.input);
    if (!loaded) return pass_on(loaded);
    const double read_ms = reading.milliseconds();
    const Stopwatch baking;
    Result<Texture> texture = bake_latlong(loaded->web, request.bake);
    if (!texture) return pass_on(texture);
    console.remark(fmt::format("{}: read in {:.2f} ms, baked in {:.2f} ms", job.input, read_ms, baking.milliseconds()));
    // An 8-bit texture of candela would be white all over: integers hold [0, 1].
    const bool holds_floats = has_pixel(*job.format, media::Pixel::float32);
    const media::Pixel pixel = holds_floats ? media::Pixel::float32 : job.format->pixels.front();
    if (!holds_floats && request.bake.normalization != Normalization::peak)
        return fail(Failure::usage, fmt::format("{} stores values from 0 to 1 only", job.format->title),
                    "add --normalize peak, or write .exr");
    Result<std::string> bytes = media::encode_image(texture->image, *job.format, write_options(*texture, pixel));
    if (!bytes) return pass_on(bytes);
    Baked baked;
    baked.diagnostics = std::move(loaded->diagnostics);
    baked.sidecar = texture_sidecar(*texture, {job.input, sha256(loaded->bytes)}, media::to_text(pixel));
    const Result<void> written = write_output(job.output, *bytes);
    if (!written) return Unexpected(written.error());
    const bool beside = request.sidecar || (job.output != "-" && !request.no_sidecar);
    if (beside) {
        const Result<void> described = write_file(request.sidecar.value_or(job.output + ".json"), baked.sidecar);
        if (!described) return Unexpected(described.error());
    }
    return baked;
}

int run(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return console.fail(inputs.error());
    Result<Request> request = parse(arguments);
    if (!request) return console.fail(request.error());
    if (request->sidecar && inputs->size() > 1)
        return console.fail(fail(Failure::usage, "--sidecar names one file, but there are several inputs").value());
    Result<std::vector<Job>> jobs = plan_outputs(arguments, *inputs, "exr");
    if (!jobs) return console.fail(jobs.error());

    const bool lines = arguments.has("--jsonl");
    const bool json = arguments.has("--json");
    if ((json || lines) && jobs->front().output == "-") return console.fail(both_to_standard_output().value());
    Json reports = Json::array();
    int status = 0;
    std::size_t failed = 0;
    for (const Job& job : *jobs) {
        if (job.skip) continue;
        if (request->dry_run) {
            console.print(fmt::format("{} -> {}\n", job.input, job.output));
            continue;
        }
        Result<Baked> baked = bake(job, *request, console);
        if (!baked) {
            Error error = std::move(baked.error());
            // In a batch a message without a file would not tell which input it is about.
            if (jobs->size() > 1 && error.diagnostics.back().location.file.empty())
                error.diagnostics.back().location.file = job.input;
            status = worse(status, console.fail(error));
            ++failed;
            continue;
        }
        console.say(baked->diagnostics);
        if (json || lines) {
            Json report{{"schema", "gonio.bake/1"}, {"output", job.output}};
            report["texture"] = Json::parse(baked->sidecar);
            report["diagnostics"] = diagnostics_json(baked->diagnostics);
            if (lines)
                console.print(dump(report, -1));
            else
                reports.push_back(std::move(report));
        }
    }
    if (json && !lines && !request->dry_run)
        console.print(dump(reports.size() == 1 && jobs->size() == 1 ? reports[0] : reports, 2));
    if (failed > 0 && jobs->size() > 1)
        console.note(fmt::format("{} of {} profiles could not be baked", failed, jobs->size()));
    return status;
}

} // namespace

extern const Command bake_command;
const Command bake_command{"bake",
                           "a profile as a texture whose texels are exact means, with a sidecar",
                           "FILE… --layout LAYOUT -s WxH -o OUT",
                           "FILE is an IES or EULUMDAT profile, '-' for standard input, @LIST for a list of files.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
