#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

// The constants of a shape between its intensity and everything else.
struct Emitter {
    double flux_per_candela = 4.0 * pi;    // Φ/I [sr]
    const char* flux_formula = "Φ = 4π I"; //
    std::optional<double> projected_area;  // I/L [m²], nothing where luminance has no meaning
    const char* area_formula = "";         //
    std::string no_luminance;              // why not, and what would help
    double axial_share = 1.0;              // intensity towards the receiver of an illuminance, over I
    double nearest_m = 0.0;                // a distance below this is inside the shape
};

Result<Emitter> emitter_of(const Shape& shape) {
    Emitter emitter;
    if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
        const double r = sphere->radius.value;
        emitter.projected_area = pi * r * r;
        emitter.area_formula = "I = π r² L";
        emitter.nearest_m = r;
        return emitter;
    }
    if (const auto* profile = std::get_if<ProfileShape>(&shape)) {
        if (!profile->web) return fail(Failure::internal, "the profile of this shape was not loaded");
        const Candelas top = peak(*profile->web).intensity;
        if (!(top.value > 0.0))
            return fail(Failure::usage, "this profile emits no light, so nothing can be scaled to it", {},
                        profile->file);
        emitter.flux_per_candela = flux(*profile->web).value / top.value;
        emitter.flux_formula = "Φ = (Φ_web / I_peak) I";
        emitter.axial_share = profile->web->candela(0.0, 0.0) / top.value;
        emitter.no_luminance = "a profile is a point that emits by direction: it has no area, so no luminance";
        return emitter;
    }
    emitter.no_luminance = "a point has no area, so no luminance";
    return emitter;
}

// A step that several answers share is said once.
void note(ConversionSteps* steps, std::string formula, double value, const char* unit) {
    if (steps == nullptr) return;
    for (const ConversionStep& step : *steps)
        if (step.formula == formula) return;
    steps->push_back({std::move(formula), value, unit});
}

Unexpected luminance_refused(const Emitter& emitter) {
    return fail(Failure::usage, emitter.no_luminance, "give it a size, for example --shape sphere:r=1cm");
}

Result<void> check_distance(const Emitter& emitter, const PhotometricUnit& unit) {
    if (unit.distance->value < emitter.nearest_m)
        return fail(Failure::usage,
                    fmt::format("a distance of {} m is inside the sphere of radius {} m", unit.distance->value,
                                emitter.nearest_m),
                    "the distance counts from the centre");
    return {};
}

bool photometric(Dimension dimension) {
    switch (dimension) {
    case Dimension::luminous_flux:
    case Dimension::luminous_intensity:
    case Dimension::illuminance:
    case Dimension::illuminance_ev:
    case Dimension::luminance:
    case Dimension::luminance_ev:
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
            return fail(Failure::usage, fmt::format("'{}' takes no distance, but '@{}' is given", unit.symbol, *text));
        return std::optional<Meters>();
    }
    if (!text)
        return fail(Failure::usage, fmt::format("an illuminance in {} needs the distance of the receiver", unit.symbol),
                    fmt::format("write for example {}@2m", unit.symbol));
    Result<double> meters = parse_amount(*text, Dimension::length, "the distance of an illuminance");
    if (!meters) return pass_on(meters);
    if (!(*meters > 0.0))
        return fail(Failure::usage,
                    fmt::format("the distance of an illuminance must be greater than 0, not {}", *text));
    return std::optional<Meters>(Meters(*meters));
}

// "90lm/W" or a bare number.
Result<double> parse_efficacy(std::string_view text) {
    std::string_view number = text;
    if (number.ends_with("lm/W")) number.remove_suffix(4);
    const std::optional<double> value = parse_number(number);
    if (!value || !(*value > 0.0) || *value > 683.01)
        return fail(Failure::usage, fmt::format("'{}' is no luminous efficacy", text),
                    "write for example 60W@90lm/W; no light exceeds 683 lm/W");
    return *value;
}

} // namespace

Result<PhotometricUnit> parse_photometric_unit(std::string_view text) {
    const std::size_t at = text.find('@');
    const std::string_view symbol = text.substr(0, at);
    const Unit* unit = find_unit(symbol);
    if (symbol.empty())
        return fail(Failure::usage, fmt::format("no unit stands in '{}'", text), "write for example nt or lx@2m");
    if (unit == nullptr) {
        std::string with_number("1");
        with_number += symbol;
        Result<Amount> amount = parse_amount(with_number);
        if (amount) return fail(Failure::internal, "a unit was found that does not exist");
        return fail(Failure::usage, fmt::format("unknown unit '{}'", symbol), amount.error().diagnostics.back().hint);
    }
    if (!photometric(unit->dimension))
        return fail(Failure::usage,
                    fmt::format("'{}' is a unit of {}, not of light", symbol, dimension_name(unit->dimension)),
                    "use lm, cd, lx@2m, nt, ev, evlx@2m, fc@6ft or fL");
    const auto distance_text = at == std::string_view::npos ? std::optional<std::string_view>() : text.substr(at + 1);
    Result<std::optional<Meters>> distance = parse_distance(*unit, distance_text);
    if (!distance) return pass_on(distance);
    return PhotometricUnit{unit, *distance};
}

