#include <gonio/light/photometry.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gonio {

namespace {

// "90 lm/W", "330.1 lm/W (LED-B3, 380–780 nm)": a computed efficacy in five digits, a given one as it is.
std::string efficacy_text(const PhotometricUnit& unit) {
    const double lm_per_w = unit.efficacy_lm_per_w.value_or(0.0);
    if (unit.efficacy_of.empty()) return fmt::format("{} lm/W", lm_per_w);
    return fmt::format("{} lm/W ({})", rounded(lm_per_w, 5), unit.efficacy_of);
}

// Formats only if steps are wanted. A step shared by several answers is reported once.
template<class... Arguments>
void note(ConversionSteps* steps, double value, const char* unit, fmt::format_string<Arguments...> format,
          Arguments&&... arguments) {
    if (steps == nullptr) return;
    std::string formula = fmt::format(format, std::forward<Arguments>(arguments)...);
    for (const ConversionStep& step : *steps)
        if (step.formula == formula) return;
    steps->push_back({std::move(formula), value, unit});
}

void note_inverse_square(ConversionSteps* steps, const Shape& shape, double intensity, double lux, Meters distance) {
    if (steps == nullptr || inverse_square_is_exact(shape) || !(lux > 0.0)) return;
    const double d = distance.value;
    const double estimate = intensity / (d * d);
    note(steps, estimate, "lx", "I/d², the inverse square, d = {} m", rounded(d));
    note(steps, 100.0 * (estimate / lux - 1.0), "%", "(I/d²)/E − 1, its error, d = {} m", rounded(d));
}

Unexpected luminance_refused(const ShapeFactors& factors) {
    return fail(Failure::usage, factors.no_luminance,
                "give it a size: --shape sphere:r=1cm, or only for this result --assume sphere:r=1cm");
}

Unexpected no_flux_refused(const Shape& shape) {
    if (std::holds_alternative<ProfileShape>(shape))
        return fail(Failure::usage, "the flux of this profile is not greater than 0, so it cannot be scaled to one");
    if (!mask_of(shape).is_loaded() && std::holds_alternative<SpotShape>(shape))
        return fail(Failure::usage, "a spot with an outer angle of 0deg has no solid angle, so no flux fits in it",
                    "give it an intensity, for example 1000cd, or a wider angle");
    return fail(Failure::usage, "this shape emits no flux, so it cannot be scaled to one");
}

Unexpected sun_refused(const char* quantity) {
    return fail(Failure::usage, fmt::format("the sun is infinitely far away, so its {} is not defined", quantity),
                "its amount is an illuminance or a luminance: lx, evlx, fc, nt, ev or fL");
}

// E over the strength, after checking that the distance is meaningful for the shape.
Result<Factor> illuminance_factor(const Shape& shape, const ShapeFactors& factors, const PhotometricUnit& unit) {
    if (factors.at_infinity) {
        if (unit.distance)
            return fail("USE0107", "the sun is infinitely far away, so its illuminance takes no distance",
                        fmt::format("write {} alone", unit.unit->symbol));
        return facing_factor(shape, factors, Meters(0.0));
    }
    if (factors.luminance && mask_of(shape).is_loaded())
        return fail(Failure::unsupported,
                    fmt::format("the illuminance of a {} behind a mask does not have a closed form", kind_of(shape)),
                    "give lm, cd or nt; probe computes the illuminance");
    if (!unit.distance)
        return fail("USE0104",
                    fmt::format("an illuminance in {} needs the distance of the receiver", unit.unit->symbol),
                    fmt::format("for example {}@2m", unit.unit->symbol));
    if (unit.distance->value < factors.nearest_m)
        return fail("USE0106",
                    fmt::format("a distance of {} m is inside the {} of radius {} m", unit.distance->value,
                                kind_of(shape), factors.nearest_m),
                    "the distance is measured from the centre");
    return facing_factor(shape, factors, *unit.distance);
}

bool is_flux(Dimension dimension) {
    return dimension == Dimension::luminous_flux || dimension == Dimension::power;
}
bool is_luminance(Dimension dimension) {
    return dimension == Dimension::luminance || dimension == Dimension::luminance_ev;
}

// A quantity in base units (nt, lx, cd, lm, W), in another unit of it.
Result<double> in_unit(double base, const PhotometricUnit& unit, ConversionSteps* steps) {
    const Dimension dimension = unit.unit->dimension;
    if (dimension == Dimension::luminance_ev || dimension == Dimension::illuminance_ev) {
        if (!(base > 0.0))
            return fail(Failure::usage, fmt::format("the {} of 0 is not defined", dimension_name(dimension)));
        const bool of_luminance = dimension == Dimension::luminance_ev;
        base = of_luminance ? ev100(Nits(base)).value : ev_lux(Lux(base)).value;
        const char* const formula = of_luminance ? "EV = log2(L) + 3" : "EV = log2(E/2.5)";
        if (unit.distance)
            note(steps, base, unit.unit->symbol.data(), "{}, d = {} m", formula, rounded(unit.distance->value));
        else
            note(steps, base, unit.unit->symbol.data(), "{}", formula);
    }
    const double number = base / unit.unit->base_per_unit;
    if (!std::isfinite(number))
        return fail("USE0106", fmt::format("the result in {} is too large for a number", unit.unit->symbol));
    return number;
}

// Nits or lux of a luminance or an illuminance.
double in_base_unit(const PhotometricValue& value, ConversionSteps* steps) {
    const double base = value.number * value.unit.unit->base_per_unit;
    switch (value.unit.unit->dimension) {
    case Dimension::luminance_ev: {
        const double nits = luminance(Ev100(base)).value;
        note(steps, nits, "nt", "L = 2^(EV−3)");
        return nits;
    }
    case Dimension::illuminance_ev: {
        const double lux = illuminance(EvLux(base)).value;
        note(steps, lux, "lx", "E = 2.5 · 2^EV");
        return lux;
    }
    default:
        return base;
    }
}

Emission emission_of_strength(const ShapeFactors& factors, double strength) {
    Emission emission;
    if (factors.at_infinity)
        emission.illuminance = Lux(strength);
    else
        emission.intensity = Candelas(strength);
    if (factors.luminance) emission.luminance = Nits(strength / factors.luminance->value);
    return emission;
}

} // namespace

