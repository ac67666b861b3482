// One input of import, a profile or a rig, and its files for every target.
#pragma once

#include <gonio/base/result.hpp>

#include "../batch.hpp"
#include "../catalogue.hpp"
#include "../options/files_in_use.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

// An input and where its files go.
struct ImportJob {
    std::string file;   // what --shape or --preset says if the request describes the light
    std::string folder; // below those of the targets: "" or "office/"
    std::string name;   // of the files
};

// Writes all files of all targets or none; with -u only those of targets that are out of date.
Result<Made> import_one(const ImportJob& job, const ImportRequest& request, const FilesInUse& inputs, ReportKind kind);

} // namespace gonio::cli
