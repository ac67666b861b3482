#include "program_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio::cli {

Result<ProgramTable> program_table(std::string_view row, const UnitsRequest& request) {
    Result<UnitsAnswer> question = read_question(row, request);
    if (!question) return pass_on(question);
    if (Result<void> light = refuse_surface(*question, "--for"); !light) return pass_on(light);
    Result<Emission> emission = emission_of(question->shape, question->value);
    if (!emission) return pass_on(emission);
    ProgramTable table{std::move(*question), {}};
    for (const Policy* const program : request.programs) {
        ProgramRow made{program, {}, {}};
        Result<ProgramLight> light = program_light(*program, table.question.shape, *emission);
        if (!light && light.error().failure != Failure::unsupported) return pass_on(light);
        if (light)
            made.light = std::move(*light);
        else
            made.lacks = light.error().diagnostics.back().message;
        table.rows.push_back(std::move(made));
    }
    return table;
}

std::string to_text(const ProgramTable& table) {
    std::size_t program_width = 0;
    std::size_t light_width = 0;
    for (const ProgramRow& row : table.rows) {
        program_width = std::max(program_width, row.program->name.size());
        light_width = std::max(light_width, row.light.light.size());
    }
    std::string text;
    for (const ProgramRow& row : table.rows) {
        std::string fields;
        for (const ProgramField& field : row.light.fields)
            fields += fmt::format("{}{} {}{}{}", fields.empty() ? "" : ", ", field.name, field.value,
                                  field.unit.empty() ? "" : " ", field.unit);
        if (!row.light.note.empty()) fields += fmt::format(" ({})", row.light.note);
        if (!row.lacks.empty()) fields = row.lacks;
        text +=
            fmt::format("{:<{}}  {:<{}}  {}\n", row.program->name, program_width, row.light.light, light_width, fields);
    }
    return text;
}

Json to_json(const ProgramTable& table) {
    Json json{{"schema", "gonio.units-for/1"},
              {"value", table.question.value_text},
              {"shape", table.question.shape_text},
              {"programs", Json::array()}};
    for (const ProgramRow& row : table.rows) {
        Json one{{"program", row.program->name}, {"has_light", row.lacks.empty()}};
        if (!row.lacks.empty()) {
            one["lacks"] = row.lacks;
        } else {
            one["light"] = row.light.light;
            one["fields"] = Json::array();
            for (const ProgramField& field : row.light.fields)
                one["fields"].push_back({{"name", field.name}, {"value", field.value}, {"unit", field.unit}});
            one["note"] = row.light.note;
        }
        json["programs"].push_back(std::move(one));
    }
    json["diagnostics"] = diagnostics_json(table.question.diagnostics);
    return json;
}

} // namespace gonio::cli