ShapePhotometry::ShapePhotometry(Shape shape, ShapeFactors factors) : shape_(std::move(shape)), factors_(factors) {}

Result<ShapePhotometry> ShapePhotometry::of(Shape shape) {
    Result<ShapeFactors> factors = shape_factors(shape);
    if (!factors) return pass_on(factors);
    // A subnormal factor has lost digits; an infinite one has lost all of them.
    if (factors->luminance && !std::isnormal(factors->luminance->value))
        return fail("USE0106", fmt::format("the size of this {} is out of the range of a number", kind_of(shape)));
    return ShapePhotometry(std::move(shape), *factors);
}

const Factor& ShapePhotometry::flux() {
    if (!flux_) flux_ = flux_factor(shape_, factors_);
    return *flux_;
}

Result<double> ShapePhotometry::strength_of(const PhotometricValue& value, ConversionSteps* steps) {
    const double base = value.number * value.unit.unit->base_per_unit;
    const Dimension dimension = value.unit.unit->dimension;
    const char* const strength_unit = factors_.at_infinity ? "lx" : "cd";
    const auto say = [&](const char* formula, double strength) {
        note(steps, strength, strength_unit, "{} from {}", factors_.strength, formula);
        return strength;
    };

    if (dimension == Dimension::luminous_intensity) {
        if (factors_.at_infinity) return sun_refused("intensity");
        if (!mask_of(shape_).is_loaded() || factors_.axial_share == 1.0) return base;
        if (!(factors_.axial_share > 0.0))
            return fail(Failure::usage, "this mask lets nothing through along γ = 0, so no intensity there can set it",
                        "give its flux instead");
        return say("I = mask(γ=0) I₀", base / factors_.axial_share);
    }
    if (is_flux(dimension)) {
        if (factors_.at_infinity) return sun_refused("flux");
        double lumens = base;
        if (value.unit.efficacy_lm_per_w) {
            lumens *= *value.unit.efficacy_lm_per_w;
            if (steps != nullptr) note(steps, lumens, "lm", "Φ = P · {}", efficacy_text(value.unit));
        }
        const Factor factor = flux();
        if (!(factor.value > 0.0)) return no_flux_refused(shape_);
        return say(factor.formula, lumens / factor.value);
    }
    if (is_luminance(dimension)) {
        if (!factors_.luminance) return luminance_refused(factors_);
        const double strength = in_base_unit(value, steps) * factors_.luminance->value;
        note(steps, strength, strength_unit, "{}", factors_.luminance->formula);
        return strength;
    }
    Result<Factor> factor = illuminance_factor(shape_, factors_, value.unit);
    if (!factor) return pass_on(factor);
    const double lux = in_base_unit(value, steps);
    if (factors_.at_infinity) return lux;
    if (!(factors_.axial_share > 0.0))
        return fail(Failure::usage,
                    std::holds_alternative<ProfileShape>(shape_)
                        ? "this profile emits nothing along γ = 0, so no illuminance there can set it"
                        : "this mask lets nothing through along γ = 0, so no illuminance there can set it",
                    std::holds_alternative<ProfileShape>(shape_) ? "give its flux or its peak intensity instead"
                                                                 : "give its flux instead");
    const double intensity = lux / factor->value;
    if (std::string_view(factor->formula) == "E = I/d²")
        note(steps, intensity, "cd", "I = E d²");
    else
        say(factor->formula, intensity);
    note_inverse_square(steps, shape_, intensity, lux, *value.unit.distance);
    return intensity;
}

