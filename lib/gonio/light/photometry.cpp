#include <gonio/light/facing.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

// "90 lm/W", "330.1 lm/W (LED-B3, 380–780 nm)": a computed one in five digits, a given one as it stands.
std::string efficacy_text(const PhotometricUnit& unit) {
    const double lm_per_w = unit.efficacy_lm_per_w.value_or(0.0);
    if (unit.efficacy_of.empty()) return fmt::format("{} lm/W", lm_per_w);
    return fmt::format("{} lm/W ({})", rounded(lm_per_w, 5), unit.efficacy_of);
}

using std::numbers::pi;

// A constant between two quantities of a shape, and what it says.
struct Factor {
    double value = 0.0;
    std::string formula; // "Φ = 4π I"
};

// Everything of a shape that needs no search: its strength (the intensity before a mask; the sun's illuminance) over
// its other quantities, except for the flux and the illuminance at a distance.
struct Emitter {
    bool at_infinity = false;
    std::optional<Factor> luminance; // strength/L, nothing where luminance has no meaning
    const char* no_luminance = "";   // why not
    const char* strength = "I";      // its symbol
    double axial_share = 1.0;        // intensity along the direction (a web: along γ = 0) over the strength
    double peak_cd = 0.0;            // of the web or the mask
    double nearest_m = 0.0;          // a distance below this is inside the shape
};

constexpr const char* point_has_no_area = "a point has no area, so no luminance";

struct MakeEmitter {
    static Result<Emitter> punctual(const std::string& mask_file, const Web* mask) {
        Emitter emitter;
        emitter.no_luminance = point_has_no_area;
        if (mask == nullptr) {
            if (!mask_file.empty()) return fail(Failure::internal, "the mask of this shape was not loaded");
            return emitter;
        }
        emitter.peak_cd = peak(*mask).intensity.value;
        if (!(emitter.peak_cd > 0.0))
            return fail(Failure::usage, "this mask lets no light through, so nothing can be scaled to it", {},
                        mask_file);
        emitter.axial_share = mask->candela(0.0, 0.0) / emitter.peak_cd;
        emitter.strength = "I₀";
        return emitter;
    }
    static Emitter area(double projected_m2, const char* formula, double nearest_m = 0.0) {
        Emitter emitter;
        emitter.luminance = Factor{projected_m2, formula};
        emitter.nearest_m = nearest_m;
        return emitter;
    }

    Result<Emitter> operator()(const PointShape& point) const { return punctual(point.mask_file, point.mask.get()); }
    Result<Emitter> operator()(const SpotShape& spot) const { return punctual(spot.mask_file, spot.mask.get()); }
    Result<Emitter> operator()(const FrustumShape& frustum) const {
        return punctual(frustum.mask_file, frustum.mask.get());
    }
    Result<Emitter> operator()(const ProfileShape& profile) const {
        if (!profile.web) return fail(Failure::internal, "the profile of this shape was not loaded");
        Emitter emitter;
        emitter.peak_cd = peak(*profile.web).intensity.value;
        if (!(emitter.peak_cd > 0.0))
            return fail(Failure::usage, "this profile emits no light, so nothing can be scaled to it", {},
                        profile.file);
        emitter.axial_share = profile.web->candela(0.0, 0.0) / emitter.peak_cd;
        emitter.no_luminance = "a profile is a point that emits by direction: it has no area, so no luminance";
        return emitter;
    }
    Result<Emitter> operator()(const SphereShape& sphere) const {
        const double r = sphere.radius.value;
        return area(pi * r * r, "I = π r² L", r);
    }
    Result<Emitter> operator()(const DiskShape& disk) const {
        const double r = disk.radius.value;
        return area(pi * r * r, "I = π r² L");
    }
    Result<Emitter> operator()(const RectShape& rect) const {
        return area(rect.width.value * rect.height.value, "I = w h L");
    }
    Result<Emitter> operator()(const TubeShape& tube) const {
        const double r = tube.radius.value;
        return area(r * (2.0 * tube.length.value + pi * r), "I = (2 r l + π r²) L", r);
    }
    Result<Emitter> operator()(const SunShape& sun) const {
        const double s = std::sin(0.5 * sun.diameter.value);
        Emitter emitter;
        emitter.at_infinity = true;
        emitter.strength = "E";
        emitter.luminance = Factor{pi * s * s, "E = π sin²(δ/2) L"};
        return emitter;
    }
};

