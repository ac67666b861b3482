// The sidecar of a table for renderers: a JSON object of schema gonio.table/1 that states what its texels mean, how it
// is looked up, and how exact a lookup is (described by table.schema.json).
#pragma once

#include <gonio/asset/file_record.hpp>
#include <gonio/table/stored_table.hpp>
#include <gonio/table/table_error.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace gonio {

struct TableDescription {
    std::string_view format;        // "dds"
    TableError error;               // of lookups of the table as stored
    std::optional<FileRecord> file; // empty: the numbers are in the object itself
};

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles.
std::string table_sidecar(const StoredTable& stored, const TableDescription& description);

} // namespace gonio
