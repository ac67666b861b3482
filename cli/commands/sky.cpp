#include <gonio/sky/sky_description.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../sky/capture.hpp"
#include "../sky/convert.hpp"
#include "../sky/prefilter.hpp"
#include "../sky/request.hpp"
#include "../sky/sky_report.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"image", sky_image_options},
                            OptionGroup{"output", sky_output_options},
                            OptionGroup{"prefilter", sky_prefilter_options},
                            OptionGroup{"capture", sky_capture_options},
                            json_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio sky info cie:12,sun=180/40,horizontal=20klx", "a clear sky: lux on the ground and on walls"},
    Example{"gonio sky info daylight:place=52.52/13.405,time=2024-06-21T12:00+02:00 --json",
            "sky and sun of a place and time"},
    Example{"gonio sky info room.exr --calibrate 500lx", "what an image gives if the desk was measured with 500 lx"},
    Example{"gonio sky convert cie:1,horizontal=10klx -o sky.exr -s 1024", "a sky as a picture in cd/m2"},
    Example{"gonio sky convert outside.hdr --calibrate 80klx --cut-sun --layout cube-cross -o cross.exr",
            "a photograph without its sun, which the sidecar has as a light"},
    Example{"gonio sky prefilter room.exr --for filament -o room.exr",
            "what an engine needs to light with it: room.specular-0.exr and so on"},
    Example{"gonio sky capture --stage room --emits ceiling=300nt --at 0,0,1.2 -o room.exr",
            "a lit stage from one point, as an environment"},
};

constexpr std::array<std::string_view, 8> output_names{"--output", "--to",    "--with-sun", "--layout",
                                                       "--size",   "--pixel", "--sidecar",  "--no-sidecar"};

struct OwnOptions {
    std::string_view action;
    std::span<const Option> options;
    std::string_view hint;
};
constexpr std::array own_options{
    OwnOptions{"prefilter", sky_prefilter_options, "gonio sky prefilter SKY -o FILE"},
    OwnOptions{"capture", sky_capture_options, "gonio sky capture --rig RIG --at X,Y,Z -o FILE"},
};

// Fails (usage) on an option that only other actions take.
Result<void> refuse_others(const Arguments& arguments, std::string_view action) {
    for (const OwnOptions& own : own_options) {
        if (own.action == action) continue;
        for (const Option& option : own.options) {
            const std::string_view name = option.names.substr(option.names.rfind(',') + 1);
            if (arguments.has(name))
                return fail("USE0107", fmt::format("{} is for sky {}, not for 'sky {}'", name, own.action, action),
                            std::string(own.hint));
        }
    }
    return {};
}

Outcome info(const std::string& text, const SkyRequest& request) {
    Outcome outcome;
    Result<LoadedSky> loaded = load_sky(text, request);
    if (!loaded) {
        outcome.error = std::move(loaded.error());
        return outcome;
    }
    outcome.diagnostics = std::move(loaded->diagnostics);
    const SkyReport report = report_of(text, *loaded, request.threads, outcome.diagnostics);
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

// An action that writes files and returns their sidecar, which is `member` of the report.
struct FileAction {
    std::string_view name;
    std::string_view made;
    std::string_view schema;
    std::string_view member;
};

constexpr FileAction convert_action{"convert", "image", "gonio.sky-convert/1", "environment"};
constexpr FileAction prefilter_action{"prefilter", "images", "gonio.sky-prefilter/1", "prefilter"};
constexpr FileAction capture_action{"capture", "image", "gonio.sky-capture/1", "environment"};

// `write` gets the request, and diagnostics that it adds to and has said.
template<class Write>
Result<int> write_files(const FileAction& action, const char* example, const Arguments& arguments, Console& console,
                        const Write& write) {
    const auto output = arguments.value("--output");
    if (!output) return fail("USE0104", "there is no output", fmt::format("add -o FILE, for example -o {}", example));
    const ReportKind kind = report_kind(arguments);
    if (*output == "-" && kind != ReportKind::words) return both_to_standard_output(action.made);
    Result<SkyRequest> request = sky_request(arguments);
    if (!request) return pass_on(request);
    Diagnostics diagnostics;
    Result<Json> sidecar = write(*request, diagnostics);
    if (!sidecar) return pass_on(sidecar);
    if (kind == ReportKind::words) return 0;
    Json report{{"schema", action.schema}, {"output", *output}};
    report[std::string(action.member)] = std::move(*sidecar);
    report["diagnostics"] = diagnostics_json(diagnostics);
    console.print(dump(report, kind == ReportKind::jsonl ? -1 : 2));
    return 0;
}

using WriteSky = Result<Json> (*)(const SkySource&, const LoadedSky&, const SkyRequest&, const Arguments&);

// One sky into files.
Result<int> write_sky(const FileAction& action, WriteSky write, const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.size() != 2)
        return fail(words.size() < 2 ? Cause("USE0104") : Cause("USE0107"),
                    fmt::format("'sky {}' takes one sky, not {}", action.name, words.size() - 1),
                    fmt::format("for example: gonio sky {} cie:1,horizontal=10klx -o sky.exr", action.name));
    return write_files(action, "sky.exr", arguments, console,
                       [&](const SkyRequest& request, Diagnostics& diagnostics) -> Result<Json> {
                           Result<LoadedSky> loaded = load_sky(words[1], request);
                           if (!loaded) return pass_on(loaded);
                           diagnostics = loaded->diagnostics;
                           console.say(diagnostics);
                           return write({words[1], {file_of_sky(words[1])}}, *loaded, request, arguments);
                       });
}

