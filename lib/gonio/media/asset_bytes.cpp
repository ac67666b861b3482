#include <gonio/asset/sidecar.hpp>
#include <gonio/media/asset_bytes.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/media/texel_pixel.hpp>
#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_measures.hpp>

#include <memory>
#include <utility>
#include <variant>

namespace gonio::media {

namespace {

// The sidecar's fields as attributes, but those that encode_environment() writes.
std::vector<ImageAttribute> attributes_of(const std::string& sidecar) {
    std::vector<ImageAttribute> attributes;
    for (SidecarField& field : sidecar_fields(sidecar)) {
        if (field.name == "layout" || field.name == "nits_per_unit") continue;
        std::string name = "gonio:" + field.name;
        if (const auto* const number = std::get_if<double>(&field.value))
            attributes.push_back({std::move(name), std::vector<float>{static_cast<float>(*number)}});
        else
            attributes.push_back({std::move(name), std::get<std::string>(field.value)});
    }
    return attributes;
}

Result<std::vector<NamedBytes>> environment_bytes(const std::string& name, const AssetEnvironment& environment,
                                                  unsigned threads) {
    EnvironmentDescription description;
    description.sun = environment.sun;
    description.source = environment.source;
    description.source_sha256 = environment.source_sha256;
    Result<EnvironmentFiles> files =
        environment_files(*environment.map, environment.map->nits_per_unit(), {find_image_format(name), Pixel::float32},
                          std::move(description), name, threads);
    if (!files) return pass_on(files);
    return std::vector<NamedBytes>{{name, std::move(files->image)}, {name + ".json", std::move(files->sidecar)}};
}

} // namespace

Result<EnvironmentFiles> environment_files(const EnvironmentMap& map, double nits_per_unit,
                                           const EnvironmentStorage& storage, EnvironmentDescription description,
                                           const std::string& name, unsigned threads) {
    // As the file will hold it, so that the sidecar's lux are those that are read from the file.
    const auto stored =
        std::make_shared<const EnvironmentMap>(as_stored(map, nits_per_unit, *storage.format, storage.pixel));
    Result<Sky> as_written = resolve_sky({ImageSkyKind{}, {}, glm::dvec3(1.0), {}, 0.0}, stored);
    if (!as_written) return pass_on(as_written);
    description.grid = stored->grid();
    description.nits_per_unit = nits_per_unit;
    description.pixel = to_text(storage.pixel);
    description.measures = measure(*as_written, threads);
    Result<std::string> bytes = encode_environment(*stored, *storage.format, storage.pixel,
                                                   attributes_of(environment_sidecar(description)), threads);
    if (!bytes) return pass_on(bytes);
    description.file = file_record(name, *bytes);
    return EnvironmentFiles{std::move(*bytes), environment_sidecar(description)};
}

Result<std::vector<NamedBytes>> bytes_of(const AssetFile& file, unsigned threads) {
    if (file.environment) return environment_bytes(file.name, *file.environment, threads);
    if (!file.picture) return std::vector<NamedBytes>{{file.name, file.bytes}};
    ImageWriteOptions options;
    options.pixel = pixel_of(file.picture->texel_type);
    if (file.picture->image.channels == 1) options.channel_names = {"Y"};
    options.threads = threads;
    Result<std::string> bytes = encode_image(file.picture->image, *find_image_format(file.name), options);
    if (!bytes) return pass_on(bytes);
    return std::vector<NamedBytes>{{file.name, std::move(*bytes)}};
}

} // namespace gonio::media
