// The files of an asset as bytes, with pictures encoded.
#pragma once

#include <gonio/asset/target.hpp>
#include <gonio/base/result.hpp>

#include <string>
#include <vector>

namespace gonio::cli {

struct NamedBytes {
    std::string name;
    std::string bytes;
};

// The file; of an environment image its sidecar, too: NAME.json. 0 threads: all.
Result<std::vector<NamedBytes>> bytes_of(const AssetFile& file, unsigned threads);

} // namespace gonio::cli
