// libFuzzer: for any bytes, a record that gonio writes beside its outputs is refused or is sound, and then it is the
// same after writing and reading it again. The first byte selects: 'a' the record of an asset, 'b' the sidecar of a
// texture, 'c' the manifest of a batch.
#include <gonio/asset/asset_record.hpp>
#include <gonio/asset/manifest.hpp>
#include <gonio/asset/sidecar.hpp>

#include "check.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

namespace {

using namespace gonio;
using namespace gonio::fuzz;

void check_asset_record(std::string_view text) {
    const std::optional<AssetRecord> record = read_asset_record(text);
    require(record.has_value() == read_asset_record(text).has_value());
    if (!record) return;
    require(!record->source_sha256.empty());
    const std::string written = asset_record_json(*record);
    const std::optional<AssetRecord> again = read_asset_record(written);
    require(again.has_value() && asset_record_json(*again) == written);
}

void check_sidecar(std::string_view text) {
    const std::vector<SidecarField> fields = sidecar_fields(text);
    require(fields.size() == sidecar_fields(text).size());
    for (const SidecarField& field : fields)
        if (const double* const number = std::get_if<double>(&field.value)) require(std::isfinite(*number));
    const std::optional<TextureRecord> record = read_sidecar(text);
    const std::optional<TextureRecord> again = read_sidecar(text);
    require(record.has_value() == again.has_value());
    if (!record) return;
    require(record->source_sha256 == again->source_sha256 && record->recipe == again->recipe &&
            record->files == again->files);
    // Both readers return the same source.
    if (record->source_sha256.empty()) return;
    require(std::any_of(fields.begin(), fields.end(), [&](const SidecarField& field) {
        const std::string* const said = std::get_if<std::string>(&field.value);
        return field.name == "source.sha256" && said != nullptr && *said == record->source_sha256;
    }));
}

void check_manifest(std::string_view text) {
    const Result<Manifest> read = read_twice([&] { return read_manifest(text, "fuzz.json"); }, std::equal_to<>());
    if (!read) return;
    if (read->shard) require(read->shard->index >= 1 && read->shard->index <= read->shard->count);
    const Result<Manifest> again = read_manifest(manifest_json(*read), "again.json");
    require(again.has_value() && *again == *read);
    const std::array parts{*read, *read};
    for (const std::size_t count : {std::size_t{1}, std::size_t{2}}) {
        const Result<Manifest> whole = merged(std::span(parts).first(count));
        if (!whole) require_reason(whole.error());
        // The same assets or the same shard twice do not make one batch.
        else
            require(count == 1 || (read->assets.empty() && !read->shard));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text = as_text(data, size);
    if (text.empty()) return 0;
    constexpr std::array checks{check_asset_record, check_sidecar, check_manifest};
    checks[take_choice(text, checks.size())](text);
    return 0;
}
