#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/audit.hpp>
#include <gonio/interchange/engine_script.hpp>
#include <gonio/interchange/scene_rig.hpp>

#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../lights/lights_report.hpp"
#include "../lights/request.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array task_options{
    Option{"--to-rig", "", "write a rig that preview, probe and import take, with -o FILE"},
    Option{"--audit", "", "what is implausible; the exit status is 1 if anything is"},
    Option{"--fix", "", "write the scene with what can be corrected corrected, with -o FILE (glTF)"},
    Option{"--script", "PROGRAM", "print the script that lists the lights inside unreal or unity"},
    Option{"-o,--output", "FILE", "the file of --to-rig, --fix or --script; '-' is stdout"},
};
constexpr std::array groups{OptionGroup{"what to do", task_options}, OptionGroup{"scene", scene_options}, json_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio lights scene.gltf", "every light: lumens, candela, nits, kelvin, size, position"},
    Example{"gonio lights scene.usda --to-rig -o rig.json", "the lights as a rig"},
    Example{"gonio import rig.json --to blender -O out/", "and from there to any other program"},
    Example{"gonio lights moving-head.gdtf --zoom 10deg", "the beams of a stage fixture"},
    Example{"gonio lights scene.glb --audit", "watts taken for candela, wrong cones, black lights"},
    Example{"gonio lights --script unreal -o gonio_lights.py", "for the editor: it lists the level's lights as JSON"},
    Example{"gonio lights scene.glb --fix -o fixed.glb", "the same file with corrected numbers"},
};

// The last part of a name that a scene gives, as that of a file here.
std::string plain_file_name(const std::string& written) {
    std::string plain;
    for (const char c : written.substr(written.find_last_of("/\\") + 1)) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                              c == '-' || c == '_';
        plain += is_plain ? c : '_';
    }
    return plain;
}

// Writes the rig, and beside it the profiles that are not in its folder yet.
Result<void> write_rig(const FoundScene& scene, const SceneRequest& request, const std::string& output) {
    std::vector<OutputFile> files(1);
    std::map<std::string, std::string> names; // in the scene and of the files
    std::set<std::string> taken;
    const std::string folder = output == "-" ? std::string() : folder_of_file(output);
    const auto below = [&](const std::string& name) { return folder.empty() ? name : folder + "/" + name; };
    const bool same_folder =
        output != "-" && request.file != "-" &&
        absolute_name(folder.empty() ? "." : folder) ==
            absolute_name(folder_of_file(request.file).empty() ? "." : folder_of_file(request.file));
    const std::string stem = output.substr(folder.empty() ? 0 : folder.size() + 1);
    const std::string prefix = stem.substr(0, stem.rfind('.'));
    std::optional<Error> error;
    const auto name_of = [&](const FoundLight& light) -> std::string {
        const std::string& written = std::get<ProfileShape>(*light.shape).file;
        if (!light.profile && same_folder) return written;
        const std::string key = light.profile ? fmt::format("/{}", *light.profile) : written;
        const auto [at, is_new] = names.try_emplace(key);
        if (!is_new) return at->second;
        std::string base = light.profile
                               ? scene.profiles[*light.profile].name + "." + scene.profiles[*light.profile].ending
                               : plain_file_name(written);
        std::string free = prefix + "." + base;
        for (int number = 2; taken.contains(free); ++number)
            free = fmt::format("{}.{}.{}", prefix, number, base);
        taken.insert(free);
        at->second = free;
        Result<std::string> bytes = light.profile ? Result<std::string>(scene.profiles[*light.profile].bytes)
                                                  : request.options.read_beside(written);
        if (!bytes)
            error = std::move(bytes.error());
        else
            files.push_back({below(free), std::move(*bytes)});
        return free;
    };
    files[0] = {output, scene_rig(scene, name_of)};
    if (error) return Unexpected(std::move(*error));
    if (output == "-" && files.size() > 1)
        return fail("USE0107", "a rig with profiles cannot go to stdout", "write it to a file: -o rig.json");
    for (std::size_t i = 1; i < files.size(); ++i)
        if (file_exists(files[i].name)) {
            const Result<std::string> there = read_file(files[i].name);
            if (!there || *there != files[i].bytes)
                return fail("USE0108", fmt::format("'{}' exists, and is another file", files[i].name),
                            "write the rig into another folder, or by another name");
        }
    return output == "-" ? write_output(output, files[0].bytes) : write_outputs(files);
}

// Needs no scene.
Result<int> write_script(const Arguments& arguments) {
    Result<const EngineScript*> script = find_engine_script(*arguments.value("--script"));
    if (!script) return pass_on(script);
    for (const std::string_view option : {"--to-rig", "--fix", "--audit"})
        if (arguments.has(option)) return fail("USE0107", fmt::format("--script and {} are both given", option));
    if (!arguments.positional().empty())
        return fail("USE0107", "--script takes no scene", "run the script in the program, and read what it writes");
    const std::string output = arguments.value("--output").value_or("-");
    if (output != "-" && file_exists(output))
        return fail("USE0108", fmt::format("'{}' exists", output), "remove it first, or give another name");
    if (Result<void> written = write_output(output, (*script)->text); !written) return pass_on(written);
    return 0;
}