Result<Emitter> emitter_of(const Shape& shape) {
    return std::visit(MakeEmitter{}, shape);
}

// Φ over the strength. Costs an integration where there is a web.
struct FluxFactor {
    const Shape& shape;
    const Emitter& emitter;

    Factor masked(const char* formula, const Web& mask) const {
        return {masked_solid_angle(shape, mask).value, formula};
    }
    static Factor sided(bool two_sided) { return two_sided ? Factor{2.0 * pi, "Φ = 2π I"} : Factor{pi, "Φ = π I"}; }

    Factor operator()(const PointShape& point) const {
        if (point.mask) return masked("Φ = (∬ mask dω) I₀", *point.mask);
        return {4.0 * pi, "Φ = 4π I"};
    }
    Factor operator()(const SpotShape& spot) const {
        if (spot.mask) return masked("Φ = (∬ lobe · mask dω) I₀", *spot.mask);
        return {lobe_solid_angle(spot).value, flux_formula(spot)};
    }
    Factor operator()(const FrustumShape& frustum) const {
        if (frustum.mask) return masked("Φ = (∬ mask dω inside the pyramid) I₀", *frustum.mask);
        return {lobe_solid_angle(frustum).value, "Φ = 4 asin(sin(h/2) sin(v/2)) I"};
    }
    Factor operator()(const ProfileShape& profile) const {
        return {flux(*profile.web).value / emitter.peak_cd, "Φ = (Φ_web / I_peak) I"};
    }
    Factor operator()(const SphereShape&) const { return {4.0 * pi, "Φ = 4π I"}; }
    Factor operator()(const DiskShape& disk) const { return sided(disk.two_sided); }
    Factor operator()(const RectShape& rect) const { return sided(rect.two_sided); }
    Factor operator()(const TubeShape& tube) const {
        const double r = tube.radius.value;
        const double l = tube.length.value;
        return {2.0 * pi * pi * (l + 2.0 * r) / (2.0 * l + pi * r), "Φ = π (2π r l + 4π r²)/(2 r l + π r²) I"};
    }
    Factor operator()(const SunShape&) const { return {}; } // refused before
};

// E over the strength for a facing receiver at distance d.
struct FacingFactor {
    const Emitter& emitter;
    Meters distance;

    Factor punctual(const char* axial) const {
        const double d = distance.value;
        return {emitter.axial_share / (d * d), fmt::format("E = {}/d²", axial)};
    }
    template<class Area>
    Factor area(const Area& shape, const char* formula) const {
        return {facing_illuminance(shape, distance) / emitter.luminance->value, formula};
    }
    const char* behind_mask() const { return emitter.axial_share == 1.0 ? emitter.strength : "mask(γ=0) I₀"; }

    Factor operator()(const PointShape&) const { return punctual(behind_mask()); }
    Factor operator()(const SpotShape&) const { return punctual(behind_mask()); }
    Factor operator()(const FrustumShape&) const { return punctual(behind_mask()); }
    Factor operator()(const ProfileShape&) const { return punctual(emitter.axial_share == 1.0 ? "I" : "I(γ=0)"); }
    Factor operator()(const SphereShape&) const { return punctual("I"); }
    Factor operator()(const DiskShape& disk) const { return area(disk, "E = I/(d² + r²)"); }
    Factor operator()(const RectShape& rect) const {
        return area(rect, "E = 2 [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))] L, A = w/2d, B = h/2d");
    }
    Factor operator()(const TubeShape& tube) const {
        return area(tube, "E = 2 [(r/d) atan(z/κd) + (r²d h + r z √(D²−r²) sin h)/D³] L, κ = √(1−r²/d²), z = l/2, "
                          "D² = d²+z², h = atan2(Dκ, zr/d)");
    }
    Factor operator()(const SunShape&) const { return {1.0, "E = E"}; } // has no distance
};

