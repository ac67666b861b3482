#include "question.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/text.hpp>
#include <gonio/light/program_fields.hpp>

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

// The default units for a shape.
std::vector<std::string> usual_units(const Shape& shape) {
    switch (class_of(shape)) {
    case ShapeClass::punctual:
        return {"lm", "cd", "lx@1m"};
    case ShapeClass::area:
        return {"lm", "cd", "nt", "ev"};
    case ShapeClass::sun:
        break;
    }
    return {"lx", "nt", "ev"};
}

std::vector<std::string> split_at_commas(std::string_view text) {
    std::vector<std::string> parts;
    for (std::size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',')) {
        parts.emplace_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    parts.emplace_back(text);
    return parts;
}

bool is_luminance(Dimension dimension) {
    return dimension == Dimension::luminance || dimension == Dimension::luminance_ev;
}

// For a shape without an area, a luminance is that of the assumed shape with the same flux.
bool takes_assumed(const Shape& shape, const UnitsRequest& request, Dimension dimension) {
    return request.assumed && is_luminance(dimension) && class_of(shape) == ShapeClass::punctual;
}

Result<Emission> emission(const Shape& shape, const PhotometricValue& value, const UnitsRequest& request,
                          ConversionSteps* steps) {
    if (!takes_assumed(shape, request, value.unit.unit->dimension)) return emission_of(shape, value, steps);
    Result<Emission> assumed = emission_of(*request.assumed, value, steps);
    if (!assumed) return assumed;
    return with_same_flux(*request.assumed, *assumed, shape);
}

Result<double> express_as(const Shape& shape, const Emission& emitted, const PhotometricUnit& unit,
                          const UnitsRequest& request, ConversionSteps* steps) {
    if (!takes_assumed(shape, request, unit.unit->dimension)) return express(shape, emitted, unit, steps);
    Result<Emission> assumed = with_same_flux(shape, emitted, *request.assumed);
    if (!assumed) return pass_on(assumed);
    return express(*request.assumed, *assumed, unit, steps);
}

// The other units of a luminance or an illuminance without a distance; empty for other values.
std::vector<std::string> units_of_same_quantity(const PhotometricUnit& unit) {
    const PhotometricUnit nits{find_unit("nt"), std::nullopt, std::nullopt};
    const PhotometricUnit lux{find_unit("lx"), std::nullopt, std::nullopt};
    if (same_quantity(unit, nits)) return {"nt", "fL", "ev"};
    if (same_quantity(unit, lux)) return {"lx", "fc", "evlx"};
    return {};
}

Result<std::vector<PhotometricUnit>> wanted_units(const UnitsRequest& request, const Shape& shape) {
    std::vector<PhotometricUnit> units;
    for (const std::string& text : request.wanted.empty() ? usual_units(shape) : request.wanted) {
        Result<PhotometricUnit> unit = parse_photometric_unit(text);
        if (!unit) return pass_on(unit);
        units.push_back(*unit);
    }
    return units;
}

// A warning if the policy emits a flux other than the value says.
void warn(const Policy& policy, const PolicyMeaning& meaning, const std::string& value, Diagnostics& diagnostics) {
    if (!meaning.own)
        diagnostics.push_back(result_diagnostic(
            "RES0302", fmt::format("{} does not use this unit: {} keeps its physical meaning", policy.name, value)));
    else if (std::abs(meaning.emitted_over_said - 1.0) > 1e-12)
        diagnostics.push_back(
            result_diagnostic("RES0301",
                              fmt::format("{} emits {} times the flux that {} says: {}", policy.name,
                                          rounded(meaning.emitted_over_said, 4), value, meaning.formula),
                              fmt::format("from {}", policy.source)));
}

Result<void> solve(const UnitsRequest& request, const Emission& emitted, UnitsAnswer& result) {
    const PhotometricValue& target = *request.solve;
    const double lux = target.unit.unit->dimension == Dimension::illuminance_ev
                           ? illuminance(EvLux(target.number)).value
                           : target.number * target.unit.unit->base_per_unit;
    if (!target.unit.distance) {
        Result<Meters> distance = distance_of(result.shape, emitted, Lux(lux));
        if (!distance) return pass_on(distance);
        result.distance = *distance;
        return {};
    }
    Result<Emission> needed = emission_of(result.shape, target);
    if (!needed) return pass_on(needed);
    Result<double> lumens = express(result.shape, *needed, {find_unit("lm"), std::nullopt, std::nullopt});
    if (!lumens) return pass_on(lumens);
    result.needed_lumens = *lumens;
    if (emitted.intensity.value > 0.0) result.needed_factor = needed->intensity / emitted.intensity;
    return {};
}

} // namespace

