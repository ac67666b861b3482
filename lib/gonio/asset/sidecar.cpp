#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>

namespace gonio {

namespace {

using detail::Json;

std::string convention(const Texture& texture, const Engine* engine) {
    if (engine == nullptr) return texture.texel_convention;
    const char* const holds = texture.sampling == Sampling::mean ? "a texel holds the mean over its solid angle"
                              : texture.image.height == 1        ? "a texel holds the mean over C there"
                                                                 : "a texel holds the value there";
    return std::string(engine->rule) + "; " + holds;
}

Json frame(const Engine* engine) {
    if (engine == nullptr) return {{"aim", "-Z"}, {"c0", "+X"}, {"handedness", "right"}};
    return {{"aim", engine->aim}, {"c0", engine->c0}, {"handedness", engine->handedness}};
}

void add_fields(const Json& json, const std::string& before, std::vector<SidecarField>& fields) {
    for (const auto& [key, value] : json.items()) {
        if (value.is_object()) add_fields(value, before + key + ".", fields);
        if (value.is_string()) fields.push_back({before + key, value.as_string()});
        if (value.is_number()) fields.push_back({before + key, value.as_double()});
    }
}

} // namespace

std::string texture_sidecar(const Texture& texture, const TextureSource& source, const TextureFile& file) {
    const bool faces = !file.face_files.empty();
    Json sidecar{
        {"schema", "gonio.texture/1"},
        {"layout", texture.layout},
        {"width", faces ? texture.image.height : texture.image.width},
        {"height", texture.image.height},
        {"channels", file.channels},
        {"pixel", file.pixel},
        {"transfer", to_text(texture.transfer)},
        {"sampling", to_text(texture.sampling)},
        {"texel_convention", convention(texture, file.engine)},
        {"frame", frame(file.engine)},
        {"normalization", to_text(texture.normalization)},
        {"cd_per_unit", texture.cd_per_unit},
        {"peak_cd", texture.peak.value},
        {"flux_lm", texture.flux.value},
        {"texture_flux_lm", texture.texture_flux.value},
        {"solid_angle_sr", texture.solid_angle.value},
        {"max_error_cd", texture.max_error.value},
        {"quantization_error_cd", texture.quantization_error.value},
        {"clamped_cd", texture.least_mean.value},
        {"source", {{"file", source.file}, {"sha256", source.sha256}}},
        {"tool", std::string("gonio ") + version},
    };
    if (file.engine != nullptr) sidecar["engine"] = file.engine->name;
    if (faces) sidecar["face_files"] = file.face_files;
    if (!file.recipe.empty()) sidecar["recipe"] = file.recipe;
    if (!file.files.empty()) sidecar["files"] = detail::to_json(file.files);
    // A file name need not be UTF-8: invalid bytes become a replacement character instead of a failure.
    return sidecar.dump(2) + "\n";
}

std::vector<SidecarField> sidecar_fields(std::string_view sidecar) {
    std::vector<SidecarField> fields;
    const Json json = detail::parse_json(sidecar).value_or(Json());
    add_fields(json, "", fields);
    return fields;
}

std::optional<TextureRecord> read_sidecar(std::string_view json) {
    const Json sidecar = detail::parse_json(json).value_or(Json());
    const auto text = [](const Json& in, const char* key) {
        const Json* const found = in.find(key);
        return found != nullptr && found->is_string() ? found->as_string() : std::string();
    };
    if (text(sidecar, "schema") != "gonio.texture/1") return std::nullopt;
    const Json* const source = sidecar.find("source");
    const Json* const listed = sidecar.find("files");
    if (source == nullptr || !source->is_object() || listed == nullptr) return std::nullopt;
    std::optional<std::vector<FileRecord>> files = detail::read_file_records(*listed);
    if (!files) return std::nullopt;
    return TextureRecord{text(*source, "sha256"), text(sidecar, "recipe"), std::move(*files)};
}

} // namespace gonio