Result<Emission> ShapePhotometry::emission_of(const PhotometricValue& value, ConversionSteps* steps) {
    Result<double> strength = strength_of(value, steps);
    if (!strength) return pass_on(strength);
    const Emission emission = emission_of_strength(factors_, *strength);
    if (!std::isfinite(*strength) || !std::isfinite(emission.luminance.value))
        return fail("USE0106", fmt::format("{} {} of this shape are out of the range of a number", value.number,
                                           value.unit.unit->symbol));
    return emission;
}

Result<double> ShapePhotometry::express(const Emission& emission, const PhotometricUnit& unit, ConversionSteps* steps) {
    const Dimension dimension = unit.unit->dimension;
    const double strength = factors_.at_infinity ? emission.illuminance.value : emission.intensity.value;
    double base = strength;
    if (dimension == Dimension::luminous_intensity) {
        if (factors_.at_infinity) return sun_refused("intensity");
        if (mask_of(shape_).is_loaded() && factors_.axial_share != 1.0) {
            base *= factors_.axial_share;
            note(steps, base, "cd", "I = mask(γ=0) I₀");
        }
    } else if (is_flux(dimension)) {
        if (factors_.at_infinity) return sun_refused("flux");
        const Factor factor = flux();
        base *= factor.value;
        note(steps, base, "lm", "{}", factor.formula);
        if (unit.efficacy_lm_per_w) {
            base /= *unit.efficacy_lm_per_w;
            if (steps != nullptr) note(steps, base, "W", "P = Φ / {}", efficacy_text(unit));
        }
    } else if (is_luminance(dimension)) {
        if (!factors_.luminance) return luminance_refused(factors_);
        base = emission.luminance.value;
        note(steps, base, "nt", "L from {}", factors_.luminance->formula);
    } else {
        Result<Factor> factor = illuminance_factor(shape_, factors_, unit);
        if (!factor) return pass_on(factor);
        base *= factor->value;
        if (unit.distance) {
            note(steps, base, "lx", "{}, d = {} m", factor->formula, rounded(unit.distance->value));
            note_inverse_square(steps, shape_, strength, base, *unit.distance);
        }
    }
    return in_unit(base, unit, steps);
}

