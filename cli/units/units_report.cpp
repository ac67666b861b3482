#include "units_report.hpp"

#include <gonio/base/text.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace gonio::cli {

namespace {

// The shortest decimal number of degrees for this angle: 40, where converting back gives 40.00000000000001.
double tidy_degrees(Radians angle) {
    const double exact = to_degrees(angle);
    const double tidy = parse_number(rounded(exact, 15)).value_or(exact);
    return degrees(tidy) == angle ? tidy : exact;
}

// Writes a value of a shape's grammar under its key with the unit: "r_m", "outer_deg", "two_sided".
struct DescribeValue {
    Json& json;
    std::string key;

    void operator()(Meters length) const { json[key + "_m"] = length.value; }
    void operator()(Radians angle) const { json[key + "_deg"] = tidy_degrees(angle); }
    void operator()(bool there) const { json[key] = there; }
    void operator()(Falloff falloff) const { json[key] = to_text(falloff); }
};

Json shape_json(const Shape& shape) {
    Json json{{"kind", kind_of(shape)}};
    for (const ShapeValue& value : values_of(shape)) {
        std::string key(value.key);
        std::replace(key.begin(), key.end(), '-', '_');
        std::visit(DescribeValue{json, std::move(key)}, value.value);
    }
    if (const auto* const profile = std::get_if<ProfileShape>(&shape)) {
        json["file"] = profile->file;
        json["flux_lm"] = flux(*profile->web).value;
        json["peak_cd"] = peak(*profile->web).intensity.value;
    }
    if (const Mask mask = mask_of(shape); mask.file != nullptr) json["mask"] = *mask.file;
    return json;
}

Json surface_json(const Primitive& surface) {
    const glm::dvec3 size = 2.0 * std::get<Box>(surface).half_size;
    return {{"kind", "box"}, {"w_m", size.x}, {"h_m", size.y}, {"d_m", size.z}};
}

std::string unit_text(const PhotometricUnit& unit) {
    std::string text(unit.unit->symbol);
    if (unit.distance) text += fmt::format("@{}m", shortest(unit.distance->value));
    if (unit.efficacy_lm_per_w) text += fmt::format("@{}lm/W", shortest(*unit.efficacy_lm_per_w));
    return text;
}

void add_unit(Json& json, const PhotometricUnit& unit) {
    if (unit.distance) json["at_m"] = unit.distance->value;
    if (unit.efficacy_lm_per_w) json["efficacy_lm_per_W"] = *unit.efficacy_lm_per_w;
    if (!unit.efficacy_of.empty()) json["efficacy_of"] = unit.efficacy_of;
}

Json answers_json(const std::vector<Answer>& answers) {
    Json results = Json::array();
    for (const Answer& answer : answers) {
        Json result{{"unit", answer.unit.unit->symbol}, {"value", answer.number}};
        add_unit(result, answer.unit);
        results.push_back(std::move(result));
    }
    return results;
}

Json question_json(const UnitsAnswer& answer, std::string_view policy) {
    Json input{{"value", answer.value.number}, {"unit", answer.value.unit.unit->symbol}};
    add_unit(input, answer.value.unit);
    return {{"schema", "gonio.units/1"},
            {"input", std::move(input)},
            {"shape", answer.surface ? surface_json(*answer.surface) : shape_json(answer.shape)},
            {"policy", policy}};
}

// The number of characters as a terminal counts them: all bytes except continuation bytes of UTF-8.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

// Columns as wide as their widest cell; the last column is not padded.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            if (i >= widths.size()) widths.push_back(0);
            widths[i] = std::max(widths[i], width_of(line[i]));
        }
    std::string text;
    for (const std::vector<std::string>& line : lines) {
        std::string row;
        for (std::size_t i = 0; i < line.size(); ++i) {
            row += line[i];
            if (i + 1 < line.size()) row.append(widths[i] - width_of(line[i]) + 2, ' ');
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + "\n";
    }
    return text;
}

} // namespace

