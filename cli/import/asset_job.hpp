// One input of import, a profile or a rig, and its files for every target.
#pragma once

#include <gonio/base/result.hpp>

#include "../batch.hpp"
#include "../catalogue.hpp"
#include "../options/files_in_use.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

// Writes all files of all targets or none; with -u only those of targets that are out of date.
Result<Made> import_one(const std::string& file, const ImportRequest& request, const FilesInUse& inputs,
                        ReportKind kind);

} // namespace gonio::cli