Result<void> check_options(const Arguments& arguments) {
    if (arguments.has("--to-rig") && arguments.has("--fix"))
        return fail("USE0107", "--to-rig and --fix both write a file", "fix the scene first");
    if (arguments.has("--output") && !arguments.has("--to-rig") && !arguments.has("--fix"))
        return fail("USE0104", "-o needs --to-rig or --fix", "--to-rig -o rig.json writes a rig");
    for (const std::string_view option : {"--to-rig", "--fix"})
        if (arguments.has(option) && !arguments.has("--output"))
            return fail("USE0104", fmt::format("{} needs -o FILE", option), "'-' is stdout");
    const auto output = arguments.value("--output");
    if (output && !arguments.positional().empty() && *output != "-" &&
        file_identity(*output) == file_identity(arguments.positional().front()) && !file_identity(*output).empty())
        return fail("USE0108", fmt::format("'{}' would replace the scene itself", *output), "give another name");
    if (output && *output == "-" && report_kind(arguments) != ReportKind::words)
        return both_to_standard_output(arguments.has("--to-rig") ? "rig" : "scene");
    return {};
}

Result<int> run_lights(const Arguments& arguments, Console& console) {
    if (arguments.has("--script")) return write_script(arguments);
    if (Result<void> fits = check_options(arguments); !fits) return pass_on(fits);
    Result<SceneRequest> request = parse_scene(arguments);
    if (!request) return pass_on(request);
    const Stopwatch watch;
    Result<FoundScene> scene = read_scene_lights(request->bytes, request->file, request->options, request->format);
    if (!scene) return pass_on(scene);
    if (!request->options.variant.empty() && scene->format != "gldf" && scene->format != "gdtf")
        return fail("USE0107",
                    fmt::format("--variant is for GLDF and GDTF, and '{}' is {}", request->file, scene->format),
                    "leave it out");
    if (request->options.zoom && scene->format != "gdtf")
        return fail("USE0107", fmt::format("--zoom is for GDTF, and '{}' is {}", request->file, scene->format),
                    "leave it out");
    if (request->options.time && scene->format != "usd")
        return fail("USE0107", fmt::format("--time is for USD, and '{}' is {}", request->file, scene->format),
                    "leave it out");
    load_scene_profiles(*scene, request->options);
    console.remark(fmt::format("read in {:.1f} ms", watch.milliseconds()));
    Diagnostics diagnostics = scene_diagnostics(*scene);
    const bool audits = arguments.has("--audit") || arguments.has("--fix");
    std::optional<std::vector<SceneFinding>> findings;
    if (audits) findings = audit_scene(*scene, request->options.lumens_per_watt);
    const std::string output = arguments.value("--output").value_or("");
    std::vector<AppliedFix> applied;
    if (arguments.has("--to-rig")) {
        if (Result<void> written = write_rig(*scene, *request, output); !written) return pass_on(written);
    }
    if (arguments.has("--fix")) {
        Result<FixedScene> fixed = fix_scene(request->bytes, *scene, *findings);
        if (!fixed) return pass_on(fixed);
        if (Result<void> written = write_output(output, fixed->bytes); !written) return pass_on(written);
        applied = std::move(fixed->applied);
    }
    const ReportKind kind = report_kind(arguments);
    if (kind != ReportKind::words) {
        print_lights_json(*scene, measures_of(*scene), findings, diagnostics, kind == ReportKind::json, console);
    } else if (arguments.has("--fix")) {
        std::string text;
        for (const AppliedFix& fix : applied)
            text += fmt::format("{} '{}': {} {} becomes {}\n", fix.code, fix.light, fix.path, rounded(fix.from),
                                rounded(fix.to));
        text += fmt::format("{} number{} changed\n", applied.size(), applied.size() == 1 ? "" : "s");
        if (output == "-")
            console.note(text.substr(0, text.size() - 1));
        else
            console.print(text);
    } else if (arguments.has("--audit")) {
        console.print(audit_text(*scene, *findings));
    } else if (!arguments.has("--to-rig")) {
        print_lights(*scene, measures_of(*scene), console);
    }
    console.say(diagnostics);
    return arguments.has("--audit") && !findings->empty() ? 1 : 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_lights(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command lights_command;
const Command lights_command{
    "lights",
    "read the lights of other programs' scenes: a table, a rig, an audit",
    "SCENE [options]",
    "SCENE is a file of a format of `gonio list scene-formats`, or - for stdin. What the file does not state is\n"
    "assumed with a warning; what a rig cannot hold is listed and left out.",
    groups,
    examples,
    run};

} // namespace gonio::cli