Result<PhotometricValue> parse_photometric_value(std::string_view text) {
    const std::size_t at = text.find('@');
    Result<Amount> amount = parse_amount(text.substr(0, at));
    if (!amount) return pass_on(amount);
    const Unit& unit = *amount->unit;
    const auto behind_at = at == std::string_view::npos ? std::optional<std::string_view>() : text.substr(at + 1);

    const bool logarithmic = unit.dimension == Dimension::luminance_ev || unit.dimension == Dimension::illuminance_ev;
    if (!logarithmic && amount->number < 0.0)
        return fail(Failure::usage, fmt::format("'{}' is negative: there is no negative light", text));
    PhotometricValue value{amount->number, {&unit, std::nullopt}, std::nullopt};
    if (unit.dimension == Dimension::power) {
        if (!behind_at)
            return fail(Failure::usage, fmt::format("'{}' does not say how many lumens a watt gives", text),
                        fmt::format("write for example {}@90lm/W", text));
        Result<double> efficacy = parse_efficacy(*behind_at);
        if (!efficacy) return pass_on(efficacy);
        value.efficacy_lm_per_w = *efficacy;
        return value;
    }
    if (!photometric(unit.dimension))
        return fail(Failure::usage,
                    fmt::format("'{}' is a {}, not an amount of light", text, dimension_name(unit.dimension)),
                    "give lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL or W@EFFICACY");
    Result<std::optional<Meters>> distance = parse_distance(unit, behind_at);
    if (!distance) return pass_on(distance);
    value.unit.distance = *distance;
    return value;
}

Result<Candelas> intensity_of(const Shape& shape, const PhotometricValue& value, ConversionSteps* steps) {
    Result<Emitter> made = emitter_of(shape);
    if (!made) return pass_on(made);
    const Emitter& emitter = *made;
    const double base = value.number * value.unit.unit->base_per_unit;
    const Dimension dimension = value.unit.unit->dimension;

    if (dimension == Dimension::luminous_intensity) return Candelas(base);
    if (dimension == Dimension::luminous_flux || dimension == Dimension::power) {
        double lumens = base;
        if (value.efficacy_lm_per_w) {
            lumens *= *value.efficacy_lm_per_w;
            note(steps, fmt::format("Φ = P · {} lm/W", *value.efficacy_lm_per_w), lumens, "lm");
        }
        if (!(emitter.flux_per_candela > 0.0))
            return fail(Failure::usage,
                        "the flux of this profile is not greater than 0, so it cannot be scaled to one");
        const double intensity = lumens / emitter.flux_per_candela;
        note(steps, fmt::format("I from {}", emitter.flux_formula), intensity, "cd");
        return Candelas(intensity);
    }
    if (dimension == Dimension::luminance || dimension == Dimension::luminance_ev) {
        if (!emitter.projected_area) return luminance_refused(emitter);
        double nits = base;
        if (dimension == Dimension::luminance_ev) {
            nits = luminance(Ev100(base)).value;
            note(steps, "L = 2^(EV−3)", nits, "nt");
        }
        const double intensity = nits * *emitter.projected_area;
        note(steps, emitter.area_formula, intensity, "cd");
        return Candelas(intensity);
    }
    if (Result<void> outside = check_distance(emitter, value.unit); !outside) return pass_on(outside);
    double lux = base;
    if (dimension == Dimension::illuminance_ev) {
        lux = illuminance(EvLux(base)).value;
        note(steps, "E = 2.5 · 2^EV", lux, "lx");
    }
    if (!(emitter.axial_share > 0.0))
        return fail(Failure::usage, "this profile emits nothing along γ = 0, so no illuminance there can set it",
                    "give its flux or its peak intensity instead");
    const double d = value.unit.distance->value;
    const double intensity = lux * d * d / emitter.axial_share;
    note(steps, emitter.axial_share == 1.0 ? "I = E d²" : "I_peak = E d² I_peak/I(γ=0)", intensity, "cd");
    return Candelas(intensity);
}

Result<double> express(const Shape& shape, Candelas intensity, const PhotometricUnit& unit, ConversionSteps* steps) {
    Result<Emitter> made = emitter_of(shape);
    if (!made) return pass_on(made);
    const Emitter& emitter = *made;
    const Dimension dimension = unit.unit->dimension;
    double base = intensity.value;
    if (dimension == Dimension::luminous_flux) {
        base *= emitter.flux_per_candela;
        note(steps, emitter.flux_formula, base, "lm");
    } else if (dimension == Dimension::luminance || dimension == Dimension::luminance_ev) {
        if (!emitter.projected_area) return luminance_refused(emitter);
        base /= *emitter.projected_area;
        note(steps, fmt::format("L from {}", emitter.area_formula), base, "nt");
    } else if (dimension == Dimension::illuminance || dimension == Dimension::illuminance_ev) {
        if (Result<void> outside = check_distance(emitter, unit); !outside) return pass_on(outside);
        const double d = unit.distance->value;
        base = base * emitter.axial_share / (d * d);
        note(steps, fmt::format("E = {}/d², d = {} m", emitter.axial_share == 1.0 ? "I" : "I(γ=0)", rounded(d)), base,
             "lx");
    }
    if (dimension == Dimension::luminance_ev || dimension == Dimension::illuminance_ev) {
        if (!(base > 0.0)) return fail(Failure::usage, fmt::format("no light has no {}", dimension_name(dimension)));
        base = dimension == Dimension::luminance_ev ? ev100(Nits(base)).value : ev_lux(Lux(base)).value;
        note(steps,
             dimension == Dimension::luminance_ev
                 ? std::string("EV = log2(L) + 3")
                 : fmt::format("EV = log2(E/2.5), d = {} m", rounded(unit.distance->value)),
             base, unit.unit->symbol.data());
    }
    const double number = base / unit.unit->base_per_unit;
    if (!std::isfinite(number))
        return fail(Failure::usage, fmt::format("the result in {} is too large for a number", unit.unit->symbol));
    return number;
}

} // namespace gonio