Result<UnitsAnswer> read_question(std::string_view row, const UnitsRequest& request) {
    UnitsAnswer read;
    const std::size_t comma = row.find(',');
    read.value_text = trimmed(row.substr(0, comma));
    read.shape_text = comma == std::string_view::npos ? request.shape : std::string(trimmed(row.substr(comma + 1)));
    Result<PhotometricValue> value = parse_photometric_value(read.value_text);
    if (!value) return pass_on(value);
    read.value = *value;
    Result<std::optional<Primitive>> surface = parse_surface_size(read.shape_text);
    if (!surface) return pass_on(surface);
    if (*surface) {
        if (const std::optional<Shape> light = light_shape(**surface))
            read.shape = *light;
        else
            read.surface = *surface;
        return read;
    }
    Result<Shape> shape = parse_shape(read.shape_text);
    if (!shape) return pass_on(shape);
    read.shape = std::move(*shape);
    if (Result<void> loaded = load_profile(read.shape, read.diagnostics); !loaded) return pass_on(loaded);
    return read;
}

Result<UnitsRequest> units_request(const Arguments& arguments) {
    UnitsRequest request;
    request.shape = arguments.value("--shape").value_or("point");
    if (const auto list = arguments.value("--to")) request.wanted = split_at_commas(*list);
    const std::string policy = arguments.value("--policy").value_or("physical");
    Result<std::vector<const Policy*>> found = find_all_named("policy", policy, policies(), "all");
    if (!found) return pass_on(found);
    request.policies = std::move(*found);
    if (request.policies.size() == 1) request.policy = request.policies.front();
    if (const auto text = arguments.value("--for")) {
        for (const std::string_view option : {"--policy", "--to", "--solve", "--assume", "--explain", "--csv"})
            if (arguments.has(option))
                return fail("USE0107", fmt::format("--for and {} are both given", option),
                            "--for prints what to type; --policy and --to convert numbers");
        const std::vector<const Policy*> known = programs_with_fields();
        const auto programs = find_all_named("program", *text, known, "all");
        if (!programs) return Unexpected(programs.error());
        for (const Policy* const* const program : *programs)
            request.programs.push_back(*program);
    }
    if (const auto text = arguments.value("--assume")) {
        Result<Shape> assumed = parse_shape(*text);
        if (!assumed) return pass_on(assumed);
        if (class_of(*assumed) != ShapeClass::area)
            return fail("USE0105", fmt::format("--assume takes a shape with an area, not '{}'", *text),
                        "for example --assume sphere:r=1cm");
        request.assumed = std::move(*assumed);
    }
    if (const auto text = arguments.value("--solve")) {
        Result<PhotometricValue> target = parse_photometric_value(*text);
        if (!target) return pass_on(target);
        const Dimension dimension = target->unit.unit->dimension;
        if (dimension != Dimension::illuminance && dimension != Dimension::illuminance_ev)
            return fail("USE0105", fmt::format("--solve takes an illuminance, not '{}'", *text),
                        "0.1lx asks for a distance, 500lx@2m for a flux");
        request.solve = *target;
    }
    request.explain = arguments.has("--explain");
    return request;
}

// Between units of luminance, and of illuminance, no shape is needed: 13ev is 1024 nt of anything. False: it is.
Result<bool> answer_without_shape(const UnitsRequest& request, UnitsAnswer& result) {
    if (request.solve || request.policy != &policies().front()) return false;
    const bool has_no_such_unit = class_of(result.shape) == ShapeClass::punctual && !request.assumed;
    const std::vector<std::string> others = units_of_same_quantity(result.value.unit);
    if (request.wanted.empty() && !has_no_such_unit) return false;
    std::vector<Answer> answers;
    ConversionSteps steps;
    for (const std::string& text : request.wanted.empty() ? others : request.wanted) {
        Result<PhotometricUnit> unit = parse_photometric_unit(text);
        if (!unit) return pass_on(unit);
        if (!same_quantity(result.value.unit, *unit)) return false;
        Result<double> number = convert_unit(result.value, *unit, answers.empty() ? &steps : nullptr);
        if (!number) return pass_on(number);
        answers.push_back({*unit, *number});
    }
    if (answers.empty()) return false;
    result.answers = std::move(answers);
    result.steps = std::move(steps);
    return true;
}

Result<void> refuse_surface(const UnitsAnswer& question, std::string_view asked) {
    if (!question.surface) return {};
    return fail("USE0107", fmt::format("{} is for lights, and a box is a surface of a stage that emits", asked),
                "convert its amount with --to alone");
}

