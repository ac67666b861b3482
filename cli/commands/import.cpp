#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/manifest.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/atomic_file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/image_file.hpp>

#include "../arguments.hpp"
#include "../bake/texture_picture.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace gonio::cli {

namespace {

constexpr std::array import_options{
    Option{"--to", "TARGET,…", "which programs the light is for", "targets"},
    Option{"-O,--output-dir", "DIR", "folder that exists; each target gets one of its own in it"},
    Option{"--flux", "LUMENS", "scale the light to this, for example 800lm (as measured)"},
    Option{"--color", "COLOR",
           "2700K, 2700K/0.002, d65, #ffd9a0, rgb(r,g,b) or an illuminant (the profile's colour temperature)"},
    Option{"--rotate", "ANGLE", "turn the light about its axis, C0 towards C90 (0deg)"},
    Option{"--manifest", "FILE", "write a list of what was made, with the hash of every file"},
    Option{"--overwrite", "", "replace what exists"},
    Option{"-n,--dry-run", "", "say what would be written, write nothing"},
};
constexpr std::array groups{OptionGroup{"import", import_options}, profile_input_group, json_group, threads_group,
                            light_common_group};
constexpr std::array examples{
    Example{"gonio import lamp.ies --to gltf -O assets", "assets/gltf: lamp.gltf, lamp.ies, lamp.glb and a README"},
    Example{"gonio import lamp.ldt --to gltf,usd,blender -O assets --flux 800lm --color 2700K",
            "the same 800 lm of warm white everywhere"},
    Example{"gonio import profiles/*.ies --to pbrt -O assets", "a catalogue"},
};

struct Request {
    std::vector<const Target*> targets;
    std::string folder;
    MeasuredLightOptions light;
    ProfileInputOptions input;
    bool overwrite = false;
};

Result<std::vector<const Target*>> parse_targets(const Arguments& arguments) {
    const auto text = arguments.value("--to");
    if (!text) return fail(Failure::usage, "no target is given", "for example --to gltf; 'gonio list targets' has all");
    std::vector<const Target*> chosen;
    std::string_view rest = *text;
    while (true) {
        const std::size_t comma = rest.find(',');
        Result<const Target*> target = find_target(rest.substr(0, comma));
        if (!target) return pass_on(target);
        if (std::find(chosen.begin(), chosen.end(), *target) == chosen.end()) chosen.push_back(*target);
        if (comma == std::string_view::npos) return chosen;
        rest.remove_prefix(comma + 1);
    }
}

Result<Request> parse(const Arguments& arguments) {
    Request request;
    Result<std::vector<const Target*>> chosen = parse_targets(arguments);
    if (!chosen) return pass_on(chosen);
    request.targets = std::move(*chosen);
    const auto folder = arguments.value("--output-dir");
    if (!folder) return fail(Failure::usage, "no output folder is given", "add -O DIR");
    if (!is_folder(*folder))
        return fail(Failure::io, file_exists(*folder) ? "this is a file, not a folder" : "there is no such folder",
                    file_exists(*folder) ? "" : "make it first: mkdir " + *folder, *folder);
    request.folder = *folder;
    if (const auto text = arguments.value("--flux")) {
        Result<double> flux = parse_amount(*text, Dimension::luminous_flux, "--flux");
        if (!flux) return pass_on(flux);
        if (!(*flux > 0.0)) return fail(Failure::usage, fmt::format("--flux takes more than 0 lm, not '{}'", *text));
        request.light.flux = Lumens(*flux);
    }
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        request.light.rotation = Radians(*angle);
    }
    const auto color = arguments.value("--color");
    if (color && !is_about_messages(*color)) {
        const Result<glm::dvec3> rgb = parse_light_color(*color); // before anything is written
        if (!rgb) return Unexpected(rgb.error());
        request.light.color = *color;
    }
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    request.input = *input;
    request.overwrite = arguments.has("--overwrite");
    return request;
}

std::string folder_of(const Request& request, const Target& target) {
    return fmt::format("{}/{}", request.folder, target.name);
}

// The bytes of an asset's file.
Result<std::string> bytes_of(const AssetFile& file, const Web& web) {
    if (!file.texture) return file.bytes;
    Result<Texture> texture = bake_texture(web, file.texture->bake);
    if (!texture) return pass_on(texture);
    const int channels = file.texture->channels;
    const Image image = texture_picture(*texture, 0, texture->image.width, channels);
    media::ImageWriteOptions options;
    options.pixel = pixel_of(file.texture->bake.texel_type);
    if (channels == 1) options.channel_names = {"Y"};
    return media::encode_image(image, *media::find_image_format(file.name), options);
}

struct Written {
    const Target* target;
    std::vector<ManifestFile> files; // with their folder
};

// All bytes of all targets first, then the files: what cannot be made leaves nothing behind.
Result<std::vector<Written>> write_targets(const MeasuredLight& light, const Request& request) {
    std::vector<Written> written;
    std::vector<OutputFile> contents;
    for (const Target* target : request.targets) {
        Written files{target, {}};
        for (const AssetFile& file : target->files(light)) {
            Result<std::string> bytes = bytes_of(file, light.web);
            if (!bytes) return pass_on(bytes);
            const std::string path = folder_of(request, *target) + "/" + file.name;
            if (!request.overwrite && file_exists(path))
                return fail(Failure::usage, fmt::format("'{}' exists", path), "add --overwrite");
            files.files.push_back({path, sha256(*bytes)});
            contents.push_back({path, std::move(*bytes)});
        }
        written.push_back(std::move(files));
    }
    if (const Result<void> done = write_outputs(contents); !done) return Unexpected(done.error());
    return written;
}

