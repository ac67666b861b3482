#include <gonio/base/unit_text.hpp>
#include <gonio/figures/road_surface.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

namespace gonio {

namespace {

// The angles of CIE 144:2001.
constexpr std::array standard_tan_gamma{0.0, 0.25, 0.5, 0.75, 1.0,  1.25, 1.5,  1.75, 2.0, 2.5,
                                        3.0, 3.5,  4.0, 4.5,  5.0,  5.5,  6.0,  6.5,  7.0, 7.5,
                                        8.0, 8.5,  9.0, 9.5,  10.0, 10.5, 11.0, 11.5, 12.0};
constexpr std::array standard_beta_deg{0.0,  2.0,  5.0,  10.0, 15.0,  20.0,  25.0,  30.0,  35.0,  40.0,
                                       45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0, 180.0};

// The standard table R3, S1 1.11, for Q0 = 0.07. Light from far away and from the sides adds too little to be listed.
// clang-format off
constexpr std::array<double, 580> r3{
    294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0, 294.0,
    326.0, 326.0, 321.0, 321.0, 317.0, 312.0, 308.0, 308.0, 303.0, 298.0, 294.0, 280.0, 271.0, 262.0, 258.0, 253.0, 249.0, 244.0, 240.0, 240.0,
    344.0, 344.0, 339.0, 339.0, 326.0, 317.0, 308.0, 298.0, 289.0, 276.0, 262.0, 235.0, 217.0, 204.0, 199.0, 199.0, 199.0, 199.0, 194.0, 194.0,
    357.0, 353.0, 353.0, 339.0, 321.0, 303.0, 285.0, 267.0, 244.0, 222.0, 204.0, 176.0, 158.0, 149.0, 149.0, 149.0, 145.0, 136.0, 140.0, 140.0,
    362.0, 362.0, 352.0, 326.0, 276.0, 249.0, 226.0, 204.0, 181.0, 158.0, 140.0, 118.0, 104.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0, 100.0,
    357.0, 357.0, 348.0, 298.0, 244.0, 208.0, 176.0, 154.0, 136.0, 118.0, 104.0, 83.0, 73.0, 70.0, 71.0, 74.0, 77.0, 77.0, 77.0, 78.0,
    353.0, 348.0, 326.0, 267.0, 217.0, 176.0, 145.0, 117.0, 100.0, 86.0, 78.0, 72.0, 60.0, 57.0, 58.0, 60.0, 60.0, 60.0, 61.0, 62.0,
    339.0, 335.0, 303.0, 231.0, 172.0, 127.0, 104.0, 89.0, 79.0, 70.0, 62.0, 51.0, 45.0, 44.0, 45.0, 46.0, 45.0, 45.0, 46.0, 47.0,
    326.0, 321.0, 280.0, 190.0, 136.0, 100.0, 82.0, 71.0, 62.0, 54.0, 48.0, 39.0, 34.0, 34.0, 34.0, 35.0, 36.0, 36.0, 37.0, 38.0,
    289.0, 280.0, 222.0, 127.0, 86.0, 65.0, 54.0, 44.0, 38.0, 34.0, 25.0, 23.0, 22.0, 23.0, 24.0, 24.0, 24.0, 24.0, 24.0, 25.0,
    253.0, 235.0, 163.0, 85.0, 53.0, 38.0, 31.0, 25.0, 23.0, 20.0, 18.0, 15.0, 15.0, 14.0, 15.0, 15.0, 16.0, 16.0, 17.0, 17.0,
    217.0, 194.0, 122.0, 60.0, 35.0, 25.0, 22.0, 19.0, 16.0, 15.0, 13.0, 9.9, 9.0, 9.0, 9.9, 11.0, 11.0, 12.0, 12.0, 13.0,
    190.0, 163.0, 90.0, 43.0, 26.0, 20.0, 16.0, 14.0, 12.0, 9.9, 9.0, 7.4, 7.0, 7.1, 7.5, 8.3, 8.7, 9.0, 9.0, 9.9,
    163.0, 136.0, 73.0, 31.0, 20.0, 15.0, 12.0, 9.9, 9.0, 8.3, 7.7, 5.4, 4.8, 4.9, 5.4, 6.1, 7.0, 7.7, 8.3, 8.5,
    145.0, 109.0, 60.0, 24.0, 16.0, 12.0, 9.0, 8.2, 7.7, 6.8, 6.1, 4.3, 3.2, 3.3, 3.7, 4.3, 5.2, 6.5, 6.9, 7.1,
    127.0, 94.0, 47.0, 18.0, 14.0, 9.9, 7.7, 6.9, 6.1, 5.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    113.0, 77.0, 36.0, 15.0, 11.0, 9.0, 8.0, 6.5, 5.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    104.0, 68.0, 30.0, 11.0, 8.3, 6.4, 5.1, 4.3, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    95.0, 60.0, 24.0, 8.5, 6.5, 5.2, 4.3, 3.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    87.0, 53.0, 21.0, 7.1, 5.3, 4.4, 3.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    83.0, 47.0, 17.0, 6.1, 4.4, 3.6, 3.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    78.0, 42.0, 15.0, 5.2, 3.7, 3.1, 2.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    73.0, 38.0, 12.0, 4.3, 3.2, 2.4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    69.0, 34.0, 9.9, 3.8, 3.5, 2.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    65.0, 32.0, 9.0, 3.3, 2.4, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    62.0, 29.0, 8.0, 3.0, 2.1, 1.9, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    59.0, 26.0, 7.1, 2.6, 1.9, 1.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    56.0, 24.0, 6.3, 2.4, 1.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    53.0, 22.0, 5.6, 2.1, 1.8, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
};
// clang-format on

RoadSurface standard_surface(const char* name, const char* title, const char* rule, std::span<const double> r,
                             double average) {
    return {name,
            title,
            rule,
            {standard_tan_gamma.begin(), standard_tan_gamma.end()},
            {standard_beta_deg.begin(), standard_beta_deg.end()},
            {r.begin(), r.end()},
            average};
}

// The interval of ascending values that a value is in, and where in it.
std::pair<std::size_t, double> locate(std::span<const double> values, double value) {
    const auto above = std::upper_bound(values.begin() + 1, values.end() - 1, value);
    const auto low = static_cast<std::size_t>(above - values.begin()) - 1;
    return {low, (value - values[low]) / (values[low + 1] - values[low])};
}

struct Field {
    std::string text;
    std::uint32_t column = 1;
};

// Reads a table, line by line.
class TableReader {
public:
    explicit TableReader(const std::string& source) : source_(source) {}

