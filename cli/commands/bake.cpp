#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/bake/bake.hpp>
#include <gonio/base/atomic_file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
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
#include <cmath>

namespace gonio::cli {

namespace {

constexpr std::array bake_options{
    Option{"--layout", "LAYOUT", "how directions are laid out (latlong)", "layouts"},
    Option{"-s,--size", "WxH", "texels across and down (latlong: 512x256)"},
    Option{"--cone", "ANGLE", "gnomonic: full angle across the middle (90deg)"},
    Option{"--border", "N", "gnomonic: dark texels around (0)"},
    Option{"--normalize", "HOW", "what a texel of 1 means: none (candela), peak, mean, flux (none)", "normalizations"},
    Option{"--pixel", "KIND", "float, half, uint16, uint8: what a texel is stored as (float where the format has it)"},
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
    Example{"gonio bake lamp.ies --layout octahedral-equal-area -s 256x256 -o lamp.exr",
            "every texel the same solid angle"},
    Example{"gonio bake spot.ies --layout gnomonic --cone 60deg --border 1 --normalize peak -o cookie.png",
            "a spot's cookie"},
    Example{"gonio bake lamp.ies --normalize peak -o lamp.exr", "texels between 0 and 1, for engines that scale them"},
    Example{"gonio bake profiles/*.ies -O textures", "a whole folder"},
};

struct Request {
    BakeOptions bake;
    std::optional<media::Pixel> pixel;
    ProfileInputOptions input;
    std::optional<std::string> sidecar;
    bool no_sidecar = false;
};

// The options of the gnomonic layout, which the others refuse.
Result<void> parse_plane(const Arguments& arguments, BakeOptions& bake) {
    for (const char* option : {"--cone", "--border"})
        if (arguments.value(option) && bake.layout != Layout::gnomonic)
            return fail(Failure::usage, fmt::format("{} belongs to the layout gnomonic", option),
                        "add --layout gnomonic");
    if (const auto text = arguments.value("--cone")) {
        Result<double> cone = parse_amount(*text, Dimension::angle, "--cone");
        if (!cone) return pass_on(cone);
        bake.chart.cone = Radians(*cone);
    }
    if (const auto text = arguments.value("--border")) {
        const std::optional<double> border = parse_number(*text);
        if (!border || *border != std::floor(*border) || *border < 0.0 || *border > max_texture_size)
            return fail(Failure::usage, fmt::format("--border takes a number of texels, not '{}'", *text));
        bake.chart.border = static_cast<int>(*border);
    }
    return {};
}

Result<Request> parse(const Arguments& arguments) {
    Request request;
    Result<Layout> layout = parse_layout(arguments.value("--layout").value_or("latlong"));
    if (!layout) return pass_on(layout);
    request.bake.layout = *layout;
    const TextureSize usual = usual_size(*layout);
    request.bake.width = usual.width;
    request.bake.height = usual.height;
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        request.bake.width = size->width;
        request.bake.height = size->height;
    }
    if (Result<void> plane = parse_plane(arguments, request.bake); !plane) return pass_on(plane);
    if (const auto text = arguments.value("--normalize")) {
        Result<Normalization> normalization = parse_normalization(*text);
        if (!normalization) return pass_on(normalization);
        request.bake.normalization = *normalization;
    }
    if (const auto text = arguments.value("--pixel")) {
        std::vector<std::string_view> names;
        for (const media::Pixel known :
             {media::Pixel::float32, media::Pixel::half, media::Pixel::uint16, media::Pixel::uint8}) {
            names.push_back(media::to_text(known));
            if (names.back() == *text) request.pixel = known;
        }
        if (!request.pixel) return unknown_name("pixel", *text, names);
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

TexelType texel_type(media::Pixel pixel) {
    switch (pixel) {
    case media::Pixel::uint8:
        return TexelType::uint8;
    case media::Pixel::uint16:
        return TexelType::uint16;
    case media::Pixel::half:
        return TexelType::half;
    case media::Pixel::float32:
        break;
    }
    return TexelType::float32;
}

// As asked, or the finest that the format has.
Result<media::Pixel> pixel_of(const TextureJob& job, const Request& request) {
    const media::ImageFormat& format = *job.format;
    const bool holds_floats = has_pixel(format, media::Pixel::float32);
    const media::Pixel pixel = request.pixel.value_or(holds_floats ? media::Pixel::float32 : format.pixels.front());
    if (!has_pixel(format, pixel))
        return fail(Failure::usage, fmt::format("{} has no {} pixels", format.title, media::to_text(pixel)),
                    "write .exr for float and half, .png or .tif for uint16 and uint8");
    const bool integers = pixel == media::Pixel::uint8 || pixel == media::Pixel::uint16;
    // An integer texture of candela would be white all over.
    if (integers && request.bake.normalization != Normalization::peak)
        return fail(
            Failure::usage,
            fmt::format("{} stores values from 0 to 1 only", holds_floats ? media::to_text(pixel) : format.title),
            "add --normalize peak, or write .exr");
    return pixel;
}

Result<Outcome> bake(const TextureJob& job, const Request& request, ReportKind kind) {
    Outcome outcome;
    const Stopwatch reading;
    Result<LoadedProfile> loaded = load(job.files.input, request.input);
    if (!loaded) return pass_on(loaded);
    const double read_ms = reading.milliseconds();
    const Stopwatch baking;
    BakeOptions options = request.bake;
    Result<media::Pixel> pixel = pixel_of(job, request);
    if (!pixel) return pass_on(pixel);
    options.texel_type = texel_type(*pixel);
    Result<Texture> texture = bake_texture(loaded->web, options);
    if (!texture) return pass_on(texture);
    outcome.remarks.push_back(
        fmt::format("{}: read in {:.2f} ms, baked in {:.2f} ms", job.files.input, read_ms, baking.milliseconds()));
    Result<std::string> bytes = media::encode_image(texture->image, *job.format, write_options(*texture, *pixel));
    if (!bytes) return pass_on(bytes);
    const std::string sidecar =
        texture_sidecar(*texture, {job.files.input, sha256(loaded->bytes)}, media::to_text(*pixel));
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
