#include "asset_job.hpp"

#include <gonio/asset/asset_record.hpp>
#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/light_scene.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/file_scope.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/media/asset_bytes.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/web/integrate.hpp>

#include "../json_text.hpp"
#include "../options/output.hpp"
#include "../options/sky_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

// An input by its bytes, which are enough to decide whether its files are up to date.
struct Source {
    std::string name;
    std::string folder; // below those of the targets
    ManifestFile input; // with the hash of all files that the input names
    std::string bytes;
    std::optional<Rig> rig; // empty: a profile, or the light that the request describes
};

// What is to be written from it.
// NOLINTNEXTLINE(bugprone-exception-escape): moving Json and variants is noexcept, and throws nothing
struct Content {
    std::string description; // for people
    Json report;             // its part of the report
    Diagnostics diagnostics;
    std::optional<MeasuredLight> luminaire;
    std::vector<Light> lights; // of a rig
    std::optional<SkyPicture> sky;
};

bool is_rig(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{';
}

// The flux of a profile with a requested amount of light.
Result<Lumens> flux_at(const PhotometricValue& amount, const Web& web, const std::string& file) {
    LightDescription description;
    description.name = file;
    description.shape = ProfileShape{file, std::make_shared<const Web>(web)};
    description.intensity = amount;
    Diagnostics ignored; // those of the profile were said when it was read
    Result<Light> light = resolve_light(std::move(description), ignored);
    if (!light) return pass_on(light);
    return Lumens(light->web_scale * flux(web).value);
}

Result<Content> content_of_profile(const Source& source, const ImportRequest& request) {
    Content content;
    Result<LoadedProfile> loaded = load_bytes(source.bytes, source.input.file, request.input);
    if (!loaded) return pass_on(loaded);
    content.diagnostics = std::move(loaded->diagnostics);
    const ProfileHeader header = header_of(loaded->profile, request.input.resolve);
    std::vector<Spectrum> spectra;
    if (request.light.color.empty()) {
        Result<std::vector<Spectrum>> held = spectra_of(loaded->profile);
        if (!held) return pass_on(held);
        spectra = std::move(*held);
    }
    MeasuredLightOptions options = request.light;
    if (request.intensity) {
        Result<Lumens> flux = flux_at(*request.intensity, loaded->web, source.input.file);
        if (!flux) return pass_on(flux);
        options.flux = *flux;
    }
    Result<MeasuredLight> light =
        measured_light({source.input.file, loaded->bytes, loaded->web, header, spectra}, options, content.diagnostics);
    if (!light) return pass_on(light);
    light->name = source.name;
    content.description =
        fmt::format("{:.6g} lm, greatest difference {:.2g} cd", light->flux.value, light->max_error.value);
    content.report = {{"name", light->name},
                      {"flux_lm", light->flux.value},
                      {"peak_cd", light->peak.value},
                      {"color", light->color_text},
                      {"rgb", {light->color.x, light->color.y, light->color.z}},
                      {"max_error_cd", light->max_error.value}};
    content.luminaire = std::move(*light);
    return content;
}

// Hashes a rig's bytes, its resolved colours and the bytes of all files that it names.
Result<std::string> fingerprint(const std::string& bytes, const Rig& rig) {
    std::string all = sha256(bytes);
    const Result<std::vector<LightDescription>> emitted = emissive_lights(rig);
    if (!emitted) return Unexpected(emitted.error());
    for (const auto* const lights : {&rig.lights, &*emitted})
        for (const LightDescription& light : *lights)
            all += fmt::format(" {} {} {}", light.color.x, light.color.y, light.color.z);
    for (const std::string& file : rig.files) {
        Result<ManifestFile> hash = hashed(file);
        if (!hash) { // the image of its sky: other files were read with the rig
            Diagnostic& reason = hash.error().diagnostics.back();
            reason.message = fmt::format("{}: {}", reason.location.file, reason.message);
            reason.location.file = rig.source;
            return pass_on(hash);
        }
        all += " " + hash->sha256;
    }
    return sha256(all);
}

// The sky of a rig, if it is not dark; its sun is added to `lights`.
Result<std::optional<SkyPicture>> picture_of_sky(const Rig& rig, const SkyRequest& request,
                                                 std::vector<LightDescription>& lights, Diagnostics& diagnostics) {
    Result<SkyInput> input = sky_of_rig(rig, request, diagnostics);
    if (!input) return pass_on(input);
    if (input->sun) lights.push_back(std::move(*input->sun));
    if (input->sky.is_dark()) return std::optional<SkyPicture>();
    Result<SkyPicture> made = sky_picture(input->sky, request.threads);
    if (!made) return pass_on(made);
    made->source = std::move(input->source.text);
    made->source_sha256 = std::move(input->source.sha256);
    return std::optional(std::move(*made));
}

Result<Content> content_of_rig(Rig rig, const std::string& name, const SkyRequest& request) {
    Content content;
    content.diagnostics = rig.diagnostics;
    Result<std::vector<LightDescription>> emitted = emissive_lights(rig);
    if (!emitted) return pass_on(emitted);
    Result<std::optional<SkyPicture>> sky = picture_of_sky(rig, request, *emitted, content.diagnostics);
    if (!sky) return pass_on(sky);
    content.sky = std::move(*sky);
    Result<std::vector<Light>> lights = resolve_lights(std::move(rig), content.diagnostics, 1);
    if (!lights) return pass_on(lights);
    content.lights = std::move(*lights);
    if (Result<void> added = add_resolved(std::move(*emitted), content.lights, content.diagnostics); !added)
        return pass_on(added);
    content.description = fmt::format("{} lights{}", content.lights.size(), content.sky ? " and a sky" : "");
    if (content.lights.empty()) content.description = "a sky";
    content.report = {{"name", name}, {"lights", content.lights.size()}};
    if (content.sky) content.report["sky"] = {{"horizontal_lx", content.sky->horizontal.value}};
    return content;
}

Result<Content> content_of_described(const ImportRequest& request, const std::string& name) {
    Content content;
    content.diagnostics = request.remarks;
    Result<Light> light = resolve_light(*request.described, content.diagnostics);
    if (!light) return pass_on(light);
    content.lights = {std::move(*light)};
    content.description = "1 light";
    content.report = {{"name", name}, {"lights", 1}};
    return content;
}

Result<Content> content_of(const Source& source, const ImportRequest& request) {
    if (request.described) return content_of_described(request, source.name);
    return source.rig ? content_of_rig(*source.rig, source.name, request.sky) : content_of_profile(source, request);
}

Result<Rig> rig_of(const std::string& file, const std::string& bytes, const ImportRequest& request) {
    const bool changed =
        request.light.flux || request.intensity || !request.light.color.empty() || request.light.rotation.value != 0.0;
    if (changed)
        return fail("USE0107", "the lights of a rig have their own amount, colour and rotation",
                    "leave --flux, --intensity, --color and --rotate out", file);
    Result<Rig> rig = read_rig(bytes, file, folder_of_file(file), request.rig);
    if (!rig) return rig;
    if (!rig->sky)
        if (Result<void> some = require_lights(*rig); !some) return pass_on(some);
    Result<std::vector<LightDescription>> emitted = emissive_lights(*rig);
    if (!emitted) return pass_on(emitted);
    if (Result<void> fits = check_light_count(rig->lights.size() + emitted->size()); !fits) {
        fits.error().diagnostics.back().location.file = file;
        return pass_on(fits);
    }
    return rig;
}

// By its words and the bytes of the files that they name.
Result<Source> described_source(const ImportJob& job, const ImportRequest& request) {
    std::string all = request.description;
    std::vector<std::string> files = files_of(request.described->shape);
    const std::vector<std::string> of_color = files_of_color(request.light.color);
    files.insert(files.end(), of_color.begin(), of_color.end());
    for (const std::string& file : files) {
        Result<ManifestFile> hash = hashed(file);
        if (!hash) return pass_on(hash);
        all += " " + hash->sha256;
    }
    return Source{job.name, job.folder, {job.file, sha256(all)}, {}, {}};
}

Result<Source> read_source(const ImportJob& job, const ImportRequest& request) {
    if (request.described) return described_source(job, request);
    const std::string& file = job.file;
    Result<std::string> bytes =
        file == "-" ? read_standard_input(limit("archive-bytes")) : read_file(file, limit("rig-bytes"));
    if (!bytes) return pass_on(bytes);
    Source source{job.name, job.folder, {file, {}}, std::move(*bytes), {}};
    if (file == "-" || !is_rig(source.bytes)) {
        source.input.sha256 = sha256(source.bytes);
        return source;
    }
    Result<Rig> rig = rig_of(file, source.bytes, request);
    if (!rig) return pass_on(rig);
    Result<std::string> hash = fingerprint(source.bytes, *rig);
    if (!hash) return pass_on(hash);
    source.input.sha256 = std::move(*hash);
    source.rig = std::move(*rig);
    return source;
}

Result<LightScene> scene_of(const Source& source, const Content& content, const Target& target,
                            const ImportRequest& request) {
    if (content.luminaire) return light_scene(target, *content.luminaire, request.unit, request.photometric);
    LightSceneOptions options;
    options.name = source.name;
    options.description = fmt::format("{} of {}", content.description, source.input.file);
    options.unit = request.unit;
    options.photometric = request.photometric;
    if (content.sky) options.sky = &*content.sky;
    return light_scene(target, content.lights, options);
}

// What a target's format cannot store, for the people who get the files.
std::string losses_readme(const Source& source, const Target& target, const std::vector<std::string>& instead) {
    std::string text =
        fmt::format("{} for {}: what it does instead of what it cannot hold.\n\n", source.name, target.name);
    for (const std::string& line : instead)
        text += fmt::format("- {}\n", line);
    return text;
}

struct Written {
    const Target* target = nullptr;
    bool unchanged = false;
    AssetRecord record;
    std::vector<ManifestFile> files; // with their folders
};

// The existing files, if they were made from the same source by the same recipe.
std::optional<Written> found(const Source& source, const Target& target, const ImportRequest& request) {
    const std::string folder = folder_of(request, target) + "/" + source.folder;
    const std::string record_file = folder + asset_record_name(source.name);
    if (!request.update || source.input.file == "-" || !file_exists(record_file)) return std::nullopt;
    const Result<std::string> text = read_file(record_file, limit("record-bytes"));
    std::optional<AssetRecord> record = text ? read_asset_record(*text) : std::nullopt;
    if (!record || record->recipe != recipe_of(request) || record->source_sha256 != source.input.sha256)
        return std::nullopt;
    Written there{&target, true, std::move(*record), {}};
    for (const FileRecord& recorded : there.record.files) {
        const Result<std::string> bytes = read_file(folder + recorded.file, limit("output-bytes"));
        if (!bytes || !matches(recorded, *bytes)) return std::nullopt;
        there.files.push_back({folder + recorded.file, recorded.sha256});
    }
    Result<ManifestFile> own = hashed(record_file);
    if (!own) return std::nullopt;
    there.files.push_back(std::move(*own));
    return there;
}

Result<Written> made(const Source& source, const Content& content, const Target& target, const ImportRequest& request,
                     std::vector<OutputFile>& outputs) {
    Result<LightScene> scene = scene_of(source, content, target, request);
    if (!scene) return pass_on(scene);
    if (!scene->instead.empty())
        scene->files.push_back({source.name + ".README.md", losses_readme(source, target, scene->instead), {}});
    Written written{&target,
                    false,
                    {std::string(target.name),
                     recipe_of(request),
                     source.input.file,
                     source.input.sha256,
                     {},
                     std::move(scene->instead)},
                    {}};
    const auto add = [&](const std::string& name, std::string bytes) -> Result<FileRecord> {
        const std::string path = folder_of(request, target) + "/" + source.folder + name;
        if (!request.overwrite && !request.update && file_exists(path))
            return fail("USE0108", fmt::format("'{}' exists", path),
                        "add --overwrite, or -u to write only outdated files");
        FileRecord record = file_record(name, bytes);
        written.files.push_back({path, record.sha256});
        outputs.push_back({path, std::move(bytes)});
        return record;
    };
    for (const AssetFile& file : scene->files) {
        Result<std::vector<media::NamedBytes>> contents = media::bytes_of(file, request.sky.threads);
        if (!contents) return pass_on(contents);
        for (media::NamedBytes& content_of_file : *contents) {
            Result<FileRecord> record = add(content_of_file.name, std::move(content_of_file.bytes));
            if (!record) return pass_on(record);
            written.record.files.push_back(std::move(*record));
        }
    }
    Result<FileRecord> own = add(asset_record_name(source.name), asset_record_json(written.record));
    if (!own) return pass_on(own);
    return written;
}

// The up-to-date files of each target; empty where they have to be made.
std::vector<std::optional<Written>> found_of_all(const Source& source, const ImportRequest& request) {
    std::vector<std::optional<Written>> all;
    for (const Target* target : request.targets)
        all.push_back(found(source, *target, request));
    return all;
}

// Checks that no output is an input, a file that the rig names, or the manifest.
Result<void> check_free(const std::vector<OutputFile>& outputs, const Source& source, const ImportRequest& request,
                        const FilesInUse& inputs) {
    FilesInUse taken(source.rig ? source.rig->files : std::vector<std::string>());
    if (request.catalogue.manifest)
        if (Result<void> free = taken.take(*request.catalogue.manifest); !free) return free;
    for (const OutputFile& output : outputs) {
        Result<void> free = inputs.check(output.name);
        if (free) free = taken.take(output.name);
        if (!free) return free;
    }
    return {};
}

// Adds what is missing. Makes all bytes of all targets before it writes a file: a failure leaves nothing behind.
Result<std::vector<Written>> write_targets(const Source& source, const Content& content, const ImportRequest& request,
                                           const FilesInUse& inputs, std::vector<std::optional<Written>> there) {
    std::vector<Written> all;
    std::vector<OutputFile> outputs;
    for (std::size_t i = 0; i < there.size(); ++i) {
        if (there[i]) {
            all.push_back(std::move(*there[i]));
            continue;
        }
        Result<Written> written = made(source, content, *request.targets[i], request, outputs);
        if (!written) return pass_on(written);
        all.push_back(std::move(*written));
    }
    if (Result<void> free = check_free(outputs, source, request, inputs); !free) return pass_on(free);
    if (const Result<void> done = write_outputs(outputs); !done) return Unexpected(done.error());
    return all;
}

Json report_of(const ManifestFile& input, const Content& content, const std::vector<Written>& all,
               const Diagnostics& diagnostics) {
    Json json{{"schema", "gonio.import/1"}, {"file", input.file}, {"sha256", input.sha256}};
    json.update(content.report);
    json["targets"] = Json::array();
    for (const Written& asset : all) {
        Json files = Json::array();
        for (const ManifestFile& file : asset.files)
            files.push_back(file.file);
        json["targets"].push_back({{"target", asset.target->name},
                                   {"up_to_date", asset.unchanged},
                                   {"files", std::move(files)},
                                   {"instead", asset.record.instead}});
    }
    json["diagnostics"] = diagnostics_json(diagnostics);
    return json;
}

} // namespace

