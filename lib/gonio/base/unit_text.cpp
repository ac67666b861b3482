#include <gonio/base/charconv.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

using enum Dimension;

constexpr double foot = 0.3048;
constexpr double degree = std::numbers::pi / 180.0;

constexpr std::array units_table{
    Unit{"lm", "lumen", luminous_flux, 1.0},
    Unit{"klm", "kilolumen", luminous_flux, 1e3},
    Unit{"Mlm", "megalumen", luminous_flux, 1e6},
    Unit{"cd", "candela", luminous_intensity, 1.0},
    Unit{"mcd", "millicandela", luminous_intensity, 1e-3},
    Unit{"kcd", "kilocandela", luminous_intensity, 1e3},
    Unit{"lx", "lux", illuminance, 1.0},
    Unit{"klx", "kilolux", illuminance, 1e3},
    Unit{"fc", "foot-candle", illuminance, 1.0 / (foot * foot)},
    Unit{"nt", "nit", luminance, 1.0},
    Unit{"knt", "kilonit", luminance, 1e3},
    Unit{"cd/m2", "candela per square metre", luminance, 1.0},
    Unit{"fL", "foot-lambert", luminance, 1.0 / (std::numbers::pi * foot * foot)},
    Unit{"ev", "exposure value of a luminance, ISO 100, K = 12.5", luminance_ev, 1.0},
    Unit{"evlx", "exposure value of an illuminance, ISO 100, C = 250", illuminance_ev, 1.0},
    Unit{"W", "watt", power, 1.0},
    Unit{"mW", "milliwatt", power, 1e-3},
    Unit{"kW", "kilowatt", power, 1e3},
    Unit{"K", "kelvin", temperature, 1.0},
    Unit{"deg", "degree", angle, degree},
    Unit{"rad", "radian", angle, 1.0},
    Unit{"m", "metre", length, 1.0},
    Unit{"mm", "millimetre", length, 1e-3},
    Unit{"cm", "centimetre", length, 1e-2},
    Unit{"km", "kilometre", length, 1e3},
    Unit{"in", "inch", length, foot / 12.0},
    Unit{"ft", "foot", length, foot},
};

// What people write instead of a symbol. Case does not matter.
struct UnitWord {
    std::string_view word;
    std::string_view symbol;
};
constexpr std::array unit_words{
    UnitWord{"lumen", "lm"},        UnitWord{"lumens", "lm"},   UnitWord{"candela", "cd"},
    UnitWord{"candelas", "cd"},     UnitWord{"lux", "lx"},      UnitWord{"footcandle", "fc"},
    UnitWord{"footcandles", "fc"},  UnitWord{"nit", "nt"},      UnitWord{"nits", "nt"},
    UnitWord{"cd/m^2", "cd/m2"},    UnitWord{"cd/m²", "cd/m2"}, UnitWord{"footlambert", "fL"},
    UnitWord{"footlamberts", "fL"}, UnitWord{"watt", "W"},      UnitWord{"watts", "W"},
    UnitWord{"kelvin", "K"},        UnitWord{"degree", "deg"},  UnitWord{"degrees", "deg"},
    UnitWord{"°", "deg"},           UnitWord{"metre", "m"},     UnitWord{"metres", "m"},
    UnitWord{"meter", "m"},         UnitWord{"meters", "m"},    UnitWord{"inch", "in"},
    UnitWord{"inches", "in"},       UnitWord{"foot", "ft"},     UnitWord{"feet", "ft"},
};

// Reads the number at the front of `text` and removes it. from_chars refuses a leading '+'.
std::optional<double> take_number(std::string_view& text) {
    std::string_view rest = text;
    if (rest.size() > 1 && rest.front() == '+' && rest[1] != '-') rest.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = from_chars(rest.data(), rest.data() + rest.size(), value);
    // A result out of range is rejected like text that is not a number: nothing is clamped silently.
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    text = rest;
    return value;
}

// Whether the text begins with a number that a double cannot represent.
bool begins_beyond_range(std::string_view text) {
    double value = 0.0;
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    return from_chars(text.data(), text.data() + text.size(), value).ec == std::errc::result_out_of_range;
}

Unexpected beyond_range(std::string_view text) {
    return fail("USE0106", fmt::format("'{}' is out of the range of a number", text),
                "numbers go up to 1.7e308 and down to 4.9e-324");
}