    Result<void> line(std::string_view text) {
        ++line_;
        const std::vector<Field> fields = fields_of(text.substr(0, text.find('#')));
        if (fields.empty()) return {};
        if (fields.front().text == "q0" || fields.front().text == "Q0") return average(fields);
        Row row{line_, {}};
        for (const Field& field : fields) {
            const std::optional<double> number = parse_number(field.text);
            if (!number && rows_.empty() && row.numbers.empty()) continue; // what the corner of a heading is called
            if (!number || !(*number >= 0.0) || !std::isfinite(*number))
                return bad(line_, field.column, fmt::format("'{}' is not a number from 0 up", field.text),
                           "a line of angles β, then a line for each tan γ, with r times 10000");
            row.numbers.push_back(*number);
        }
        if (rows_.size() == most_rows || row.numbers.size() > most_columns)
            return bad(line_, 1, fmt::format("more than {} lines of {} numbers", most_rows, most_columns),
                       "standard tables have 29 lines of 20");
        if (!row.numbers.empty()) rows_.push_back(std::move(row));
        return {};
    }

    Result<RoadSurface> take() {
        RoadSurface surface;
        surface.name = source_;
        surface.title = "a table of its own";
        surface.average = average_;
        const bool is_bare = rows_.size() == standard_tan_gamma.size() &&
                             std::all_of(rows_.begin(), rows_.end(),
                                         [](const Row& row) { return row.numbers.size() == standard_beta_deg.size(); });
        Result<void> filled = is_bare ? fill_bare(surface) : fill_headed(surface);
        if (filled) filled = check(surface);
        if (!filled) return pass_on(filled);
        return surface;
    }

private:
    static constexpr std::size_t most_rows = 500;
    static constexpr std::size_t most_columns = 500;

    struct Row {
        std::uint32_t line = 0;
        std::vector<double> numbers;
    };

    Unexpected bad(std::uint32_t line, std::uint32_t column, std::string message, std::string hint) const {
        return Unexpected(error_at("INP0101", {source_, line, column}, std::move(message), std::move(hint)));
    }

    static std::vector<Field> fields_of(std::string_view line) {
        const bool has_semicolons = line.find(';') != std::string_view::npos;
        const std::string_view separators = has_semicolons ? "; \t\r" : ", \t\r";
        std::vector<Field> fields;
        bool inside = false;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (separators.find(line[i]) != std::string_view::npos) {
                inside = false;
                continue;
            }
            if (!inside) fields.push_back({{}, static_cast<std::uint32_t>(i) + 1});
            inside = true;
            fields.back().text += has_semicolons && line[i] == ',' ? '.' : line[i];
        }
        return fields;
    }

