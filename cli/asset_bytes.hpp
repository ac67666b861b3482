// The contents of a file of an asset, with pictures encoded.
#pragma once

#include <gonio/asset/target.hpp>
#include <gonio/base/result.hpp>

#include <string>

namespace gonio::cli {

Result<std::string> bytes_of(const AssetFile& file);

} // namespace gonio::cli