std::string symbols_of(Dimension dimension) {
    std::string list;
    for (const Unit& unit : units_table) {
        if (unit.dimension != dimension) continue;
        if (!list.empty()) list += ", ";
        list += unit.symbol;
    }
    return list;
}

// "an angle", "a luminous flux"
std::string with_article(Dimension dimension) {
    const std::string_view name = dimension_name(dimension);
    return fmt::format("{} {}", std::string_view("aeio").find(name.front()) == std::string_view::npos ? "a" : "an",
                       name);
}

} // namespace

double Amount::in_base_units() const {
    // Neither 1.3 nor 1e-2 is a double, and their product is not the double nearest to 0.013. Parsing the number's
    // shortest decimal text with another exponent gives that double.
    const double power = std::log10(unit->base_per_unit);
    const double exponent = std::round(power);
    if (exponent == 0.0 || std::abs(power - exponent) > 1e-12) return number * unit->base_per_unit;
    const std::string digits = shortest(number);
    if (digits.find('e') != std::string::npos) return number * unit->base_per_unit;
    return parse_number(fmt::format("{}e{}", digits, static_cast<int>(exponent)))
        .value_or(number * unit->base_per_unit);
}

std::span<const Unit> all_units() {
    return units_table;
}

const Unit* find_unit(std::string_view symbol) {
    for (const Unit& unit : units_table)
        if (unit.symbol == symbol) return &unit;
    for (const UnitWord& word : unit_words)
        if (equals_any_case(word.word, symbol)) return find_unit(word.symbol);
    return nullptr;
}

std::string_view dimension_name(Dimension dimension) {
    switch (dimension) {
    case luminous_flux:
        return "luminous flux";
    case luminous_intensity:
        return "luminous intensity";
    case illuminance:
        return "illuminance";
    case luminance:
        return "luminance";
    case luminance_ev:
        return "exposure value of a luminance";
    case illuminance_ev:
        return "exposure value of an illuminance";
    case power:
        return "power";
    case temperature:
        return "temperature";
    case angle:
        return "angle";
    case length:
        break;
    }
    return "length";
}

Result<Amount> parse_amount(std::string_view text) {
    std::string_view rest = text;
    const std::optional<double> number = take_number(rest);
    if (!number && begins_beyond_range(text)) return beyond_range(text);
    if (!number)
        return fail("USE0105", fmt::format("'{}' is not a number with a unit", text), "write for example 800lm");
    while (rest.starts_with(' ')) // "800 lm"
        rest.remove_prefix(1);
    if (rest.empty())
        return fail("USE0105", fmt::format("'{}' has no unit", text), fmt::format("write for example {}lm", text));
    const Unit* unit = find_unit(rest);
    if (unit == nullptr) {
        std::vector<std::string_view> symbols;
        for (const Unit& known : units_table)
            symbols.push_back(known.symbol);
        const std::string_view guess = nearest(rest, symbols);
        return fail("USE0103", fmt::format("unknown unit '{}' in '{}'", rest, text),
                    guess.empty() ? "gonio list units shows them all" : fmt::format("did you mean '{}'?", guess));
    }
    const Amount amount{*number, unit};
    // No unit is as large as 1e10 of its base.
    if (std::abs(*number) > 1e290 && !std::isfinite(amount.in_base_units())) return beyond_range(text);
    return amount;
}

Result<double> parse_amount(std::string_view text, Dimension dimension, std::string_view what) {
    Result<Amount> amount = parse_amount(text);
    if (!amount) {
        error_hint(amount.error(),
                   fmt::format("{} is {}: use one of {}", what, with_article(dimension), symbols_of(dimension)));
        return pass_on(amount);
    }
    if (amount->unit->dimension != dimension)
        return fail("USE0105",
                    fmt::format("{} is {}, but '{}' is {}", what, with_article(dimension), text,
                                with_article(amount->unit->dimension)),
                    fmt::format("use one of {}", symbols_of(dimension)));
    return amount->in_base_units();
}

std::optional<double> parse_number(std::string_view text) {
    const std::optional<double> value = take_number(text);
    return text.empty() ? value : std::nullopt;
}

std::string shortest(double value) {
    return fmt::format("{}", value);
}

std::string rounded(double value, int digits) {
    return fmt::format("{:.{}g}", value, digits);
}

} // namespace gonio
