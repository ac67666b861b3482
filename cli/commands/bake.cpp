#include <gonio/asset/manifest.hpp>
#include <gonio/base/atomic_file.hpp>

#include "../arguments.hpp"
#include "../bake/request.hpp"
#include "../bake/texture_job.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

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
    Example{"gonio bake lamp.ies --engine unity-spot --cone 80deg -o cookie.png",
            "as an engine reads it; gonio list engines"},
    Example{"gonio bake lamp.ies --layout cube -s 128x128 -o lamp.exr",
            "six files lamp-px.exr, -nx, -py, -ny, -pz, -nz, and lamp.exr.json"},
    Example{"gonio bake lamp.ies -s auto --max-error 1% -o lamp.exr", "the smallest texture that is that near"},
    Example{"gonio bake library -u -O textures --manifest textures.json",
            "a whole folder; what the same input and options have made already stays"},
    Example{"gonio bake library --shard 2/8 -O textures --manifest 2.json", "one of eight jobs"},
    Example{"gonio bake --merge 1.json 2.json -o all.json", "what all jobs have made"},
};

Result<int> merge_manifests(const Arguments& arguments, Console& console) {
    const std::optional<std::string> output = arguments.value("--output");
    if (!output) return fail(Failure::usage, "no output is given", "use -o FILE");
    Result<std::vector<std::string>> names = input_files(arguments);
    if (!names) return pass_on(names);
    std::vector<Manifest> manifests;
    for (const std::string& name : *names) {
        Result<std::string> text = name == "-" ? read_standard_input() : read_file(name);
        if (!text) return pass_on(text);
        Result<Manifest> manifest = read_manifest(*text, name);
        if (!manifest) return pass_on(manifest);
        manifests.push_back(std::move(*manifest));
    }
    const Result<Manifest> whole = merged(manifests);
    if (!whole) return Unexpected(whole.error());
    if (Result<void> written = write_output(*output, manifest_json(*whole)); !written) return pass_on(written);
    console.note(fmt::format("{} manifests merged: {} inputs, {} failed", manifests.size(), whole->inputs,
                             whole->failed.size()));
    return 0;
}

// Lists what is whole and what failed, in the order of the inputs.
Result<void> write_manifest(const BakeRequest& request, const std::vector<TextureJob>& jobs,
                            std::vector<ManifestAsset> assets) {
    Manifest manifest;
    manifest.shard = request.shard;
    manifest.inputs = jobs.size();
    if (!jobs.empty()) manifest.recipe = jobs.front().recipe;
    for (std::size_t i = 0; i < jobs.size(); ++i)
        if (assets[i].files.empty())
            manifest.failed.push_back(jobs[i].files.input);
        else
            manifest.assets.push_back(std::move(assets[i]));
    return write_output(*request.manifest, manifest_json(manifest));
}

Result<int> bake_all(const Arguments& arguments, Console& console) {
    if (arguments.has("--merge")) return merge_manifests(arguments, console);
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<BakeRequest> request = parse_bake(arguments);
    if (!request) return pass_on(request);
    if (request->sidecar && inputs->size() > 1)
        return fail(Failure::usage, "--sidecar names one file, but there are several inputs");
    const Result<std::vector<TextureJob>> jobs = plan_textures(arguments, *request, *inputs);
    if (!jobs) return Unexpected(jobs.error());
    const ReportKind kind = report_kind(arguments);
    if ((kind != ReportKind::words || request->stats) && arguments.value("--output") == "-")
        return both_to_standard_output();
    const auto stays = [&](const TextureJob& job) { return request->update && is_up_to_date(job); };
    if (arguments.has("--dry-run")) {
        for (const TextureJob& job : *jobs)
            if (!stays(job))
                for (const std::string& picture : job.pictures)
                    console.print(fmt::format("{} -> {}\n", job.files.input, picture));
        return 0;
    }
    std::vector<std::string> names;
    for (const TextureJob& job : *jobs)
        names.push_back(job.files.input);
    const unsigned threads = request->bake.threads;
    // Threads work on different profiles, or together on the only one.
    if (names.size() > 1) request->bake.threads = 1;
    std::vector<ManifestAsset> assets(names.size());
    int status = run_batch({names, "gonio.bake/1", "baked", threads}, kind, console, [&](std::size_t index) {
        const TextureJob& job = (*jobs)[index];
        Result<MadeTexture> made = stays(job) ? found_texture(job, *request, kind) : make_texture(job, *request, kind);
        Outcome outcome;
        if (made) {
            outcome = std::move(made->outcome);
            assets[index] = std::move(made->asset);
        } else {
            outcome.error = std::move(made.error());
        }
        return outcome;
    });
    if (request->manifest)
        if (const Result<void> written = write_manifest(*request, *jobs, std::move(assets)); !written)
            status = worse(status, console.fail(written.error()));
    return status;
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
                           "FILE is an IES, EULUMDAT or TM-33 profile, a folder of them, '-' for standard input,\n"
                           "or @LIST for a list of files. EXR files carry the sidecar's fields as attributes\n"
                           "gonio:…; PNG and TIFF have no place for them. Out of date (-u) is what other bytes or\n"
                           "options made than its sidecar says; without a sidecar, what is older than its input.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
