#include "asset_bytes.hpp"

#include <gonio/media/image_file.hpp>

#include "sky/environment_output.hpp"
#include "texel_pixel.hpp"

#include <utility>

namespace gonio::cli {

namespace {

Result<std::vector<NamedBytes>> environment_bytes(const std::string& name, const AssetEnvironment& environment,
                                                  unsigned threads) {
    EnvironmentDescription description;
    description.sun = environment.sun;
    description.source = environment.source;
    description.source_sha256 = environment.source_sha256;
    Result<EnvironmentFiles> files = environment_files(*environment.map, environment.map->nits_per_unit(),
                                                       {media::find_image_format(name), media::Pixel::float32},
                                                       std::move(description), name, threads);
    if (!files) return pass_on(files);
    return std::vector<NamedBytes>{{name, std::move(files->image)}, {name + ".json", std::move(files->sidecar)}};
}

} // namespace

Result<std::vector<NamedBytes>> bytes_of(const AssetFile& file, unsigned threads) {
    if (file.environment) return environment_bytes(file.name, *file.environment, threads);
    if (!file.picture) return std::vector<NamedBytes>{{file.name, file.bytes}};
    media::ImageWriteOptions options;
    options.pixel = pixel_of(file.picture->texel_type);
    if (file.picture->image.channels == 1) options.channel_names = {"Y"};
    Result<std::string> bytes = media::encode_image(file.picture->image, *media::find_image_format(file.name), options);
    if (!bytes) return pass_on(bytes);
    return std::vector<NamedBytes>{{file.name, std::move(*bytes)}};
}

} // namespace gonio::cli
