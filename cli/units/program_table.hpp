// `gonio units --for`: what to type into programs, a row for each.
#pragma once

#include <gonio/light/program_fields.hpp>

#include "../json_text.hpp"
#include "question.hpp"

#include <string>
#include <vector>

namespace gonio::cli {

struct ProgramRow {
    const Policy* program = nullptr;
    std::string lacks; // why the program has no such light; empty: it has one
    ProgramLight light;
};

struct ProgramTable {
    UnitsAnswer question;
    std::vector<ProgramRow> rows;
};

Result<ProgramTable> program_table(std::string_view row, const UnitsRequest& request);

std::string to_text(const ProgramTable& table);
Json to_json(const ProgramTable& table);

} // namespace gonio::cli
