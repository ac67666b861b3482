#include <gonio/base/text.hpp>
#include <gonio/light/efficacy.hpp>
#include <gonio/light/photometric_value.hpp>

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

namespace gonio {

namespace {

bool photometric(Dimension dimension) {
    switch (dimension) {
    case Dimension::luminous_flux:
    case Dimension::luminous_intensity:
    case Dimension::illuminance:
    case Dimension::illuminance_ev:
    case Dimension::luminance:
    case Dimension::luminance_ev:
    case Dimension::power:
        return true;
    default:
        return false;
    }
}

bool needs_distance(Dimension dimension) {
    return dimension == Dimension::illuminance || dimension == Dimension::illuminance_ev;
}

Result<std::optional<Meters>> parse_distance(const Unit& unit, std::optional<std::string_view> text) {
    if (!needs_distance(unit.dimension)) {
        if (text)
            return fail("USE0107",
                        fmt::format("'{}' does not take a distance, but '@{}' is given", unit.symbol, *text));
        return std::optional<Meters>();
    }
    if (!text) return std::optional<Meters>();
    Result<double> meters = parse_amount(*text, Dimension::length, "the distance of an illuminance");
    if (!meters) return pass_on(meters);
    if (!(*meters > 0.0))
        return fail("USE0106", fmt::format("the distance of an illuminance must be greater than 0, not {}", *text));
    return std::optional<Meters>(Meters(*meters));
}

// What follows the '@' of a unit, if anything.
Result<PhotometricUnit> complete_unit(const Unit& unit, std::optional<std::string_view> behind_at,
                                      std::string_view text, FileScope* files) {
    PhotometricUnit complete{&unit, std::nullopt, std::nullopt, {}};
    if (unit.dimension == Dimension::power) {
        if (!behind_at)
            return fail("USE0104", fmt::format("'{}' does not state the lumens per watt", text),
                        fmt::format("for example {0}@90lm/W, or {0}@ and one of 'gonio list efficacies'", text));
        Result<Efficacy> efficacy = parse_efficacy(*behind_at, files);
        if (!efficacy) return pass_on(efficacy);
        complete.efficacy_lm_per_w = efficacy->lm_per_w;
        complete.efficacy_of = std::move(efficacy->of);
        return complete;
    }
    Result<std::optional<Meters>> distance = parse_distance(unit, behind_at);
    if (!distance) return pass_on(distance);
    complete.distance = *distance;
    return complete;
}

// Lumens of a lamp that is sold as the equal of an incandescent lamp, by its watts: Commission Regulation (EU) No
// 874/2012, Annex VII, which interpolates linearly in between.
struct Equivalent {
    double watts;
    double lumens;
};
constexpr std::array equivalents{Equivalent{15.0, 136.0},   Equivalent{25.0, 249.0},  Equivalent{40.0, 470.0},
                                 Equivalent{60.0, 806.0},   Equivalent{75.0, 1055.0}, Equivalent{100.0, 1521.0},
                                 Equivalent{150.0, 2452.0}, Equivalent{200.0, 3452.0}};
constexpr std::string_view equivalent_unit = "Weq";

// "60Weq" is 806 lm.
Result<PhotometricValue> parse_equivalent(std::string_view text) {
    const std::optional<double> watts = parse_number(trimmed(text.substr(0, text.size() - equivalent_unit.size())));
    if (!watts) return fail("USE0105", fmt::format("'{}' is not a number of watts", text), "write for example 60Weq");
    if (!(*watts >= equivalents.front().watts && *watts <= equivalents.back().watts))
        return fail("USE0106",
                    fmt::format("'{}': incandescent lamps to compare with have {} to {} W", text,
                                equivalents.front().watts, equivalents.back().watts),
                    "give the lumens, for example 800lm");
    std::size_t i = 1;
    while (*watts > equivalents[i].watts)
        ++i;
    const Equivalent& low = equivalents[i - 1];
    const Equivalent& high = equivalents[i];
    const double share = (*watts - low.watts) / (high.watts - low.watts);
    return PhotometricValue{low.lumens + share * (high.lumens - low.lumens), {find_unit("lm"), {}, {}, {}}};
}

constexpr const char* amounts_of_light = "lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL or W@EFFICACY";

std::optional<std::string_view> behind(std::string_view text, std::size_t at) {
    return at == std::string_view::npos ? std::optional<std::string_view>() : text.substr(at + 1);
}

} // namespace

Result<PhotometricUnit> parse_photometric_unit(std::string_view text) {
    const std::size_t at = text.find('@');
    const std::string_view symbol = text.substr(0, at);
    const Unit* unit = find_unit(symbol);
    if (symbol.empty())
        return fail("USE0104", fmt::format("'{}' does not have a unit", text), "for example nt or lx@2m");
    if (unit == nullptr) {
        if (const Result<Amount> amount = parse_amount(symbol))
            return fail("USE0105", fmt::format("expected a unit, found the amount '{}'", symbol),
                        fmt::format("write '{}'", amount->unit->symbol));
        const Result<Amount> amount = parse_amount(fmt::format("1{}", symbol));
        return fail("USE0103", fmt::format("unknown unit '{}'", symbol),
                    amount ? std::string("gonio list units shows them all") : amount.error().diagnostics.back().hint);
    }
    if (!photometric(unit->dimension))
        return fail("USE0105",
                    fmt::format("'{}' is a unit of {}, not of light", symbol, dimension_name(unit->dimension)),
                    "use lm, cd, lx@2m, nt, ev, evlx@2m, fc@6ft, fL or W@90lm/W");
    return complete_unit(*unit, behind(text, at), text, nullptr);
}

Result<PhotometricValue> parse_photometric_value(std::string_view text, FileScope* files) {
    if (text.ends_with(equivalent_unit)) return parse_equivalent(text);
    const std::size_t at = text.find('@');
    Result<Amount> amount = parse_amount(text.substr(0, at));
    if (!amount) {
        // Without a unit or a number, the hint lists the existing amounts.
        std::string& hint = amount.error().diagnostics.back().hint;
        if (hint.starts_with("write for example")) hint += fmt::format("; there are {}", amounts_of_light);
        return pass_on(amount);
    }
    const Unit& unit = *amount->unit;

    const bool logarithmic = unit.dimension == Dimension::luminance_ev || unit.dimension == Dimension::illuminance_ev;
    if (!logarithmic && amount->number < 0.0)
        return fail("USE0106", fmt::format("'{}' is negative, but light is never negative", text));
    if (!photometric(unit.dimension))
        return fail("USE0105",
                    fmt::format("'{}' is a {}, not an amount of light", text, dimension_name(unit.dimension)),
                    fmt::format("give {}", amounts_of_light));
    Result<PhotometricUnit> complete = complete_unit(unit, behind(text, at), text, files);
    if (!complete) return pass_on(complete);
    return PhotometricValue{amount->number, *complete};
}

} // namespace gonio