// A step that several answers share is said once.
void note(ConversionSteps* steps, std::string formula, double value, const char* unit) {
    if (steps == nullptr) return;
    for (const ConversionStep& step : *steps)
        if (step.formula == formula) return;
    steps->push_back({std::move(formula), value, unit});
}

bool inverse_square_is_exact(const Shape& shape) {
    return !std::holds_alternative<DiskShape>(shape) && !std::holds_alternative<RectShape>(shape) &&
           !std::holds_alternative<TubeShape>(shape);
}

void note_inverse_square(ConversionSteps* steps, const Shape& shape, double intensity, double lux, Meters distance) {
    if (steps == nullptr || inverse_square_is_exact(shape) || !(lux > 0.0)) return;
    const double d = distance.value;
    const double estimate = intensity / (d * d);
    note(steps, fmt::format("I/d², the inverse square, d = {} m", rounded(d)), estimate, "lx");
    note(steps, fmt::format("(I/d²)/E − 1, its error, d = {} m", rounded(d)), 100.0 * (estimate / lux - 1.0), "%");
}

Unexpected luminance_refused(const Emitter& emitter) {
    return fail(Failure::usage, emitter.no_luminance,
                "give it a size: --shape sphere:r=1cm, or --assume sphere:r=1cm for this answer alone");
}

Unexpected sun_refused(const char* quantity) {
    return fail(Failure::usage, fmt::format("the sun is infinitely far away, so it has no {}", quantity),
                "its amount is an illuminance or a luminance: lx, evlx, fc, nt, ev or fL");
}

// E over the strength, once the distance makes sense for the shape.
Result<Factor> illuminance_factor(const Shape& shape, const Emitter& emitter, const PhotometricUnit& unit) {
    if (emitter.at_infinity) {
        if (unit.distance)
            return fail(Failure::usage, "the sun is infinitely far away, so its illuminance takes no distance",
                        fmt::format("write {} alone", unit.unit->symbol));
        return std::visit(FacingFactor{emitter, Meters(0.0)}, shape);
    }
    if (!unit.distance)
        return fail(Failure::usage,
                    fmt::format("an illuminance in {} needs the distance of the receiver", unit.unit->symbol),
                    fmt::format("write for example {}@2m", unit.unit->symbol));
    if (unit.distance->value < emitter.nearest_m)
        return fail(Failure::usage,
                    fmt::format("a distance of {} m is inside the {} of radius {} m", unit.distance->value,
                                kind_of(shape), emitter.nearest_m),
                    "the distance counts from the centre");
    return std::visit(FacingFactor{emitter, *unit.distance}, shape);
}

bool is_flux(Dimension dimension) {
    return dimension == Dimension::luminous_flux || dimension == Dimension::power;
}
bool is_luminance(Dimension dimension) {
    return dimension == Dimension::luminance || dimension == Dimension::luminance_ev;
}

Emission emission_of_strength(const Emitter& emitter, double strength) {
    Emission emission;
    if (emitter.at_infinity)
        emission.illuminance = Lux(strength);
    else
        emission.intensity = Candelas(strength);
    if (emitter.luminance) emission.luminance = Nits(strength / emitter.luminance->value);
    return emission;
}