std::string to_text(const UnitsAnswer& answer, bool explain) {
    std::string text;
    if (explain)
        for (const ConversionStep& step : answer.steps)
            text += fmt::format("# {:<28} = {} {}\n", step.formula, rounded(step.value, 9), step.unit);
    for (const Answer& one : answer.answers)
        text += fmt::format("{} {}\n", rounded(one.number), unit_text(one.unit));
    if (answer.distance) text += fmt::format("{} m\n", rounded(answer.distance->value));
    if (answer.needed_lumens) {
        text += fmt::format("{} lm", rounded(*answer.needed_lumens));
        if (answer.needed_factor) text += fmt::format(", {} times as much", rounded(*answer.needed_factor));
        text += "\n";
    }
    return text;
}

Json to_json(const UnitsAnswer& answer, bool explain) {
    Json json = question_json(answer, answer.policy->name);
    json["results"] = answers_json(answer.answers);
    if (answer.distance) json["solved"] = {{"distance_m", answer.distance->value}};
    if (answer.needed_lumens)
        json["solved"] = {{"flux_lm", *answer.needed_lumens}, {"factor", number_or_null(answer.needed_factor)}};
    if (explain) {
        json["steps"] = Json::array();
        for (const ConversionStep& step : answer.steps)
            json["steps"].push_back({{"formula", step.formula}, {"value", step.value}, {"unit", step.unit}});
    }
    json["diagnostics"] = diagnostics_json(answer.diagnostics);
    return json;
}

std::string to_text(const PolicyTable& table) {
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> head{"policy"};
    for (const PolicyRow& row : table.rows) {
        if (!row.lacks.empty()) continue;
        for (const Answer& answer : row.answers)
            head.push_back(unit_text(answer.unit));
        break;
    }
    head.insert(head.end(), {"emitted/said", "formula"});
    lines.push_back(head);
    for (const PolicyRow& row : table.rows) {
        std::vector<std::string> line{std::string(row.policy->name)};
        if (!row.lacks.empty()) {
            line.resize(head.size() - 2, "-");
            line.insert(line.end(), {"-", row.lacks});
        } else {
            for (const Answer& answer : row.answers)
                line.push_back(rounded(answer.number));
            line.push_back(row.meaning.own ? rounded(row.meaning.emitted_over_said, 4) : "not its unit");
            std::string formula = row.meaning.own ? row.meaning.formula : std::string();
            if (!row.meaning.note.empty()) formula += (formula.empty() ? "" : "; ") + row.meaning.note;
            line.push_back(std::move(formula));
        }
        lines.push_back(std::move(line));
    }
    return aligned(lines);
}

Json to_json(const PolicyTable& table) {
    Json json = question_json(table.question, "all");
    json["policies"] = Json::array();
    for (const PolicyRow& row : table.rows) {
        Json one{{"policy", row.policy->name}, {"source", row.policy->source}, {"has_light", row.lacks.empty()}};
        if (!row.lacks.empty()) {
            one["lacks"] = row.lacks;
        } else {
            one["uses_unit"] = row.meaning.own;
            one["results"] = answers_json(row.answers);
            one["emitted_over_said"] = row.meaning.emitted_over_said;
            one["formula"] = row.meaning.formula;
            one["note"] = row.meaning.note;
        }
        json["policies"].push_back(std::move(one));
    }
    json["diagnostics"] = diagnostics_json(table.question.diagnostics);
    return json;
}

std::string csv_head(std::span<const std::string> wanted) {
    std::string line = "value,shape";
    for (const std::string& unit : wanted)
        line += "," + csv_field(unit);
    return line + ",error\n";
}

std::string csv_line(const UnitsAnswer& answer) {
    std::string line = csv_field(answer.value_text) + "," + csv_field(answer.shape_text);
    for (const Answer& one : answer.answers)
        line += "," + shortest(one.number);
    return line + ",\n";
}

std::string csv_line(std::string_view row, std::size_t wanted, const Error& error) {
    const std::size_t comma = row.find(',');
    const std::string_view shape = comma == std::string_view::npos ? std::string_view() : row.substr(comma + 1);
    return fmt::format("{},{},{}{}\n", csv_field(trimmed(row.substr(0, comma))), csv_field(trimmed(shape)),
                       std::string(wanted, ','), csv_field(error.diagnostics.back().message));
}

} // namespace gonio::cli
