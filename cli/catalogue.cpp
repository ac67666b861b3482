#include "catalogue.hpp"

#include <gonio/asset/content_hash.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/unit_text.hpp>

#include "options/files_in_use.hpp"
#include "options/profile_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

Result<Shard> parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const std::optional<double> index = parse_number(text.substr(0, slash));
    const std::optional<double> count =
        slash == std::string::npos ? std::nullopt : parse_number(text.substr(slash + 1));
    const bool whole = index && count && *index == std::floor(*index) && *count == std::floor(*count);
    if (!whole || *index < 1.0 || *index > *count || *count > 1e6)
        return fail("USE0105", fmt::format("--shard takes K/N with K from 1 to N, not '{}'", text),
                    "for example --shard 1/4");
    return Shard{static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

// Lists complete assets and failed ones, in the order of the inputs.
Result<void> write_manifest(const Catalogue& catalogue, const std::string& recipe, const Batch& batch,
                            std::vector<ManifestAsset> assets) {
    Manifest manifest;
    manifest.shard = catalogue.shard;
    manifest.inputs = batch.inputs.size();
    manifest.recipe = recipe;
    for (std::size_t i = 0; i < assets.size(); ++i)
        if (assets[i].files.empty())
            manifest.failed.push_back(batch.inputs[i]);
        else
            manifest.assets.push_back(std::move(assets[i]));
    sort_by_name(manifest); // a list may have them in another order
    return write_output(*catalogue.manifest, manifest_json(manifest));
}

} // namespace

Result<Catalogue> catalogue_of(const Arguments& arguments) {
    Catalogue catalogue;
    if (const auto text = arguments.value("--shard")) {
        Result<Shard> shard = parse_shard(*text);
        if (!shard) return pass_on(shard);
        catalogue.shard = *shard;
    }
    catalogue.manifest = arguments.value("--manifest");
    return catalogue;
}

Share share_of(const Catalogue& catalogue) {
    return catalogue.shard ? Share{catalogue.shard->index - 1, catalogue.shard->count} : Share{};
}

int run_catalogue(const Batch& batch, const Catalogue& catalogue, const std::string& recipe, ReportKind kind,
                  Console& console, const std::function<Result<Made>(std::size_t)>& work) {
    std::vector<ManifestAsset> assets(catalogue.manifest ? batch.inputs.size() : 0);
    int status = run_batch(batch, kind, console, [&](std::size_t index) {
        Result<Made> made = work(index);
        if (made) {
            if (catalogue.manifest) assets[index] = std::move(made->asset);
            return std::move(made->outcome);
        }
        Outcome failed;
        failed.error = std::move(made.error());
        return failed;
    });
    if (catalogue.manifest)
        if (const Result<void> written = write_manifest(catalogue, recipe, batch, std::move(assets)); !written)
            status = worse(status, console.fail(written.error()));
    return status;
}

Result<int> merge_manifests(const Arguments& arguments, Console& console) {
    if constexpr (is_for_page)
        return fail("UNS0101", "this page does not merge manifests", "the command-line tool does");
    const std::optional<std::string> output = arguments.value("--output");
    if (!output) return fail("USE0104", "no output is given", "use -o FILE");
    Result<std::vector<std::string>> names = input_files(arguments);
    if (!names) return pass_on(names);
    std::vector<Manifest> manifests;
    for (const std::string& name : *names) {
        Result<std::string> text =
            name == "-" ? read_standard_input(limit("manifest-bytes")) : read_file(name, limit("manifest-bytes"));
        if (!text) return pass_on(text);
        Result<Manifest> manifest = read_manifest(*text, name);
        if (!manifest) return pass_on(manifest);
        manifests.push_back(std::move(*manifest));
    }
    if (Result<void> free = check_outputs(*names, {&*output, 1}); !free) return pass_on(free);
    const Result<Manifest> whole = merged(manifests);
    if (!whole) return Unexpected(whole.error());
    if (Result<void> written = write_output(*output, manifest_json(*whole)); !written) return pass_on(written);
    console.note(fmt::format("{} manifests merged: {} inputs, {} failed", manifests.size(), whole->inputs,
                             whole->failed.size()));
    return 0;
}

Result<ManifestFile> hashed(const std::string& file) {
    Result<std::string> bytes = read_file(file, limit("output-bytes"));
    if (!bytes) return pass_on(bytes);
    return ManifestFile{file, sha256(*bytes)};
}

} // namespace gonio::cli
