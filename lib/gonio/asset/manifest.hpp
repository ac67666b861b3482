// The manifest of a batch: a JSON object of schema gonio.manifest/1 that lists the complete assets, with the hash of
// every file (described by manifest.schema.json). A catalogue may be made in shards; their manifests are merged.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {

// Every count-th input, starting with the index-th: 1 ≤ index ≤ count.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;

    bool operator==(const Shard&) const = default;
};

struct ManifestFile {
    std::string file;
    std::string sha256;

    bool operator==(const ManifestFile&) const = default;
};

// An input and the files that were made from it, all of which exist.
struct ManifestAsset {
    ManifestFile input;
    std::vector<ManifestFile> files;
    std::vector<std::string> remarks = {}; // what the files cannot store, and what they contain instead

    bool operator==(const ManifestAsset&) const = default;
};

struct Manifest {
    std::string recipe;                // the options that the assets were made with
    std::optional<Shard> shard;        // nothing: the whole batch
    std::size_t inputs = 0;            // number of inputs tried
    std::vector<ManifestAsset> assets; // in the order of the inputs' names
    std::vector<std::string> failed;   // inputs without any result, in that order

    bool operator==(const Manifest&) const = default;
};

// Puts assets and failed inputs into the order of their names, whatever the order in which they were made.
void sort_by_name(Manifest& manifest);

// Keys in a fixed order, two spaces of indentation, a newline at the end.
std::string manifest_json(const Manifest& manifest);

// `name` is the file's name, for messages. Fails (malformed) if the text is not such an object, and (unsupported) on
// another schema.
Result<Manifest> read_manifest(std::string_view json, const std::string& name);

// Fails (usage) when the manifests were made with different options or numbers of shards, when a shard is missing, and
// when two manifests list the same input or the same file.
Result<Manifest> merged(std::span<const Manifest> manifests);

} // namespace gonio