Result<double> strength_of(const Shape& shape, const Emitter& emitter, const PhotometricValue& value,
                           ConversionSteps* steps) {
    const double base = value.number * value.unit.unit->base_per_unit;
    const Dimension dimension = value.unit.unit->dimension;
    const char* const strength_unit = emitter.at_infinity ? "lx" : "cd";
    const auto say = [&](const std::string& formula, double strength) {
        note(steps, fmt::format("{} from {}", emitter.strength, formula), strength, strength_unit);
        return strength;
    };

    if (dimension == Dimension::luminous_intensity) {
        if (emitter.at_infinity) return sun_refused("intensity");
        if (mask_of(shape).web == nullptr || emitter.axial_share == 1.0) return base;
        if (!(emitter.axial_share > 0.0))
            return fail(Failure::usage, "this mask lets nothing through along γ = 0, so no intensity there can set it",
                        "give its flux instead");
        return say("I = mask(γ=0) I₀", base / emitter.axial_share);
    }
    if (is_flux(dimension)) {
        if (emitter.at_infinity) return sun_refused("flux");
        double lumens = base;
        if (value.unit.efficacy_lm_per_w) {
            lumens *= *value.unit.efficacy_lm_per_w;
            note(steps, fmt::format("Φ = P · {}", efficacy_text(value.unit)), lumens, "lm");
        }
        const Factor factor = std::visit(FluxFactor{shape, emitter}, shape);
        if (!(factor.value > 0.0))
            return fail(Failure::usage,
                        std::holds_alternative<ProfileShape>(shape)
                            ? "the flux of this profile is not greater than 0, so it cannot be scaled to one"
                            : "this shape lets no flux through, so it cannot be scaled to one");
        return say(factor.formula, lumens / factor.value);
    }
    if (is_luminance(dimension)) {
        if (!emitter.luminance) return luminance_refused(emitter);
        double nits = base;
        if (dimension == Dimension::luminance_ev) {
            nits = luminance(Ev100(base)).value;
            note(steps, "L = 2^(EV−3)", nits, "nt");
        }
        const double strength = nits * emitter.luminance->value;
        note(steps, emitter.luminance->formula, strength, strength_unit);
        return strength;
    }
    Result<Factor> factor = illuminance_factor(shape, emitter, value.unit);
    if (!factor) return pass_on(factor);
    double lux = base;
    if (dimension == Dimension::illuminance_ev) {
        lux = illuminance(EvLux(base)).value;
        note(steps, "E = 2.5 · 2^EV", lux, "lx");
    }
    if (emitter.at_infinity) return lux;
    if (!(emitter.axial_share > 0.0))
        return fail(Failure::usage,
                    std::holds_alternative<ProfileShape>(shape)
                        ? "this profile emits nothing along γ = 0, so no illuminance there can set it"
                        : "this mask lets nothing through along γ = 0, so no illuminance there can set it",
                    std::holds_alternative<ProfileShape>(shape) ? "give its flux or its peak intensity instead"
                                                                : "give its flux instead");
    const double intensity = lux / factor->value;
    if (factor->formula == "E = I/d²")
        note(steps, "I = E d²", intensity, "cd");
    else
        say(factor->formula, intensity);
    note_inverse_square(steps, shape, intensity, lux, *value.unit.distance);
    return intensity;
}

} // namespace

Result<Emission> emission_of(const Shape& shape, const PhotometricValue& value, ConversionSteps* steps) {
    Result<Emitter> emitter = emitter_of(shape);
    if (!emitter) return pass_on(emitter);
    Result<double> strength = strength_of(shape, *emitter, value, steps);
    if (!strength) return pass_on(strength);
    const Emission emission = emission_of_strength(*emitter, *strength);
    if (!std::isfinite(*strength) || !std::isfinite(emission.luminance.value))
        return fail(Failure::usage, fmt::format("{} {} of this shape are too much for a number", value.number,
                                                value.unit.unit->symbol));
    return emission;
}

