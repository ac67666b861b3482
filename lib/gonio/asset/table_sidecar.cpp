#include <gonio/asset/detail/file_record_json.hpp>
#include <gonio/asset/table_sidecar.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/table/dds.hpp>
#include <gonio/table/table_text.hpp>

#include <algorithm>

namespace gonio {

namespace {

using detail::Json;

Json channels_json(const StoredTable& stored) {
    const TableInfo& info = info_of(stored.table.kind);
    Json channels = Json::array();
    std::size_t channel = 0;
    for (std::size_t layer = 0; layer < stored.layers.size(); ++layer)
        for (std::size_t c = 0; c < stored.layers[layer]; ++c, ++channel) {
            const ChannelRange& range = stored.ranges[channel];
            float least = stored.table.values[channel];
            float greatest = least;
            for (std::size_t i = channel; i < stored.table.values.size(); i += stored.table.channels()) {
                least = std::min(least, stored.table.values[i]);
                greatest = std::max(greatest, stored.table.values[i]);
            }
            if (stored.table.holds_root(channel)) { // which is not below 0
                least *= least;
                greatest *= greatest;
            }
            channels.push_back({{"name", info.channels[channel].name},
                                {"means", info.channels[channel].says},
                                {"layer", layer},
                                {"component", c},
                                {"offset", range.offset},
                                {"scale", range.scale},
                                {"power", stored.table.holds_root(channel) ? 2 : 1},
                                {"least", static_cast<double>(least)},
                                {"greatest", static_cast<double>(greatest)}});
        }
    return channels;
}

std::string value_in_words(const StoredTable& stored) {
    const bool roots = stored.table.has_roots;
    if (info_of(stored.pixel).steps > 0.0)
        return roots ? "(offset + scale * component)^power, the component as a number from 0 to 1, raised after "
                       "interpolation"
                     : "offset + scale * component, the component as a number from 0 to 1";
    return "the component";
}

Json axes_json(const ShadingTable& table) {
    return {{"name", to_text(table.axes)},
            {"columns", columns_in_words(table)},
            {"rows", rows_in_words(table)},
            {"n_dot_v", "cosine between the normal and the direction to the eye, 0 to 1"},
            {"roughness", "linear, 0 to 1: alpha = roughness^2"}};
}

// The components as numbers; of rgb9e5 whole texels.
Json values_json(const StoredTable& stored) {
    Json values = Json::array();
    for (const std::uint32_t bits : stored.stored) {
        if (stored.pixel == TablePixel::float32)
            values.push_back(static_cast<double>(__builtin_bit_cast(float, bits)));
        else if (stored.pixel == TablePixel::half)
            values.push_back(half_value(bits));
        else
            values.push_back(bits);
    }
    return values;
}

} // namespace

std::string table_sidecar(const StoredTable& stored, const TableDescription& description) {
    const ShadingTable& table = stored.table;
    const TableInfo& info = info_of(table.kind);
    Json sidecar{
        {"schema", "gonio.table/1"},
        {"table", info.name},
        {"means", info.summary},
        {"form", to_text(table.form)},
        {"width", table.width},
        {"height", table.height},
        {"pixel", info_of(stored.pixel).name},
        {"format", description.format},
        {"layers", stored.layers},
        {"data_bytes", raw_bytes(stored).size()},
        {"axes", axes_json(table)},
        {"value", value_in_words(stored)},
        {"channels", channels_json(stored)},
        {"lookup",
         {{"filter", table.form == TableForm::bilinear ? "bilinear, clamped to the edge, no mip levels" : "none"},
          {"glsl", table_lookup(stored, TableLanguage::glsl)},
          {"hlsl", table_lookup(stored, TableLanguage::hlsl)},
          {"msl", table_lookup(stored, TableLanguage::msl)},
          {"wgsl", table_lookup(stored, TableLanguage::wgsl)}}},
        {"error",
         {{"of", info.error},
          {"against", "quadrature over visible normals"},
          {"poses", description.error.poses},
          {"poses_are", "n.v and roughness uniform in (0, 1)"},
          {"median", description.error.median},
          {"p95", description.error.p95},
          {"max", description.error.max},
          {"rounding", stored.rounding}}},
        {"tool", std::string("gonio ") + version},
    };
    if (description.format == "dds") sidecar["dxgi_format"] = dds_format(stored).name;
    if (description.file) sidecar["files"] = detail::to_json({*description.file});
    if (description.format == "json") sidecar["values"] = values_json(stored);
    // A file name need not be UTF-8: invalid bytes become a replacement character instead of a failure.
    return sidecar.dump(2) + "\n";
}

} // namespace gonio
