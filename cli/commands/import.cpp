#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../catalogue.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../import/asset_job.hpp"
#include "../import/request.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace gonio::cli {

namespace {

constexpr std::array groups{OptionGroup{"import", import_options},
                            profile_input_group,
                            catalogue_group,
                            json_group,
                            threads_group,
                            light_common_group};
constexpr std::array examples{
    Example{"gonio import lamp.ies --to gltf -O assets", "assets/gltf: lamp.gltf, lamp.ies, lamp.glb and a README"},
    Example{"gonio import lamp.ldt --to gltf,usd,blender -O assets --flux 800lm --color 2700K",
            "the same 800 lm of warm white everywhere"},
    Example{"gonio import studio.rig.json --to blender,unreal -O assets", "all lights of a rig, area lights included"},
    Example{"gonio import library -u --to pbrt -O assets --manifest assets.json",
            "a catalogue; assets that are up to date are skipped"},
};

// Two inputs with the same name would write the same files.
Result<void> distinct(const std::vector<std::string>& inputs) {
    std::map<std::string, std::string> taken;
    for (const std::string& input : inputs) {
        const auto [other, is_new] = taken.emplace(asset_name(input), input);
        if (!is_new)
            return fail("USE0108",
                        fmt::format("the assets of '{}' and '{}' would both be called '{}'", other->second, input,
                                    other->first),
                        "rename one, or import them into different folders");
    }
    return {};
}

std::vector<std::string> shared_out(const std::vector<std::string>& inputs, Share share) {
    std::vector<std::string> chosen;
    for (std::size_t i = share.first; i < inputs.size(); i += share.step)
        chosen.push_back(inputs[i]);
    return chosen;
}

// A README written by someone else is left as it is.
Result<void> write_readme(const std::string& file, const Target& target, const Console& console) {
    const std::string text = target_readme(target);
    const Result<std::string> there = file_exists(file) ? read_file(file) : Result<std::string>(std::string());
    if (!there) return Unexpected(there.error());
    if (*there == text) return {};
    const std::string_view title = std::string_view(text).substr(0, text.find('\n') + 1);
    if (there->empty() || there->starts_with(title)) return write_output(file, text);
    console.note(fmt::format("{}: not written by gonio, left unchanged", file));
    return {};
}

Result<void> make_folders(const ImportRequest& request, const Console& console) {
    for (const Target* target : request.targets) {
        const std::string folder = folder_of(request, *target);
        Result<void> done = make_folder(folder);
        if (done) done = write_readme(folder + "/README.md", *target, console);
        if (!done) return done;
    }
    return {};
}

Result<int> import_all(const Arguments& arguments, Console& console) {
    if (arguments.has("--merge")) return merge_manifests(arguments, console);
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<ImportRequest> request = parse_import(arguments);
    if (!request) return pass_on(request);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    if (Result<void> names = distinct(*inputs); !names) return pass_on(names);
    std::vector<std::string> asset_names(inputs->size());
    std::transform(inputs->begin(), inputs->end(), asset_names.begin(), asset_name);
    console.say(names_that_differ_by_case(asset_names));
    const FilesInUse in_use(*inputs);
    if (request->catalogue.manifest)
        if (Result<void> free = in_use.check(*request->catalogue.manifest); !free) return pass_on(free);
    const std::vector<std::string> chosen = shared_out(*inputs, share_of(request->catalogue));
    if (arguments.has("--dry-run")) {
        for (const std::string& input : chosen)
            for (const Target* target : request->targets)
                console.print(fmt::format("{} -> {}/{}\n", input, folder_of(*request, *target), asset_name(input)));
        return 0;
    }
    if (Result<void> folders = make_folders(*request, console); !folders) return pass_on(folders);
    const ReportKind kind = report_kind(arguments);
    std::string recipe = recipe_of(*request) + " to=";
    for (const Target* target : request->targets)
        recipe += fmt::format("{}{}", target == request->targets.front() ? "" : ",", target->name);
    return run_catalogue({chosen, "gonio.import/1", "imported", *threads}, request->catalogue, recipe, kind, console,
                         [&](std::size_t index) { return import_one(chosen[index], *request, in_use, kind); });
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = import_all(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command import_command;
const Command import_command{
    "import",
    "write a profile or the lights of a rig for engines and renderers",
    "FILE… --to TARGET,… -O DIR",
    "FILE is an IES, EULUMDAT or TM-33 profile, a rig (gonio.rig/1), a folder of profiles,\n"
    "'-' for a profile from stdin, or @LIST for a list of files. Anything a target cannot store\n"
    "is reported, with what is written instead.",
    groups,
    examples,
    run,
    true};

} // namespace gonio::cli
