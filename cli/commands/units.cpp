#include <gonio/base/kind_text.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array unit_options{
    Option{"--shape", "SHAPE", "what emits the light (point)", "shapes"},
    Option{"--to", "UNIT,…", "units wanted: lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL", "units"},
    Option{"--policy", "NAME", "whose meaning of the numbers (physical)", "policies"},
    Option{"--explain", "", "show the formulas and the steps"},
};
constexpr std::array groups{OptionGroup{"conversion", unit_options}, json_group, common_group};
constexpr std::array examples{
    Example{"gonio units 800lm --shape sphere:r=3cm --to nt", "the luminance of an 800 lm bulb of 3 cm radius"},
    Example{"gonio units 300lx@2m --to lm,cd", "the point light that gives 300 lx at 2 m"},
    Example{"gonio units 60W@90lm/W --shape ies:lamp.ies --to cd,lx@3m", "a measured luminaire driven at 60 W"},
};

// One result, ready to print.
struct Answer {
    PhotometricUnit unit;
    double number = 0.0;
};

// What there is to say about a shape when nothing was asked for.
std::vector<std::string> usual_units(const Shape& shape) {
    struct Usual {
        static std::vector<std::string> punctual() { return {"lm", "cd", "lx@1m"}; }
        static std::vector<std::string> area() { return {"lm", "cd", "nt", "ev"}; }
        std::vector<std::string> operator()(const PointShape&) const { return punctual(); }
        std::vector<std::string> operator()(const SpotShape&) const { return punctual(); }
        std::vector<std::string> operator()(const FrustumShape&) const { return punctual(); }
        std::vector<std::string> operator()(const ProfileShape&) const { return punctual(); }
        std::vector<std::string> operator()(const SphereShape&) const { return area(); }
        std::vector<std::string> operator()(const DiskShape&) const { return area(); }
        std::vector<std::string> operator()(const RectShape&) const { return area(); }
        std::vector<std::string> operator()(const TubeShape&) const { return area(); }
        std::vector<std::string> operator()(const SunShape&) const { return {"lx", "nt", "ev"}; }
    };
    return std::visit(Usual{}, shape);
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

// The shortest degrees that are this angle: 40, where converting back gives 40.00000000000001.
double tidy_degrees(Radians angle) {
    const double exact = to_degrees(angle);
    const double tidy = parse_number(rounded(exact, 15)).value_or(exact);
    return degrees(tidy) == angle ? tidy : exact;
}

// The keys of each shape's grammar, with their units.
struct DescribeShape {
    Json& json;

    void operator()(const PointShape&) const {}
    void operator()(const SpotShape& spot) const {
        json["outer_deg"] = tidy_degrees(spot.outer);
        json["inner_deg"] = tidy_degrees(spot.inner);
        json["falloff"] = to_text(spot.falloff);
    }
    void operator()(const FrustumShape& frustum) const {
        json["h_deg"] = tidy_degrees(frustum.horizontal);
        json["v_deg"] = tidy_degrees(frustum.vertical);
    }
    void operator()(const ProfileShape& profile) const {
        json["file"] = profile.file;
        json["flux_lm"] = flux(*profile.web).value;
        json["peak_cd"] = peak(*profile.web).intensity.value;
    }
    void operator()(const SphereShape& sphere) const { json["r_m"] = sphere.radius.value; }
    void operator()(const DiskShape& disk) const {
        json["r_m"] = disk.radius.value;
        json["two_sided"] = disk.two_sided;
    }
    void operator()(const RectShape& rect) const {
        json["w_m"] = rect.width.value;
        json["h_m"] = rect.height.value;
        json["two_sided"] = rect.two_sided;
    }
    void operator()(const TubeShape& tube) const {
        json["r_m"] = tube.radius.value;
        json["l_m"] = tube.length.value;
    }
    void operator()(const SunShape& sun) const { json["angle_deg"] = tidy_degrees(sun.diameter); }
};

Json shape_json(const Shape& shape) {
    Json json{{"kind", kind_of(shape)}};
    std::visit(DescribeShape{json}, shape);
    if (const Mask mask = mask_of(shape); mask.file != nullptr) json["mask"] = *mask.file;
    return json;
}

std::string unit_text(const PhotometricUnit& unit) {
    std::string text(unit.unit->symbol);
    if (unit.distance) text += fmt::format("@{}m", shortest(unit.distance->value));
    return text;
}

Json report(const PhotometricValue& value, const std::string& given_unit, const Shape& shape,
            const std::vector<Answer>& answers, const ConversionSteps& steps, bool explain,
            const Diagnostics& diagnostics) {
    Json input{{"value", value.number}, {"unit", given_unit}};
    if (value.unit.distance) input["at_m"] = value.unit.distance->value;
    if (value.efficacy_lm_per_w) input["efficacy_lm_per_W"] = *value.efficacy_lm_per_w;
    Json results = Json::array();
    for (const Answer& answer : answers) {
        Json result{{"unit", answer.unit.unit->symbol}, {"value", answer.number}};
        if (answer.unit.distance) result["at_m"] = answer.unit.distance->value;
        results.push_back(std::move(result));
    }
    Json json{{"schema", "gonio.units/1"},
              {"input", std::move(input)},
              {"shape", shape_json(shape)},
              {"policy", "physical"},
              {"results", std::move(results)}};
    if (explain) {
        json["steps"] = Json::array();
        for (const ConversionStep& step : steps)
            json["steps"].push_back({{"formula", step.formula}, {"value", step.value}, {"unit", step.unit}});
    }
    json["diagnostics"] = diagnostics_json(diagnostics);
    return json;
}

Result<int> convert(const Arguments& arguments, Console& console) {
    if (arguments.positional().size() != 1)
        return fail(Failure::usage, fmt::format("one value is wanted, {} are given", arguments.positional().size()),
                    "for example: gonio units 800lm --shape sphere:r=3cm --to nt");
    const std::string policy = arguments.value("--policy").value_or("physical");
    if (policy != "physical") return unknown_name("policy", policy, std::array<std::string_view, 1>{"physical"});
    Result<PhotometricValue> value = parse_photometric_value(arguments.positional().front());
    if (!value) return pass_on(value);
    Result<Shape> shape = parse_shape(arguments.value("--shape").value_or("point"));
    if (!shape) return pass_on(shape);
    Diagnostics diagnostics;
    if (Result<void> loaded = load_profile(*shape, diagnostics); !loaded) return pass_on(loaded);

    std::vector<std::string> wanted;
    for (const std::string& list : arguments.values("--to"))
        for (std::string& unit : split_at_commas(list))
            wanted.push_back(std::move(unit));
    if (wanted.empty()) wanted = usual_units(*shape);

    ConversionSteps steps;
    Result<Emission> emission = emission_of(*shape, *value, &steps);
    if (!emission) return pass_on(emission);
    std::vector<Answer> answers;
    for (const std::string& text : wanted) {
        Result<PhotometricUnit> unit = parse_photometric_unit(text);
        if (!unit) return pass_on(unit);
        Result<double> number = express(*shape, *emission, *unit, &steps);
        if (!number) return pass_on(number);
        answers.push_back({*unit, *number});
    }
    console.say(diagnostics);

    const bool explain = arguments.has("--explain");
    if (arguments.has("--json") || arguments.has("--jsonl")) {
        const std::string unit(value->unit.unit->symbol);
        console.print(dump(report(*value, unit, *shape, answers, steps, explain, diagnostics),
                           arguments.has("--jsonl") ? -1 : 2));
        return 0;
    }
    if (explain)
        for (const ConversionStep& step : steps)
            console.print(fmt::format("# {:<28} = {} {}\n", step.formula, rounded(step.value, 9), step.unit));
    for (const Answer& answer : answers)
        console.print(fmt::format("{} {}\n", rounded(answer.number), unit_text(answer.unit)));
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = convert(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command units_command;
const Command units_command{
    "units",
    "convert lumens, candela, lux, nits and exposure values for a light's shape",
    "VALUE [--shape SHAPE] [--to UNIT,…]",
    "VALUE is a number with its unit: 800lm, 2.5klm, 1200cd, 300lx@2m, 20fc@6ft, 5000nt, 12ev, 60W@90lm/W.",
    groups,
    examples,
    run};

} // namespace gonio::cli
