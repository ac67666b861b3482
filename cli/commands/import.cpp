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
    Example{"gonio import --preset incandescent-60 --color 2700K --to unity,unreal -O assets",
            "a light without a file"},
    Example{"gonio import library -u --to pbrt -O assets --manifest assets.json",
            "a catalogue; assets that are up to date are skipped"},
};

// Two inputs with the same name would write the same files.
Result<void> distinct(const std::vector<ImportJob>& jobs, bool mirror) {
    std::map<std::string, std::string> taken;
    for (const ImportJob& job : jobs) {
        const auto [other, is_new] = taken.emplace(job.folder + job.name, job.file);
        if (!is_new)
            return fail("USE0108",
                        fmt::format("the assets of '{}' and '{}' would both be called '{}'", other->second, job.file,
                                    other->first),
                        mirror ? "rename one, or import them into different folders"
                               : "add --mirror, which keeps folders and, where needed, endings; or rename one");
    }
    return {};
}

// What is to be imported, and the names that it gets.
Result<std::vector<ImportJob>> jobs_of(const Arguments& arguments, const ImportRequest& request) {
    if (request.described) {
        const std::string& name = request.described->name;
        return std::vector{ImportJob{arguments.value("--shape").value_or(name), {}, asset_name(name + ".")}};
    }
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    const bool mirror = arguments.has("--mirror");
    const std::vector<std::string> names = names_in_folder(*inputs, mirror);
    std::vector<ImportJob> jobs;
    for (std::size_t i = 0; i < inputs->size(); ++i) {
        if ((*inputs)[i] == "-" || !mirror) {
            jobs.push_back({(*inputs)[i], {}, asset_name((*inputs)[i])});
            continue;
        }
        const std::size_t slash = names[i].rfind('/') + 1; // 0 if there is none
        // The ending that is left is part of the name.
        jobs.push_back({(*inputs)[i], names[i].substr(0, slash), asset_name(names[i].substr(slash) + ".")});
    }
    if (Result<void> names_differ = distinct(jobs, mirror); !names_differ) return pass_on(names_differ);
    return jobs;
}

std::vector<ImportJob> shared_out(const std::vector<ImportJob>& jobs, Share share) {
    std::vector<ImportJob> chosen;
    for (std::size_t i = share.first; i < jobs.size(); i += share.step)
        chosen.push_back(jobs[i]);
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

Result<void> make_folders(const ImportRequest& request, const std::vector<ImportJob>& jobs, const Console& console) {
    for (const Target* target : request.targets) {
        const std::string folder = folder_of(request, *target);
        Result<void> done = make_folder(folder);
        if (done) done = write_readme(folder + "/README.md", *target, console);
        for (const ImportJob& job : jobs)
            if (done && !job.folder.empty()) done = make_folders_of(folder, job.folder);
        if (!done) return done;
    }
    return {};
}

Result<int> import_all(const Arguments& arguments, Console& console) {
    if (arguments.has("--merge")) return merge_manifests(arguments, console);
    if (arguments.positional().empty() && !is_described(arguments))
        return fail("USE0104", "no input file is given", "name one, '-' for stdin, or describe a light with --shape");
    Result<ImportRequest> request = parse_import(arguments);
    if (!request) return pass_on(request);
    Result<std::vector<ImportJob>> all = jobs_of(arguments, *request);
    if (!all) return pass_on(all);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    std::vector<std::string> asset_names;
    std::vector<std::string> files;
    for (const ImportJob& job : *all) {
        asset_names.push_back(job.folder + job.name);
        if (!request->described) files.push_back(job.file);
    }
    if (request->described) files = files_of(request->described->shape);
    console.say(names_that_differ_by_case(asset_names));
    const FilesInUse in_use(files);
    if (request->catalogue.manifest)
        if (Result<void> free = in_use.check(*request->catalogue.manifest); !free) return pass_on(free);
    const std::vector<ImportJob> chosen = shared_out(*all, share_of(request->catalogue));
    if (arguments.has("--dry-run")) {
        for (const ImportJob& job : chosen)
            for (const Target* target : request->targets)
                console.print(
                    fmt::format("{} -> {}/{}{}\n", job.file, folder_of(*request, *target), job.folder, job.name));
        return 0;
    }
    if (Result<void> folders = make_folders(*request, chosen, console); !folders) return pass_on(folders);
    const ReportKind kind = report_kind(arguments);
    std::string recipe = recipe_of(*request) + " to=";
    for (const Target* target : request->targets)
        recipe += fmt::format("{}{}", target == request->targets.front() ? "" : ",", target->name);
    std::vector<std::string> names;
    for (const ImportJob& job : chosen)
        names.push_back(job.file);
    return run_catalogue({names, "gonio.import/1", "imported", *threads}, request->catalogue, recipe, kind, console,
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
    "write a profile, or the lights and the sky of a rig, for engines and renderers",
    "[FILE…] --to TARGET,… -O DIR",
    "FILE is an IES, EULUMDAT or TM-33 profile, a rig (gonio.rig/1), a folder of profiles,\n"
    "'-' for a profile from stdin, or @LIST for a list of files; or a light is described by\n"
    "--shape and --intensity, or --preset. Anything a target cannot store is reported, with what\n"
    "is written instead.",
    groups,
    examples,
    run,
    true};

} // namespace gonio::cli