Result<void> answer_for_surface(const UnitsRequest& request, UnitsAnswer& result) {
    Result<void> plain;
    if (request.solve) plain = refuse_surface(result, "--solve");
    if (request.policy != &policies().front()) plain = refuse_surface(result, "--policy");
    if (!plain) return plain;
    Result<Nits> luminance = emitted_luminance(*result.surface, result.value, &result.steps);
    if (!luminance) return pass_on(luminance);
    constexpr std::array usual{"lm", "nt", "ev"};
    for (const std::string& text :
         request.wanted.empty() ? std::vector<std::string>(usual.begin(), usual.end()) : request.wanted) {
        Result<PhotometricUnit> unit = parse_photometric_unit(text);
        if (!unit) return pass_on(unit);
        Result<double> number = express_emission(*result.surface, *luminance, *unit, &result.steps);
        if (!number) return pass_on(number);
        result.answers.push_back({*unit, *number});
    }
    return {};
}

Result<UnitsAnswer> answer(std::string_view row, const UnitsRequest& request) {
    Result<UnitsAnswer> read = read_question(row, request);
    if (!read) return read;
    UnitsAnswer& result = *read;
    result.policy = request.policy;
    if (result.surface) {
        if (Result<void> answered = answer_for_surface(request, result); !answered) return pass_on(answered);
        return read;
    }
    Result<bool> answered = answer_without_shape(request, result);
    if (!answered) return pass_on(answered);
    if (*answered) return read;
    ProgramShape shown = program_shape(*request.policy, result.shape);
    result.shape = std::move(shown.shape);
    Result<PolicyMeaning> meaning = policy_meaning(*request.policy, result.shape, result.value.unit.unit->dimension);
    if (!meaning) return pass_on(meaning);
    warn(*request.policy, *meaning, result.value_text, result.diagnostics);
    if (!shown.note.empty())
        result.diagnostics.push_back(result_diagnostic(
            "RES0303", fmt::format("{} does not have this spot: {}", request.policy->name, shown.note)));

    Result<Emission> emitted = emission(result.shape, physical_value(*meaning, result.value), request, &result.steps);
    if (!emitted) return pass_on(emitted);
    Result<std::vector<PhotometricUnit>> units = wanted_units(request, result.shape);
    if (!units) return pass_on(units);
    for (const PhotometricUnit& unit : *units) {
        Result<double> number = express_as(result.shape, *emitted, unit, request, &result.steps);
        if (!number) return pass_on(number);
        Result<PolicyMeaning> own = policy_meaning(*request.policy, result.shape, unit.unit->dimension);
        if (!own) return pass_on(own);
        result.answers.push_back({unit, policy_number(*own, unit, *number)});
    }
    if (request.solve)
        if (Result<void> solved = solve(request, *emitted, result); !solved) return pass_on(solved);
    return read;
}

Result<PolicyTable> policy_table(std::string_view row, const UnitsRequest& request) {
    Result<UnitsAnswer> read = read_question(row, request);
    if (!read) return pass_on(read);
    if (Result<void> light = refuse_surface(*read, "--policy"); !light) return pass_on(light);
    PolicyTable table{std::move(*read), {}};
    const UnitsAnswer& question = table.question;
    Result<std::vector<PhotometricUnit>> units = wanted_units(request, question.shape);
    if (!units) return pass_on(units);
    for (const Policy* const policy : request.policies) {
        PolicyRow made;
        made.policy = policy;
        const ProgramShape shown = program_shape(*policy, question.shape);
        Result<PolicyMeaning> meaning = policy_meaning(*policy, shown.shape, question.value.unit.unit->dimension);
        if (!meaning && meaning.error().failure != Failure::unsupported) return pass_on(meaning);
        if (!meaning) {
            made.lacks = meaning.error().diagnostics.back().message;
            table.rows.push_back(std::move(made));
            continue;
        }
        made.meaning = *meaning;
        if (!shown.note.empty()) made.meaning.note += (made.meaning.note.empty() ? "" : "; ") + shown.note;
        Result<Emission> emitted = emission(shown.shape, physical_value(*meaning, question.value), request, nullptr);
        if (!emitted) return pass_on(emitted);
        for (const PhotometricUnit& unit : *units) {
            Result<double> number = express_as(shown.shape, *emitted, unit, request, nullptr);
            if (!number) return pass_on(number);
            made.answers.push_back({unit, *number});
        }
        table.rows.push_back(std::move(made));
    }
    return table;
}

} // namespace gonio::cli
