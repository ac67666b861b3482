#include "request.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace gonio::cli {

namespace {

// A part of a formula: its option and the word for it.
struct Part {
    std::string_view ShaderFormula::*member;
    std::string_view option;
    std::string_view word;
};

constexpr std::array parts{
    Part{&ShaderFormula::light, "--light", "light"},
    Part{&ShaderFormula::method, "--method", "method"},
    Part{&ShaderFormula::material, "--material", "material"},
    Part{&ShaderFormula::shadow_of, "--shadow-of", "occluder"},
};

using Values = std::vector<std::string_view>;

// What an option asks for; one empty name if it is not given.
Result<Values> values_of(const Arguments& arguments, const Part& part, const Values& known) {
    const auto given = arguments.value(part.option);
    if (!given) return Values{std::string_view()};
    auto found = find_all_named(part.word, *given, known);
    if (!found) return pass_on(found);
    Values values;
    for (const auto& each : *found)
        values.push_back(*each);
    return values;
}

// What is computed, if no option says it.
std::string_view usual_what(const Arguments& arguments) {
    if (arguments.has("--shadow-of")) return "visibility";
    if (!arguments.has("--material")) return "irradiance";
    return arguments.has("--light") ? "shade" : "brdf";
}

// The first formula of the list that has these parts. A part that is not asked for may be any method, as the first of a
// light is its usual one; the other parts are then empty.
bool answers(const ShaderFormula& formula, const ShaderFormula& asked) {
    return formula.what == asked.what && formula.light == asked.light && formula.material == asked.material &&
           formula.shadow_of == asked.shadow_of && (asked.method.empty() || formula.method == asked.method);
}

std::string in_words(const ShaderFormula& asked) {
    return fmt::format("--what {}{}{}", asked.what, asked.light.empty() && asked.material.empty() ? "" : " ",
                       shader_options_of({{}, asked.light, asked.method, asked.material, asked.shadow_of}));
}

// Those that have most in common with what is asked for.
std::string nearest(const ShaderFormula& asked) {
    const auto alike = [&](const ShaderFormula& formula) {
        return (formula.what == asked.what ? 8 : 0) + (!asked.light.empty() && formula.light == asked.light ? 4 : 0) +
               (!asked.material.empty() && formula.material == asked.material ? 2 : 0) +
               (!asked.method.empty() && formula.method == asked.method ? 1 : 0);
    };
    int most = 0;
    for (std::size_t i = 0; i < shader_formula_count(); ++i)
        most = std::max(most, alike(shader_formula(i).formula));
    std::string list;
    for (std::size_t i = 0; i < shader_formula_count(); ++i) {
        const ShaderFormula& formula = shader_formula(i).formula;
        if (alike(formula) == most) list += (list.empty() ? "" : "; ") + shader_options_of(formula);
    }
    return list;
}

bool any_formula(const auto& condition) {
    for (std::size_t i = 0; i < shader_formula_count(); ++i)
        if (condition(shader_formula(i).formula)) return true;
    return false;
}

// With several kinds of results each takes those options that it has: irradiance has no material. Of the methods, a
// kind takes those that it has for this light and material, and its usual one if it has none of them. Directions are
// drawn for a light or for a material.
std::vector<ShaderFormula> fitting(ShaderFormula asked, const Values& methods) {
    if ((asked.what == "sample" || asked.what == "pdf") && !asked.light.empty() && !asked.material.empty())
        return {{asked.what, asked.light, {}, {}, {}}, {asked.what, {}, {}, asked.material, {}}};
    for (const Part& part : parts)
        if (!any_formula([&](const ShaderFormula& formula) {
                return formula.what == asked.what && !(formula.*part.member).empty();
            }))
            asked.*part.member = {};
    const auto is_answered = [&](std::string_view method) {
        ShaderFormula with = asked;
        with.method = method;
        return any_formula([&](const ShaderFormula& formula) { return answers(formula, with); });
    };
    if (is_answered(asked.method)) return {asked};
    if (std::any_of(methods.begin(), methods.end(), is_answered)) return {}; // another serves this kind
    asked.method = {};
    return {asked};
}

// What is asked for and no printed function has.
std::optional<Unexpected> ignored(const ShaderRequest& request, const std::array<Values, parts.size()>& chosen) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (const std::string_view value : chosen[i]) {
            if (value.empty() || std::any_of(request.formulas.begin(), request.formulas.end(), [&](std::size_t place) {
                    return shader_formula(place).formula.*parts[i].member == value;
                }))
                continue;
            return fail("USE0107",
                        fmt::format("none of the functions that --what asks for has {} {}", parts[i].option, value),
                        "leave it out, or see gonio shader --help");
        }
    return std::nullopt;
}

