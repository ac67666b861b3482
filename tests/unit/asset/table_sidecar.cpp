// Sidecars of tables for renderers, checked against the schema in the tree.
#include <gonio/asset/table_sidecar.hpp>
#include <gonio/base/file.hpp>

#include "../folders.hpp"
#include "json_schema.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(TableSidecar, FitsTheSchema) {
    const std::string path = std::string(test::source_folder) + "/lib/gonio/asset/table.schema.json";
    const test::JsonSchema fits(nlohmann::json::parse(read_file(path).value()));
    for (const TableInfo& info : table_infos())
        for (const TablePixelInfo& pixel : table_pixels()) {
            const bool heitz = info.kind == TableKind::ltc_heitz;
            ShadingTable table =
                make_shading_table(info.kind, TableForm::bilinear, heitz ? TableAxes::heitz : TableAxes::root, 3, 2, 1)
                    .value();
            const Result<StoredTable> stored = store_table(std::move(table), pixel.pixel);
            if (!stored) continue;
            const TableDescription of{"dds", {512, 1e-4, 2e-3, 0.25}, file_record("a \xff.dds", "abc")};
            auto json = nlohmann::json::parse(table_sidecar(*stored, of));
            EXPECT_EQ(fits.complaint(json), "") << info.name << ' ' << pixel.name;
            EXPECT_EQ(json["error"]["p95"], 2e-3);
            EXPECT_EQ(json["channels"].size(), info.channels.size());
            EXPECT_EQ(json["data_bytes"], raw_bytes(*stored).size());
            EXPECT_EQ(json["axes"]["columns"],
                      heitz ? "roughness = column/2, from the left" : "sqrt(n.v) = column/2, from the left");
            // The format json has the table in itself.
            json = nlohmann::json::parse(table_sidecar(*stored, {"json", {}, {}}));
            EXPECT_EQ(json["values"].size(), stored->stored.size());
            EXPECT_FALSE(json.contains("files"));
            json["error"]["poses"] = 512;
            EXPECT_EQ(fits.complaint(json), "") << info.name << ' ' << pixel.name;
            // Shows that the check can fail.
            json["pixel"] = "uint32";
            EXPECT_NE(fits.complaint(json), "");
        }
}

} // namespace
} // namespace gonio
