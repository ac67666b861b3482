// How answers of `gonio units` are written: lines for people, JSON, CSV.
#pragma once

#include "../json_text.hpp"
#include "question.hpp"

#include <span>
#include <string>

namespace gonio::cli {

std::string to_text(const UnitsAnswer& answer, bool explain);
Json to_json(const UnitsAnswer& answer, bool explain);

// One line for each policy.
std::string to_text(const PolicyTable& table);
Json to_json(const PolicyTable& table);

// Comma-separated: the row as given, then a column for each wanted unit. The heading takes its columns from `wanted`.
std::string csv_head(std::span<const std::string> wanted);
std::string csv_line(const UnitsAnswer& answer);
// A row that failed keeps its line.
std::string csv_line(std::string_view row, std::size_t wanted, const Error& error);

} // namespace gonio::cli