Result<std::size_t> find_formula(const ShaderFormula& asked) {
    for (std::size_t i = 0; i < shader_formula_count(); ++i)
        if (answers(shader_formula(i).formula, asked)) return i;
    return fail("USE0107", fmt::format("there is no shader for {}", in_words(asked)),
                fmt::format("there are: {}", nearest(asked)));
}

} // namespace

std::vector<std::string_view> shader_values(std::string_view ShaderFormula::*part) {
    Values values;
    for (std::size_t i = 0; i < shader_formula_count(); ++i) {
        const std::string_view value = shader_formula(i).formula.*part;
        if (!value.empty() && std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
    }
    return values;
}

std::string shader_options_of(const ShaderFormula& formula) {
    std::string text;
    if (formula.what == "sample" || formula.what == "pdf" || formula.what == "roughness")
        text = fmt::format("--what {}", formula.what);
    for (const Part& part : parts) {
        const std::string_view value = formula.*part.member;
        if (value.empty()) continue;
        if (part.member == &ShaderFormula::method && formula.light.empty()) continue; // there is one
        text += fmt::format("{}{} {}", text.empty() ? "" : " ", part.option, value);
    }
    return text;
}

Result<ShaderRequest> shader_request(const Arguments& arguments) {
    if (!arguments.positional().empty())
        return fail("USE0105",
                    fmt::format("gonio shader takes options alone, not '{}'", arguments.positional().front()));
    ShaderRequest request;
    if (const auto text = arguments.value("--lang")) {
        auto language = find_named("shading language", *text, shader_languages());
        if (!language) return pass_on(language);
        request.language = (*language)->language;
    }
    if (const auto text = arguments.value("--branches")) {
        constexpr std::array kinds{Named{"real", ShaderBranches::real}, Named{"select", ShaderBranches::select}};
        Result<ShaderBranches> branches = find_value("kind of branch", *text, kinds);
        if (!branches) return pass_on(branches);
        request.branches = *branches;
    }
    Values whats{usual_what(arguments)};
    if (const auto text = arguments.value("--what")) {
        const Values known_whats = shader_values(&ShaderFormula::what);
        auto found = find_all_named("kind of shader", *text, known_whats);
        if (!found) return pass_on(found);
        whats.clear();
        for (const auto& each : *found)
            whats.push_back(*each);
    }
    std::array<Values, parts.size()> known;
    std::array<Values, parts.size()> chosen;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        known[i] = shader_values(parts[i].member);
        Result<Values> values = values_of(arguments, parts[i], known[i]);
        if (!values) return pass_on(values);
        chosen[i] = std::move(*values);
    }
    if (!arguments.has("--light") && !arguments.has("--material") && !arguments.has("--shadow-of"))
        return fail("USE0104", "no light, material or occluder is given",
                    "for example: gonio shader --light sphere, gonio shader --material gltf, "
                    "gonio shader --shadow-of capsule");
    for (const std::string_view what : whats)
        for (const std::string_view light : chosen[0])
            for (const std::string_view method : chosen[1])
                for (const std::string_view material : chosen[2])
                    for (const std::string_view shadow_of : chosen[3]) {
                        const ShaderFormula asked{what, light, method, material, shadow_of};
                        const std::vector<ShaderFormula> fits =
                            whats.size() > 1 ? fitting(asked, chosen[1]) : std::vector{asked};
                        for (const ShaderFormula& each : fits) {
                            Result<std::size_t> place = find_formula(each);
                            if (!place) return pass_on(place);
                            if (std::find(request.formulas.begin(), request.formulas.end(), *place) ==
                                request.formulas.end())
                                request.formulas.push_back(*place);
                        }
                    }
    if (auto error = ignored(request, chosen)) return *error;
    return request;
}

} // namespace gonio::cli
