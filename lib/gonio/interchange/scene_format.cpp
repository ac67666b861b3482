#include <gonio/base/archive.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/interchange/scene_format.hpp>
#include <gonio/profile/gldf.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>

#include <array>
#include <map>
#include <memory>
#include <utility>

namespace gonio {

namespace {

using namespace interchange_detail;

constexpr std::array formats{
    SceneFormat{"engine-json", "lights that a script lists inside Unreal or Unity: gonio lights --script", ".json",
                is_engine_export, read_engine_export},
    SceneFormat{"gdtf", "GDTF: the beams of a stage fixture, with their zoom, estimated from their angles", ".gdtf",
                is_gdtf, read_gdtf},
    SceneFormat{"gldf", "GLDF: the emitters of a luminaire, with their photometries", ".gldf", is_gldf,
                read_gldf_lights},
    SceneFormat{"gltf", "glTF 2.0: KHR_lights_punctual, EXT_lights_ies, EXT_lights_area, meshes that glow",
                ".gltf, .glb", is_gltf, read_gltf},
    SceneFormat{"luxcore", "LuxCore's properties", ".scn", is_luxcore, read_luxcore},
    SceneFormat{"mitsuba", "Mitsuba 3, with the files that it includes", ".xml", is_mitsuba, read_mitsuba},
    SceneFormat{"pbrt", "pbrt-v4, with the files that it includes", ".pbrt", is_pbrt, read_pbrt},
    SceneFormat{"usd",
                "USD as text, with the layers, references and variants that it names: UsdLux with exposure, normalize, "
                "shaping, profiles, colour temperature",
                ".usda, .usdz", is_usd, read_usd},
};

std::string names_of_formats() {
    std::string names;
    for (const SceneFormat& format : formats)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", format.name);
    return names;
}

// Binary formats that have a text form which gonio reads.
struct BinaryForm {
    std::string_view magic;
    std::string_view what;
    std::string_view hint;
};
constexpr std::array binary_forms{
    BinaryForm{"PXR-USDC", "this is binary USD (USDC)", "convert it first: usdcat scene.usdc -o scene.usda"},
    BinaryForm{"BLENDER", "this is a Blender file", "export it from Blender as glTF or USD"},
};

// Without characters that a terminal might take as a command.
std::string plain(const std::string& text) {
    if (!has_control_characters(text)) return text;
    std::string cleaned;
    for (const char c : text)
        cleaned += static_cast<unsigned char>(c) < 0x20 || c == 0x7f || static_cast<unsigned char>(c) >= 0x80 ? '?' : c;
    return cleaned;
}

// A profile's web, or why there is none.
struct LoadedProfile {
    std::shared_ptr<const Web> web;
    double peak_cd = 0.0;
    std::string reason;
};

LoadedProfile load(const Result<std::string>& bytes, const std::string& name) {
    LoadedProfile loaded;
    const auto refuse = [&](const Error& error) {
        loaded.reason = error.diagnostics.empty() ? "cannot be read" : error.diagnostics.back().message;
        return loaded;
    };
    if (!bytes) return refuse(bytes.error());
    Result<Profile> profile = read_profile(*bytes, name);
    if (!profile) return refuse(profile.error());
    Result<ResolvedWeb> resolved = resolve_web(std::move(*profile));
    if (!resolved) return refuse(resolved.error());
    loaded.peak_cd = peak(resolved->web).intensity.value;
    loaded.web = std::make_shared<const Web>(std::move(resolved->web));
    return loaded;
}

} // namespace

std::span<const SceneFormat> scene_formats() {
    return formats;
}

Result<const SceneFormat*> find_scene_format(std::string_view name) {
    std::vector<std::string_view> names;
    for (const SceneFormat& format : formats) {
        if (format.name == name) return &format;
        names.push_back(format.name);
    }
    return unknown_name("scene format", name, names);
}

Result<const SceneFormat*> scene_format_of(std::string_view bytes, const std::string& source) {
    for (const BinaryForm& form : binary_forms)
        if (bytes.starts_with(form.magic))
            return scene_error("SCN0101", {source, 0, 0}, fmt::format("{}, which gonio does not read", form.what),
                               std::string(form.hint));
    for (const SceneFormat& format : formats)
        if (format.is_content(bytes)) return &format;
    if (is_archive(bytes)) {
        Result<Archive> archive = Archive::open(bytes, source);
        if (!archive) return pass_on(archive);
        return scene_error("SCN0101", {source, 0, 0},
                           "gonio reads no archive of this kind: it has neither product.xml (GLDF) nor "
                           "description.xml (GDTF), and does not begin with a layer of USD (USDZ)");
    }
    return scene_error("SCN0101", {source, 0, 0}, "this is not a scene of a format that gonio reads",
                       fmt::format("gonio reads {}; --from names one", names_of_formats()));
}

Result<FoundScene> read_scene_lights(std::string_view bytes, const std::string& source, const SceneReadOptions& options,
                                     const SceneFormat* format) {
    if (format == nullptr) {
        Result<const SceneFormat*> found = scene_format_of(bytes, source);
        if (!found) return pass_on(found);
        format = *found;
    }
    Result<FoundScene> scene = format->read(bytes, source, options);
    if (!scene) return scene;
    scene->source = source;
    scene->format = format->name;
    for (std::size_t i = 0; i < scene->lights.size(); ++i) {
        FoundLight& light = scene->lights[i];
        if (light.name.empty()) light.name = fmt::format("light {}", i + 1);
        light.name = plain(light.name);
        light.kind = plain(light.kind);
        if (light.shape && light.intensity && !(light.intensity->number >= 0.0))
            only_list(light, "its amount is below 0");
        if (light.shape && light.intensity && !(light.intensity->number <= 1e300))
            only_list(light, "its amount is infinite");
    }
    scene->generator = plain(scene->generator);
    return scene;
}

void load_scene_profiles(FoundScene& scene, const SceneReadOptions& options) {
    std::map<std::string, LoadedProfile> files;
    std::map<std::size_t, LoadedProfile> inside;
    for (FoundLight& light : scene.lights) {
        auto* const shape = light.shape ? std::get_if<ProfileShape>(&*light.shape) : nullptr;
        if (shape == nullptr) continue;
        const LoadedProfile* loaded = nullptr;
        if (light.profile) {
            const auto [at, is_new] = inside.try_emplace(*light.profile);
            if (is_new) at->second = load(scene.profiles[*light.profile].bytes, scene.profiles[*light.profile].name);
            loaded = &at->second;
        } else {
            const auto [at, is_new] = files.try_emplace(shape->file);
            if (is_new)
                at->second = load(options.read_beside ? options.read_beside(shape->file)
                                                      : fail(Failure::io, "files beside the scene are not read"),
                                  shape->file);
            loaded = &at->second;
        }
        if (!loaded->reason.empty()) {
            const std::string name = light.profile ? std::string("inside the file") : "'" + shape->file + "'";
            light.shape.reset();
            remark(light, "SCN0107", fmt::format("the profile {} is not usable: {}", name, loaded->reason));
            continue;
        }
        shape->web = loaded->web;
        if (light.profile_scale != 1.0) light.intensity = amount(light.profile_scale * loaded->peak_cd, "cd");
    }
}

Diagnostics scene_diagnostics(const FoundScene& scene) {
    struct Group {
        std::size_t lights = 0;
        const FoundLight* first = nullptr;
        const LightRemark* said = nullptr;
    };
    std::vector<Group> groups;
    std::map<std::pair<std::string_view, std::string_view>, std::size_t> found;
    for (const FoundLight& light : scene.lights)
        for (const LightRemark& said : light.remarks) {
            const auto [at, is_new] = found.try_emplace({said.code->code, said.message}, groups.size());
            if (is_new) groups.push_back({0, &light, &said});
            ++groups[at->second].lights;
        }
    Diagnostics diagnostics = scene.diagnostics;
    for (const Group& group : groups) {
        std::string who = fmt::format("light '{}'", group.first->name);
        if (group.lights > 1) who += fmt::format(" and {} more", group.lights - 1);
        Diagnostic said;
        said.code = group.said->code->code;
        said.severity = group.said->code->severity;
        said.location = group.first->location;
        said.message = fmt::format("{}: {}", who, group.said->message);
        said.hint = group.said->hint;
        diagnostics.push_back(std::move(said));
    }
    return diagnostics;
}

} // namespace gonio