Result<int> capture_one(const Arguments& arguments, Console& console) {
    if (arguments.positional().size() != 1)
        return fail("USE0107", fmt::format("'sky capture' takes no '{}'", arguments.positional()[1]),
                    "the stage and its lights come from --rig, or --stage, --sky and --emits");
    for (const Option& option : sky_image_options)
        if (arguments.has(option.names) && option.names != "--ocio")
            return fail("USE0107", fmt::format("{} is for images, not for 'sky capture'", option.names),
                        "gonio sky info or convert takes the captured image");
    return write_files(capture_action, "room.exr", arguments, console,
                       [&](const SkyRequest& request, Diagnostics& diagnostics) {
                           Result<Json> sidecar = capture_sky(request, arguments, diagnostics);
                           console.say(diagnostics);
                           return sidecar;
                       });
}

Result<int> work(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.empty())
        return fail("USE0104", "info, convert, prefilter or capture?",
                    "gonio sky info SKY measures a sky, gonio sky convert SKY -o FILE writes it as an image, gonio sky "
                    "prefilter SKY -o FILE writes what engines light with, gonio sky capture --rig RIG --at X,Y,Z -o "
                    "FILE shows a lit stage from a point");
    if (Result<void> fine = refuse_others(arguments, words.front()); !fine) return pass_on(fine);
    if (words.front() == "info") return info_all(arguments, console);
    if (words.front() == "convert") return write_sky(convert_action, convert_sky, arguments, console);
    if (words.front() == "capture") return capture_one(arguments, console);
    if (words.front() == "prefilter") return write_sky(prefilter_action, prefilter_sky, arguments, console);
    return fail("USE0103", fmt::format("unknown action '{}'", words.front()),
                fmt::format("write gonio sky info '{0}', gonio sky convert '{0}' -o FILE, or gonio sky prefilter '{0}' "
                            "-o FILE",
                            words.front()));
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
    "info SKY… | convert SKY -o FILE | prefilter SKY -o FILE | capture --rig RIG --at X,Y,Z -o FILE",
    "SKY is an amount (500lx), KIND:key=value,… ('gonio list skies' shows the kinds) or the name of an\n"
    "image: EXR, HDR or float TIFF, as a latlong, a cube cross or strip, or octahedral. '-' is an image on\n"
    "stdin. Pixels are linear and in cd/m2 unless --calibrate or a key says what they give.\n"
    "Azimuths count from north over east; z is up and +Y is north.\n"
    "\n"
    "convert writes pixels in cd/m2, linear Rec.709: each is the mean over its solid angle, so the light of\n"
    "the whole image is kept in every layout and size. The sidecar says what they mean and has the sun of\n"
    "daylight, or the one that --cut-sun took out of a photograph.\n"
    "\n"
    "prefilter writes what engines light with. For -o room.exr: room.specular-0.exr and so on, what a surface\n"
    "of each roughness mirrors (GGX, N = V = R); room.irradiance.exr, illuminance over pi; room.split-sum.exr,\n"
    "the table of the split sum; room.json, which says what the numbers mean, with spherical harmonics and the\n"
    "error of each image against quadrature. 'gonio list prefilters' has the programs of --for.\n"
    "\n"
    "capture shows the stage of a rig, or of --stage, from the point --at, with all its light, as convert\n"
    "writes an image: for local reflections. The frame is that of skies: z up, +Y north.",
    groups,
    examples,
    run};

} // namespace gonio::cli
