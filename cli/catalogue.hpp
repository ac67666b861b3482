// Catalogues: many inputs made into files, all of them or a shard, with a manifest of the complete assets.
#pragma once

#include <gonio/asset/manifest.hpp>
#include <gonio/base/result.hpp>

#include "arguments.hpp"
#include "batch.hpp"
#include "command.hpp"
#include "console.hpp"
#include "options/output.hpp"

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr std::array catalogue_options{
    Option{"--shard", "K/N", "process only inputs K, K+N, …: the same ones on every machine"},
    Option{"--manifest", "FILE", "write a list of the files that were made, with their hashes"},
    Option{"--merge", "", "merge the manifests of all shards, given as FILE, into that of -o"},
};

inline constexpr OptionGroup catalogue_group{"catalogue", catalogue_options};

struct Catalogue {
    std::optional<Shard> shard;
    std::optional<std::string> manifest;
};

Result<Catalogue> catalogue_of(const Arguments& arguments);

// All inputs if there is no shard.
Share share_of(const Catalogue& catalogue);

// The outcome of one input.
// NOLINTNEXTLINE(bugprone-exception-escape): as of Outcome, which it holds
struct Made {
    Outcome outcome;
    ManifestAsset asset; // without files: nothing was made
};

// run_batch(), and the manifest if requested. `recipe`: the options that everything was made with.
int run_catalogue(const Batch& batch, const Catalogue& catalogue, const std::string& recipe, ReportKind kind,
                  Console& console, const std::function<Result<Made>(std::size_t)>& work);

// --merge: merges the named manifests into one manifest of the whole, written to -o. Returns the exit status.
Result<int> merge_manifests(const Arguments& arguments, Console& console);

// An existing file, and the hash of its bytes.
Result<ManifestFile> hashed(const std::string& file);

} // namespace gonio::cli
