// A web from a table of numbers, as written by spreadsheets.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <string>
#include <string_view>

namespace gonio {

// The first row lists γ (its first field is a title and is ignored); each further row has C and one candela for each γ;
// degrees. Fields are separated by commas, semicolons or tabs, decimals by points; empty lines and lines that begin
// with '#' are skipped. Symmetry is read from the planes as in LM-63: one plane is axial; 0–90, 0–180 and 90–270 are
// mirrored; a missing plane at 360° is closed. `source` names the table in messages. Fails (malformed) with line and
// column on a field that is not a number, on a row of another length and on angles that do not form a grid.
Result<Web> web_from_csv(std::string_view text, const std::string& source);

} // namespace gonio