Result<Meters> ShapePhotometry::distance_of(const Emission& emission, Lux illuminance) const {
    if (!(illuminance.value > 0.0) || !std::isfinite(illuminance.value))
        return fail("USE0106", "a distance belongs to an illuminance above 0");
    if (factors_.at_infinity)
        return fail(Failure::usage, "the sun is infinitely far away, so its illuminance does not depend on a distance");
    const double candela = emission.intensity.value * factors_.axial_share;
    if (!(candela > 0.0))
        return fail(Failure::usage, "the light is dark along its direction, so no distance gives an illuminance there");
    const auto lux_at = [&](double distance_m) {
        return emission.intensity.value * facing_factor(shape_, factors_, Meters(distance_m)).value;
    };
    // The illuminance is greatest on contact, where an area light fills the half space, and falls without end. The
    // inverse square of the brightest direction bounds it for every shape but tube and cylinder, whose near side may
    // count for more, so the distance is doubled until the illuminance is below the target.
    double far = std::sqrt(candela / illuminance.value);
    if (!std::isfinite(far) || !(far > 0.0)) return fail("USE0106", "the distance is out of the range of a number");
    double near = std::fmax(factors_.nearest_m, 1e-9 * far);
    if (lux_at(near) < illuminance.value)
        return fail("USE0106", fmt::format("even at contact this light gives only {} lx", rounded(lux_at(near))),
                    "ask for less, or give it more flux or a smaller size");
    if (inverse_square_is_exact(shape_)) return Meters(far);
    far = std::fmax(far, near);
    while (lux_at(far) > illuminance.value)
        far *= 2.0;
    for (;;) {
        const double middle = 0.5 * (near + far);
        if (!(middle > near && middle < far)) return Meters(middle);
        (lux_at(middle) >= illuminance.value ? near : far) = middle;
    }
}

bool same_quantity(const PhotometricUnit& a, const PhotometricUnit& b) {
    const auto is_illuminance = [](const PhotometricUnit& unit) {
        const Dimension dimension = unit.unit->dimension;
        return (dimension == Dimension::illuminance || dimension == Dimension::illuminance_ev) && !unit.distance;
    };
    return (is_luminance(a.unit->dimension) && is_luminance(b.unit->dimension)) ||
           (is_illuminance(a) && is_illuminance(b));
}

Result<double> convert_unit(const PhotometricValue& value, const PhotometricUnit& unit, ConversionSteps* steps) {
    return in_unit(in_base_unit(value, steps), unit, steps);
}

Result<Emission> emission_of(const Shape& shape, const PhotometricValue& value, ConversionSteps* steps) {
    Result<ShapePhotometry> photometry = ShapePhotometry::of(shape);
    if (!photometry) return pass_on(photometry);
    return photometry->emission_of(value, steps);
}

Result<double> express(const Shape& shape, const Emission& emission, const PhotometricUnit& unit,
                       ConversionSteps* steps) {
    Result<ShapePhotometry> photometry = ShapePhotometry::of(shape);
    if (!photometry) return pass_on(photometry);
    return photometry->express(emission, unit, steps);
}

Result<Emission> with_same_flux(const Shape& from, const Emission& emission, const Shape& to) {
    PhotometricValue lumens{0.0, {find_unit("lm"), std::nullopt, std::nullopt}};
    Result<double> number = express(from, emission, lumens.unit);
    if (!number) return pass_on(number);
    lumens.number = *number;
    return emission_of(to, lumens);
}

Result<Meters> distance_of(const Shape& shape, const Emission& emission, Lux illuminance) {
    Result<ShapePhotometry> photometry = ShapePhotometry::of(shape);
    if (!photometry) return pass_on(photometry);
    return photometry->distance_of(emission, illuminance);
}

} // namespace gonio