Json to_json(const MeasuredLight& light, const std::vector<Written>& written, const Diagnostics& diagnostics) {
    Json targets = Json::array();
    for (const Written& asset : written) {
        Json files = Json::array();
        for (const ManifestFile& file : asset.files)
            files.push_back(file.file);
        targets.push_back({{"target", asset.target->name}, {"files", std::move(files)}});
    }
    Json json{{"schema", "gonio.import/1"},
              {"file", light.source_file},
              {"sha256", light.source_sha256},
              {"name", light.name},
              {"flux_lm", light.flux.value},
              {"peak_cd", light.peak.value},
              {"color", light.color_text},
              {"rgb", {light.color.x, light.color.y, light.color.z}},
              {"max_error_cd", light.max_error.value},
              {"targets", std::move(targets)}};
    json["diagnostics"] = diagnostics_json(diagnostics);
    return json;
}

// NOLINTNEXTLINE(bugprone-exception-escape): as of Outcome, which it holds
struct Imported {
    Outcome outcome;
    ManifestAsset asset;
};

Result<Imported> import_one(const std::string& file, const Request& request, ReportKind kind) {
    Imported imported;
    Outcome& outcome = imported.outcome;
    Result<LoadedProfile> loaded = load(file, request.input);
    if (!loaded) return pass_on(loaded);
    const ProfileHeader header = header_of(loaded->profile, request.input.resolve);
    outcome.diagnostics = std::move(loaded->diagnostics);
    Result<MeasuredLight> light =
        measured_light({file, loaded->bytes, loaded->web, header}, request.light, outcome.diagnostics);
    if (!light) return pass_on(light);
    Result<std::vector<Written>> written = write_targets(*light, request);
    if (!written) return pass_on(written);
    for (const Written& asset : *written)
        outcome.remarks.push_back(fmt::format("{} -> {}: {} files, {:.6g} lm, greatest difference {:.2g} cd", file,
                                              folder_of(request, *asset.target), asset.files.size(), light->flux.value,
                                              light->max_error.value));
    if (kind != ReportKind::words) outcome.report = to_json(*light, *written, outcome.diagnostics);
    imported.asset.input = {file, light->source_sha256};
    for (Written& asset : *written)
        for (ManifestFile& made : asset.files)
            imported.asset.files.push_back(std::move(made));
    return imported;
}

// All that the files depend on but the inputs' bytes.
std::string recipe_of(const Request& request) {
    std::string text = fmt::format("gonio {} import to=", version);
    for (const Target* target : request.targets)
        text += fmt::format("{}{}", target == request.targets.front() ? "" : ",", target->name);
    if (request.light.flux) text += fmt::format(" flux={}lm", request.light.flux->value);
    if (!request.light.color.empty()) text += " color=" + request.light.color;
    if (request.light.rotation.value != 0.0) text += fmt::format(" rotate={}deg", to_degrees(request.light.rotation));
    return text;
}

// Two inputs of one name would write the same files.
Result<void> distinct(const std::vector<std::string>& inputs) {
    std::map<std::string, std::string> taken;
    for (const std::string& input : inputs) {
        const auto [other, is_new] = taken.emplace(asset_name(input), input);
        if (!is_new)
            return fail(Failure::usage,
                        fmt::format("'{}' and '{}' would both be called '{}'", other->second, input, other->first),
                        "rename one, or import them into different folders");
    }
    return {};
}

Result<void> make_folders(const Request& request) {
    for (const Target* target : request.targets) {
        const std::string folder = folder_of(request, *target);
        Result<void> done = make_folder(folder);
        if (done) done = write_file(folder + "/README.md", target_readme(*target));
        if (!done) return done;
    }
    return {};
}

Result<int> import_all(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> inputs = input_files(arguments);
    if (!inputs) return pass_on(inputs);
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    if (Result<void> names = distinct(*inputs); !names) return pass_on(names);
    if (arguments.has("--dry-run")) {
        for (const std::string& input : *inputs)
            for (const Target* target : request->targets)
                console.print(fmt::format("{} -> {}/{}\n", input, folder_of(*request, *target), asset_name(input)));
        return 0;
    }
    if (Result<void> folders = make_folders(*request); !folders) return pass_on(folders);
    const ReportKind kind = report_kind(arguments);
    std::vector<std::optional<ManifestAsset>> assets(inputs->size());
    const int status =
        run_batch({*inputs, "gonio.import/1", "imported", *threads}, kind, console, [&](std::size_t index) {
            Result<Imported> imported = import_one((*inputs)[index], *request, kind);
            if (imported) {
                assets[index] = std::move(imported->asset);
                return std::move(imported->outcome);
            }
            Outcome failed;
            failed.error = std::move(imported.error());
            return failed;
        });
    const auto manifest_file = arguments.value("--manifest");
    if (!manifest_file) return status;
    Manifest manifest;
    manifest.recipe = recipe_of(*request);
    manifest.inputs = inputs->size();
    for (std::size_t i = 0; i < inputs->size(); ++i) {
        if (assets[i])
            manifest.assets.push_back(std::move(*assets[i]));
        else
            manifest.failed.push_back((*inputs)[i]);
    }
    const Result<void> written = write_output(*manifest_file, manifest_json(manifest));
    if (!written) return Unexpected(written.error());
    return status;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = import_all(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command import_command;
const Command import_command{"import",
                             "one profile as the same light in every engine",
                             "FILE… --to TARGET,… -O DIR",
                             "FILE is an IES, EULUMDAT or TM-33 profile, a folder of them, '-' for standard input,\n"
                             "or @LIST for a list of files.",
                             groups,
                             examples,
                             run,
                             true};

} // namespace gonio::cli
