// The files of an asset as bytes, with pictures encoded.
#pragma once

#include <gonio/asset/environment_sidecar.hpp>
#include <gonio/asset/target.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>

#include <string>
#include <vector>

namespace gonio::media {

struct EnvironmentStorage {
    const ImageFormat* format;
    Pixel pixel;
};

// An image and its sidecar as bytes.
struct EnvironmentFiles {
    std::string image;
    std::string sidecar;
};

// `map` rounded to what the storage holds, with a pixel of 1 at `nits_per_unit` cd/m². The description is completed
// here, except for the sun and the source. `name`: of the image's file, without its folder. 0 threads: all.
Result<EnvironmentFiles> environment_files(const EnvironmentMap& map, double nits_per_unit,
                                           const EnvironmentStorage& storage, EnvironmentDescription description,
                                           const std::string& name, unsigned threads = 0);

struct NamedBytes {
    std::string name;
    std::string bytes;
};

// The file; of an environment image its sidecar, too: NAME.json. 0 threads: all.
Result<std::vector<NamedBytes>> bytes_of(const AssetFile& file, unsigned threads = 0);

} // namespace gonio::media
