#include <gonio/sky/sky_description.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../sky/convert.hpp"
#include "../sky/request.hpp"
#include "../sky/sky_report.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"image", sky_image_options}, OptionGroup{"output", sky_output_options},
                            json_group, threads_group, common_group};
constexpr std::array examples{
    Example{"gonio sky info cie:12,sun=180/40,horizontal=20klx", "a clear sky: lux on the ground and on walls"},
    Example{"gonio sky info daylight:place=52.52/13.405,time=2024-06-21T12:00+02:00 --json",
            "sky and sun of a place and time"},
    Example{"gonio sky info room.exr --calibrate 500lx", "what an image gives if the desk was measured with 500 lx"},
    Example{"gonio sky convert cie:1,horizontal=10klx -o sky.exr -s 1024", "a sky as a picture in cd/m2"},
    Example{"gonio sky convert outside.hdr --calibrate 80klx --cut-sun --layout cube-cross -o cross.exr",
            "a photograph without its sun, which the sidecar has as a light"},
};

constexpr std::array<std::string_view, 8> output_names{"--output", "--to",    "--with-sun", "--layout",
                                                       "--size",   "--pixel", "--sidecar",  "--no-sidecar"};

Outcome info(const std::string& text, const SkyRequest& request) {
    Outcome outcome;
    Result<LoadedSky> loaded = load_sky(text, request);
    if (!loaded) {
        outcome.error = std::move(loaded.error());
        return outcome;
    }
    outcome.diagnostics = std::move(loaded->diagnostics);
    const SkyReport report = report_of(text, *loaded, outcome.diagnostics);
    outcome.words = to_text(report);
    outcome.report = to_json(report, outcome.diagnostics);
    return outcome;
}

Result<int> info_all(const Arguments& arguments, Console& console) {
    const std::vector<std::string> skies(arguments.positional().begin() + 1, arguments.positional().end());
    if (skies.empty())
        return fail("USE0104", "no sky is given",
                    "for example: gonio sky info cie:12,sun=180/40,horizontal=20klx, gonio sky info room.exr");
    for (const std::string_view name : output_names)
        if (arguments.has(name))
            return fail("USE0107", fmt::format("'sky info' writes no file, but {} is given", name),
                        "gonio sky convert writes one");
    Result<SkyRequest> request = sky_request(arguments);
    if (!request) return pass_on(request);
    const ReportKind kind = report_kind(arguments);
    return run_batch({skies, "gonio.sky/1", "measured", request->threads}, kind, console, [&](std::size_t index) {
        Outcome outcome = info(skies[index], *request);
        if (kind == ReportKind::words) outcome.report = nullptr;
        return outcome;
    });
}

Result<int> convert_one(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.size() != 2)
        return fail(words.size() < 2 ? Cause("USE0104") : Cause("USE0107"),
                    fmt::format("'sky convert' takes one sky, not {}", words.size() - 1),
                    "for example: gonio sky convert cie:1,horizontal=10klx -o sky.exr");
    if (!arguments.has("--output")) return fail("USE0104", "there is no output", "add -o FILE, for example -o sky.exr");
    const ReportKind kind = report_kind(arguments);
    if (arguments.value("--output") == "-" && kind != ReportKind::words) return both_to_standard_output("image");
    Result<SkyRequest> request = sky_request(arguments);
    if (!request) return pass_on(request);
    Result<LoadedSky> loaded = load_sky(words[1], *request);
    if (!loaded) return pass_on(loaded);
    console.say(loaded->diagnostics);
    Result<Json> sidecar = convert_sky(words[1], *loaded, *request, arguments);
    if (!sidecar) return pass_on(sidecar);
    if (kind == ReportKind::words) return 0;
    Json report{{"schema", "gonio.sky-convert/1"}, {"output", *arguments.value("--output")}};
    report["environment"] = std::move(*sidecar);
    report["diagnostics"] = diagnostics_json(loaded->diagnostics);
    console.print(dump(report, kind == ReportKind::jsonl ? -1 : 2));
    return 0;
}

Result<int> work(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.empty())
        return fail("USE0104", "info or convert?",
                    "gonio sky info SKY measures a sky, gonio sky convert SKY -o FILE writes it as an image");
    if (words.front() == "info") return info_all(arguments, console);
    if (words.front() == "convert") return convert_one(arguments, console);
    return fail("USE0103", fmt::format("unknown action '{}'", words.front()),
                fmt::format("write gonio sky info '{0}', or gonio sky convert '{0}' -o FILE", words.front()));
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = work(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command sky_command;
const Command sky_command{
    "sky",
    "measure skies, daylight and environment images in lux, and convert them",
    "info SKY… | convert SKY -o FILE",
    "SKY is an amount (500lx), KIND:key=value,… ('gonio list skies' shows the kinds) or the name of an\n"
    "image: EXR, HDR or float TIFF, as a latlong, a cube cross or strip, or octahedral. '-' is an image on\n"
    "stdin. Pixels are linear and in cd/m2 unless --calibrate or a key says what they give.\n"
    "Azimuths count from north over east; z is up and +Y is north.\n"
    "\n"
    "convert writes pixels in cd/m2, linear Rec.709: each is the mean over its solid angle, so the light of\n"
    "the whole image is kept in every layout and size. The sidecar says what they mean and has the sun of\n"
    "daylight, or the one that --cut-sun took out of a photograph.",
    groups,
    examples,
    run};

} // namespace gonio::cli