Result<double> express(const Shape& shape, const Emission& emission, const PhotometricUnit& unit,
                       ConversionSteps* steps) {
    Result<Emitter> made = emitter_of(shape);
    if (!made) return pass_on(made);
    const Emitter& emitter = *made;
    const Dimension dimension = unit.unit->dimension;
    const double strength = emitter.at_infinity ? emission.illuminance.value : emission.intensity.value;
    double base = strength;
    if (dimension == Dimension::luminous_intensity) {
        if (emitter.at_infinity) return sun_refused("intensity");
        if (mask_of(shape).web != nullptr && emitter.axial_share != 1.0) {
            base *= emitter.axial_share;
            note(steps, "I = mask(γ=0) I₀", base, "cd");
        }
    } else if (is_flux(dimension)) {
        if (emitter.at_infinity) return sun_refused("flux");
        const Factor factor = std::visit(FluxFactor{shape, emitter}, shape);
        base *= factor.value;
        note(steps, factor.formula, base, "lm");
        if (unit.efficacy_lm_per_w) {
            base /= *unit.efficacy_lm_per_w;
            note(steps, fmt::format("P = Φ / {}", efficacy_text(unit)), base, "W");
        }
    } else if (is_luminance(dimension)) {
        if (!emitter.luminance) return luminance_refused(emitter);
        base = emission.luminance.value;
        note(steps, fmt::format("L from {}", emitter.luminance->formula), base, "nt");
    } else {
        Result<Factor> factor = illuminance_factor(shape, emitter, unit);
        if (!factor) return pass_on(factor);
        base *= factor->value;
        if (unit.distance) {
            note(steps, fmt::format("{}, d = {} m", factor->formula, rounded(unit.distance->value)), base, "lx");
            note_inverse_square(steps, shape, strength, base, *unit.distance);
        }
    }
    if (dimension == Dimension::luminance_ev || dimension == Dimension::illuminance_ev) {
        if (!(base > 0.0)) return fail(Failure::usage, fmt::format("no light has no {}", dimension_name(dimension)));
        const bool of_luminance = dimension == Dimension::luminance_ev;
        base = of_luminance ? ev100(Nits(base)).value : ev_lux(Lux(base)).value;
        std::string formula = of_luminance ? "EV = log2(L) + 3" : "EV = log2(E/2.5)";
        if (unit.distance) formula += fmt::format(", d = {} m", rounded(unit.distance->value));
        note(steps, std::move(formula), base, unit.unit->symbol.data());
    }
    const double number = base / unit.unit->base_per_unit;
    if (!std::isfinite(number))
        return fail(Failure::usage, fmt::format("the result in {} is too large for a number", unit.unit->symbol));
    return number;
}

Result<Emission> with_same_flux(const Shape& from, const Emission& emission, const Shape& to) {
    PhotometricValue lumens{0.0, {find_unit("lm"), std::nullopt, std::nullopt}};
    Result<double> number = express(from, emission, lumens.unit);
    if (!number) return pass_on(number);
    lumens.number = *number;
    return emission_of(to, lumens);
}

Result<Meters> distance_of(const Shape& shape, const Emission& emission, Lux illuminance) {
    if (!(illuminance.value > 0.0) || !std::isfinite(illuminance.value))
        return fail(Failure::usage, "a distance belongs to an illuminance above 0");
    Result<Emitter> made = emitter_of(shape);
    if (!made) return pass_on(made);
    const Emitter& emitter = *made;
    if (emitter.at_infinity)
        return fail(Failure::usage, "the sun is infinitely far away, so its illuminance does not depend on a distance");
    const double candela = emission.intensity.value * emitter.axial_share;
    if (!(candela > 0.0))
        return fail(Failure::usage, "the light is dark along its direction, so no distance gives an illuminance there");
    const auto lux_at = [&](double distance_m) {
        return emission.intensity.value * std::visit(FacingFactor{emitter, Meters(distance_m)}, shape).value;
    };
    // Brightest on contact, where an area light fills the half space; falling without end. The inverse square of the
    // brightest direction bounds it for every shape but the tube, whose near end may count for more: doubled until
    // dark.
    double far = std::sqrt(candela / illuminance.value);
    if (!std::isfinite(far) || !(far > 0.0))
        return fail(Failure::usage, "the distance is beyond the range of a number");
    double near = std::fmax(emitter.nearest_m, 1e-9 * far);
    if (lux_at(near) < illuminance.value)
        return fail(Failure::usage, fmt::format("even on contact this light gives only {} lx", rounded(lux_at(near))),
                    "ask for less, or give it more flux or a smaller size");
    if (inverse_square_is_exact(shape)) return Meters(far);
    far = std::fmax(far, near);
    while (lux_at(far) > illuminance.value)
        far *= 2.0;
    for (;;) {
        const double middle = 0.5 * (near + far);
        if (!(middle > near && middle < far)) return Meters(middle);
        (lux_at(middle) >= illuminance.value ? near : far) = middle;
    }
}

} // namespace gonio
