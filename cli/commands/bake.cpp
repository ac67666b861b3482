#include "../arguments.hpp"
#include "../bake/request.hpp"
#include "../bake/table_job.hpp"
#include "../bake/texture_job.hpp"
#include "../batch.hpp"
#include "../catalogue.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"texture", bake_options},
                            OptionGroup{"table", table_options},
                            output_group,
                            OptionGroup{"format", bake_format_options},
                            profile_input_group,
                            json_group,
                            catalogue_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio bake lamp.ies --layout latlong -s 512x256 -o lamp.exr",
            "candela in 32-bit float, and lamp.exr.json"},
    Example{"gonio bake lamp.ies --layout octahedral-equal-area -s 256x256 -o lamp.exr", "texels of equal solid angle"},
    Example{"gonio bake spot.ies --layout gnomonic --cone 60deg --border 1 --normalize peak -o cookie.png",
            "a cookie for a spot light"},
    Example{"gonio bake lamp.ies --engine unity-spot --cone 80deg -o cookie.png",
            "a cookie for Unity; 'gonio list engines' shows all engines"},
    Example{"gonio bake library --engine unity-spot,unreal -O textures",
            "for two engines, each in a folder of its own"},
    Example{"gonio bake lamp.ies --layout cube -s 128x128 -o lamp.exr",
            "six files lamp-px.exr, -nx, -py, -ny, -pz, -nz, and lamp.exr.json"},
    Example{"gonio bake lamp.ies -s auto --max-error 1% -o lamp.exr", "the smallest texture within 1 % of the peak"},
    Example{"gonio bake library -u -O textures --manifest textures.json",
            "a whole folder; textures that are up to date are skipped"},
    Example{"gonio bake library --shard 2/8 -O textures --manifest 2.json", "the second of eight jobs"},
    Example{"gonio bake --table dfg -s 16 --pixel half -o dfg.dds", "the split sum as a table for shaders"},
    Example{"gonio bake --table ltc-ggx -s 32 --pixel half -o ltc.h", "a table and its lookup as a C header"},
    Example{"gonio bake --merge 1.json 2.json -o all.json", "one manifest for all jobs"},
};

Result<int> bake_all(const Arguments& arguments, Console& console) {
    for (const char* const option : {"--axes", "--form"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} is only for tables", option), "add --table dfg");
    if (arguments.has("--merge")) return merge_manifests(arguments, console);
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<std::vector<BakeRequest>> requests = parse_bake(arguments);
    if (!requests) return pass_on(requests);
    const BakeRequest& first = requests->front();
    if (first.sidecar && inputs->size() > 1)
        return fail("USE0107", "--sidecar names one file, but there are several inputs");
    std::vector<TextureJob> jobs;
    for (const BakeRequest& request : *requests) {
        Result<std::vector<TextureJob>> planned = plan_textures(arguments, request, *inputs);
        if (!planned) return pass_on(planned);
        std::move(planned->begin(), planned->end(), std::back_inserter(jobs));
    }
    const ReportKind kind = report_kind(arguments);
    if ((kind != ReportKind::words || first.stats) && arguments.value("--output") == "-")
        return both_to_standard_output();
    if (kind != ReportKind::words && first.sidecar == "-") return both_to_standard_output("sidecar");
    std::vector<std::string> outputs;
    for (const TextureJob& job : jobs)
        outputs.insert(outputs.end(), job.pictures.begin(), job.pictures.end());
    console.say(names_that_differ_by_case(outputs));
    const auto stays = [&](const TextureJob& job) { return first.update && is_up_to_date(job); };
    if (arguments.has("--dry-run")) {
        for (const TextureJob& job : jobs)
            if (!stays(job))
                for (const std::string& picture : job.pictures)
                    console.print(fmt::format("{} -> {}\n", job.files.input, picture));
        return 0;
    }
    std::vector<std::string> names;
    for (const TextureJob& job : jobs)
        names.push_back(job.files.input);
    const unsigned threads = first.bake.threads;
    // Threads work on different textures, or together on a single one.
    if (names.size() > 1)
        for (BakeRequest& request : *requests)
            request.bake.threads = 1;
    return run_catalogue({names, "gonio.bake/1", "baked", threads}, first.catalogue,
                         jobs.empty() ? std::string() : jobs.front().recipe, kind, console, [&](std::size_t index) {
                             const TextureJob& job = jobs[index];
                             return stays(job) ? found_texture(job, kind) : make_texture(job, kind);
                         });
}

} // namespace

extern const Command bake_command;

namespace {

int run(const Arguments& arguments, Console& console) {
    const Result<int> status =
        arguments.has("--table") ? bake_table(bake_command, arguments, console) : bake_all(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

const Command bake_command{
    "bake",
    "write a profile as a texture of exact means, or a table for shaders, with a sidecar",
    "FILE… --layout LAYOUT -s WxH -o OUT | --table NAME -s N -o OUT",
    "FILE is an IES, EULUMDAT or TM-33 profile, a folder of profiles, '-' for stdin, or @LIST\n"
    "for a list of files. EXR files also carry the fields of the sidecar as attributes gonio:…;\n"
    "PNG and TIFF cannot. With -u, a texture is outdated if its sidecar names other input bytes or\n"
    "options, or if the texture does not hold the bytes that the sidecar names; without a sidecar,\n"
    "if it is older than its input.\n"
    "\n"
    "--table takes no FILE. OUT ends in .exr, .dds, .raw, .bin, .h, .hpp or .json. The size is 32\n"
    "texels a side, or 10 terms, unless -s says so; pixels are float unless --pixel says so, and\n"
    "integers go over the range of each channel. The sidecar has the axes, the lookup in GLSL, HLSL,\n"
    "MSL and WGSL, and its error against quadrature.",
    groups,
    examples,
    run};

} // namespace gonio::cli
