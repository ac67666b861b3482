// Answers of `gonio cct` as text, as a table and as JSON.
#pragma once

#include "../json_text.hpp"
#include "question.hpp"

#include <span>
#include <string>

namespace gonio::cli {

// Everything there is to report about one colour, or a table of several. With --versus, the methods follow each colour.
std::string to_text(std::span<const CctAnswer> answers, const CctRequest& request);

Json to_json(const CctAnswer& answer, const CctRequest& request);

} // namespace gonio::cli