Result<Made> import_one(const ImportJob& job, const ImportRequest& request, const FilesInUse& inputs, ReportKind kind) {
    const std::string& file = job.file;
    Result<Source> source = read_source(job, request);
    if (!source) return pass_on(source);
    std::vector<std::optional<Written>> there = found_of_all(*source, request);
    const bool complete = std::all_of(there.begin(), there.end(), [](const auto& written) { return !!written; });
    // If everything is up to date, only a report needs the light.
    Content content;
    if (!complete || kind != ReportKind::words) {
        Result<Content> read = content_of(*source, request);
        if (!read) return pass_on(read);
        content = std::move(*read);
    }
    Result<std::vector<Written>> all = write_targets(*source, content, request, inputs, std::move(there));
    if (!all) return pass_on(all);
    Made imported;
    Outcome& outcome = imported.outcome;
    outcome.diagnostics = std::move(content.diagnostics);
    imported.asset.input = source->input;
    outcome.unchanged = true;
    for (Written& asset : *all) {
        outcome.unchanged &= asset.unchanged;
        outcome.remarks.push_back(asset.unchanged
                                      ? fmt::format("{} -> {}: up to date", file, folder_of(request, *asset.target))
                                      : fmt::format("{} -> {}: {} files, {}", file, folder_of(request, *asset.target),
                                                    asset.files.size(), content.description));
        for (const std::string& line : asset.record.instead) {
            outcome.diagnostics.push_back(result_diagnostic("RES0201", line, {}, file));
            imported.asset.remarks.push_back(fmt::format("{}: {}", asset.target->name, line));
        }
    }
    if (kind != ReportKind::words) outcome.report = report_of(source->input, content, *all, outcome.diagnostics);
    for (Written& asset : *all)
        for (ManifestFile& written : asset.files)
            imported.asset.files.push_back(std::move(written));
    return imported;
}

} // namespace gonio::cli