    Result<void> average(const std::vector<Field>& fields) {
        const std::optional<double> number = fields.size() == 2 ? parse_number(fields[1].text) : std::nullopt;
        if (!number || !(*number > 0.0 && *number < 1.0))
            return bad(line_, fields.back().column, "q0 is not followed by a number between 0 and 1",
                       "write the average luminance coefficient of the table: q0 0.07");
        average_ = *number;
        return {};
    }

    Result<void> fill_bare(RoadSurface& surface) const {
        surface.tan_gamma.assign(standard_tan_gamma.begin(), standard_tan_gamma.end());
        surface.beta_deg.assign(standard_beta_deg.begin(), standard_beta_deg.end());
        for (const Row& row : rows_)
            surface.r.insert(surface.r.end(), row.numbers.begin(), row.numbers.end());
        return {};
    }

    Result<void> fill_headed(RoadSurface& surface) const {
        if (rows_.size() < 3)
            return bad(line_, 1, fmt::format("{} lines of numbers are no r-table", rows_.size()),
                       "a line of angles β, then a line for each tan γ, or 29 lines of 20 numbers");
        surface.beta_deg = rows_.front().numbers;
        // The corner of the heading may have a number too.
        if (surface.beta_deg.size() == rows_[1].numbers.size() && !surface.beta_deg.empty())
            surface.beta_deg.erase(surface.beta_deg.begin());
        for (std::size_t i = 1; i < rows_.size(); ++i) {
            const Row& row = rows_[i];
            if (row.numbers.size() != surface.beta_deg.size() + 1)
                return bad(
                    row.line, 1,
                    fmt::format("{} numbers in a table of {} angles β", row.numbers.size(), surface.beta_deg.size()),
                    "a line has tan γ, then r times 10000 for each angle β; write 0 where there is none");
            surface.tan_gamma.push_back(row.numbers.front());
            surface.r.insert(surface.r.end(), row.numbers.begin() + 1, row.numbers.end());
        }
        return {};
    }

    Result<void> check(const RoadSurface& surface) const {
        const auto ascends = [](const std::vector<double>& values) {
            return values.size() >= 2 && values.front() == 0.0 &&
                   std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
        };
        if (!ascends(surface.beta_deg) || surface.beta_deg.back() != 180.0)
            return bad(rows_.front().line, 1, "the angles β do not ascend from 0 to 180",
                       "the heading has β in degrees: 0, 2, 5, 10, … 180");
        if (!ascends(surface.tan_gamma))
            return bad(rows_.back().line, 1, "the tan γ do not ascend from 0",
                       "each line begins with its tan γ: 0, 0.25, 0.5, … 12");
        if (std::all_of(surface.r.begin(), surface.r.end(), [](double r) { return r == 0.0; }))
            return bad(rows_.back().line, 1, "the table reflects nothing", "r is written times 10000: 294, not 0.0294");
        return {};
    }

    const std::string& source_;
    std::uint32_t line_ = 0;
    std::vector<Row> rows_;
    std::optional<double> average_;
};

} // namespace

double RoadSurface::reduced_coefficient(double tangent, double angle_deg) const {
    if (!(tangent <= tan_gamma.back())) return 0.0;
    const auto [i, u] = locate(tan_gamma, tangent);
    const auto [j, v] = locate(beta_deg, std::clamp(angle_deg, 0.0, 180.0));
    const std::size_t columns = beta_deg.size();
    const auto along = [&, column = j, share = v](std::size_t row) {
        const double* const values = r.data() + row * columns + column;
        return values[0] + share * (values[1] - values[0]);
    };
    return 1e-4 * (along(i) + u * (along(i + 1) - along(i)));
}

double RoadSurface::specular_factor() const {
    const double below = reduced_coefficient(0.0, 0.0);
    return below > 0.0 ? reduced_coefficient(2.0, 0.0) / below : 0.0;
}

std::span<const RoadSurface> known_road_surfaces() {
    static const std::array known{standard_surface("r3", "asphalt, rather glossy", "CIE 144:2001, R3", r3, 0.07)};
    return known;
}

Result<RoadSurface> parse_road_surface(std::string_view text, const std::string& source) {
    TableReader reader(source);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (Result<void> read = reader.line(text.substr(0, end)); !read) return pass_on(read);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.take();
}

Result<RoadSurface> with_average(RoadSurface surface, double average) {
    if (!(average > 0.0 && average < 1.0))
        return fail("USE0106", fmt::format("an average luminance coefficient of {:.4g}", average),
                    "Q0 of a road is between 0 and 1, mostly 0.05 to 0.1");
    if (!surface.average)
        return fail("USE0104", fmt::format("'{}' does not state its average luminance coefficient", surface.name),
                    "add a line to the table: q0 0.07");
    for (double& r : surface.r)
        r *= average / *surface.average;
    surface.average = average;
    return surface;
}

} // namespace gonio
