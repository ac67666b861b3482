#include <gonio/base/amount_range.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/author_csv.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {

namespace {

constexpr std::string_view separators = ",;\t";
constexpr std::string_view around_fields = " \r\"";

struct Row {
    std::vector<double> numbers;
    std::uint32_t line = 0;
};

Unexpected malformed(const std::string& source, std::uint32_t line, std::size_t column, std::string message,
                     std::string hint = {}) {
    return Unexpected(error_at(Failure::malformed, {source, line, static_cast<std::uint32_t>(column)},
                               std::move(message), std::move(hint)));
}

// The numbers of one line, without its first field if `title` is set. Unless the text is `known` to be a table, it may
// be any file, so messages must not reveal its content.
Result<Row> read_row(std::string_view line, std::uint32_t number, bool title, bool known, const std::string& source) {
    Row row;
    row.line = number;
    std::size_t start = 0;
    for (bool first = true;; first = false) {
        const std::size_t end = line.find_first_of(separators, start);
        const std::string_view field =
            trimmed(line.substr(start, end == std::string_view::npos ? end : end - start), around_fields);
        if (!(first && title)) {
            const std::optional<double> value = parse_number(field);
            if (!value)
                return malformed(source, number, start + 1,
                                 known ? fmt::format("'{}' is not a number", field) : "not a table of candela",
                                 "the first row lists gamma; each other row is C and one candela for each gamma");
            if (!in_amount_range(*value))
                return malformed(source, number, start + 1,
                                 fmt::format("{} is above {} in magnitude", *value, greatest_amount));
            row.numbers.push_back(*value);
        }
        if (end == std::string_view::npos) return row;
        start = end + 1;
    }
}

} // namespace

Result<Web> web_from_csv(std::string_view text, const std::string& source) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    IesFile table;
    bool first = true;
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string_view line = trimmed(text.substr(0, end), around_fields);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.empty() || line.starts_with('#')) continue;
        Result<Row> row = read_row(line, number, first, !table.vertical_deg.empty(), source);
        if (!row) return pass_on(row);
        if (first) {
            table.vertical_deg = std::move(row->numbers);
            const auto twice = std::adjacent_find(table.vertical_deg.begin(), table.vertical_deg.end());
            if (twice != table.vertical_deg.end())
                return malformed(source, number, 0, fmt::format("gamma {} is listed twice", *twice));
            first = false;
            continue;
        }
        if (row->numbers.size() != table.vertical_deg.size() + 1)
            return malformed(
                source, number, 1,
                fmt::format("{} numbers for {} gamma angles", row->numbers.size(), table.vertical_deg.size()),
                "a row is C and one candela for each gamma");
        // Merging two equal planes could leave a single one, which would then apply to every C.
        if (!table.horizontal_deg.empty() && table.horizontal_deg.back() == row->numbers.front())
            return malformed(source, number, 1, fmt::format("C {} is listed twice", row->numbers.front()));
        table.horizontal_deg.push_back(row->numbers.front());
        table.candela.insert(table.candela.end(), row->numbers.begin() + 1, row->numbers.end());
    }
    if (table.vertical_deg.empty() || table.horizontal_deg.empty())
        return malformed(source, 0, 0, "the table holds no plane",
                         "the first row lists gamma, the others C and candela");
    Result<ResolvedWeb> resolved = resolve_web({source, std::move(table), {}});
    if (!resolved) return pass_on(resolved);
    return std::move(resolved->web);
}

} // namespace gonio
