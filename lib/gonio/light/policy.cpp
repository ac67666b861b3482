#include <gonio/base/named.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/policy.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double frostbite_guard = 0.001; // of the lobe's cosine range
constexpr double unreal_widest_rad = 89.0 / 180.0 * pi;

// A light as a program interprets it. `units` are the units that the program has for it.
struct Meanings {
    std::string lacks; // why the program has no such light; empty if it has one
    struct Entry {
        Dimension dimension;
        double emitted_over_said = 1.0;
        std::string formula;
    };
    std::vector<Entry> units;
    double luminance_at_ev_0 = 0.125;
    std::string note;
};

Meanings none(std::string why) {
    Meanings meanings;
    meanings.lacks = std::move(why);
    return meanings;
}

// A program's unit that emits what it promises.
Meanings::Entry honest(Dimension dimension, std::string formula) {
    return {dimension, 1.0, std::move(formula)};
}

// Lumens that the program converts by Φ = `said_sr` I, while the lobe emits `emitted_sr` I.
Meanings::Entry lumens(double emitted_sr, double said_sr, std::string formula) {
    return {Dimension::luminous_flux, emitted_sr / said_sr, std::move(formula)};
}

// The flux over the intensity of Frostbite's lobe, in which the cosine range is at least 0.001.
double guarded_solid_angle(const SpotShape& spot) {
    const double a = spot.inner.value;
    const double b = spot.outer.value;
    const double range = 2.0 * std::sin(0.5 * (a + b)) * std::sin(0.5 * (b - a)); // cos a − cos b
    if (range >= frostbite_guard) return lobe_solid_angle(spot).value;
    const double depth = 2.0 * std::pow(std::sin(0.5 * b), 2); // 1 − cos b
    // With t = (cosθ − cos b)/0.001: the lobe is t², cut at 1 where the cone is deeper than the guard.
    const double slope = std::fmin(depth, frostbite_guard) / frostbite_guard;
    const double rise = std::fmin(depth, frostbite_guard) * slope * slope / 3.0;
    return 2.0 * pi * (rise + std::fmax(0.0, depth - frostbite_guard));
}

// What every policy needs to know of a shape: Φ over its intensity, with any mask.
struct Facts {
    double solid_angle = 0.0; // of a punctual shape
    bool masked = false;
};

constexpr const char* by_area = "I and Φ by the shape's area";
constexpr const char* lumens_of_mask = "the lumens are those of the light without its mask";

// The punctual shapes in Frostbite, and with variations in glTF, Filament, three.js, Godot, Unity and Unreal.
struct PunctualRule {
    double spot_sr = 0.0;      // lumens over candela of a spot; 0: computed from the outer cone
    double cap_rad = 0.5 * pi; // upper limit on the half angle of the outer cone
    std::string spot_formula;

    double said_by(const SpotShape& spot) const {
        if (spot_sr > 0.0) return spot_sr;
        return 4.0 * pi * std::pow(std::sin(0.5 * std::fmin(spot.outer.value, cap_rad)), 2);
    }
};

class Rules {
public:
    Rules(const Shape& shape, Facts facts) : shape_(shape), facts_(facts) {}

    Meanings frostbite(bool cone) const {
        PunctualRule rule{cone ? 0.0 : pi, 0.5 * pi, cone ? "I = Φ/2π(1 − cos b)" : "I = Φ/π"};
        Meanings meanings = punctual(rule, true);
        if (const auto* spot = std::get_if<SpotShape>(&shape_); spot != nullptr && !cone && !facts_.masked) {
            // The program emits its own lobe, which the guard changes in narrow cones.
            const double emitted = guarded_solid_angle(*spot);
            const double guarded = emitted / lobe_solid_angle(*spot).value;
            meanings.units = {lumens(emitted, pi, rule.spot_formula),
                              {Dimension::luminous_intensity, guarded, "I, lobe with max(0.001, cos a − cos b)"}};
        }
        add_areas(meanings);
        return meanings;
    }

    Meanings unreal() const {
        if (is<DiskShape>()) return none("unreal has rectangular area lights and no disks");
        if (is<FrustumShape>()) return none("unreal has no frustum lights");
        if (!has<SphereShape, TubeShape, RectShape>()) return none(lacks("unreal"));
        Meanings meanings = punctual({0.0, unreal_widest_rad, "I = Φ/2π(1 − cos b), b at most 89°"}, true);
        meanings.luminance_at_ev_0 = 1.0;
        if (is<SphereShape>() || is<TubeShape>()) {
            // A point light with a source radius and length: nits are multiplied by the whole surface area, not by the
            // projected area.
            meanings.units = {honest(Dimension::luminous_flux, "I = Φ/4π"),
                              {Dimension::luminance, 4.0, "I = 4π r (r + l/2) L"},
                              {Dimension::luminance_ev, 4.0, "I = 4π r (r + l/2) L, L = 2^EV"}};
            if (const auto* tube = std::get_if<TubeShape>(&shape_)) {
                meanings.units.push_back(
                    {Dimension::luminous_intensity,
                     4.0 * pi / closed_form::tube_solid_angle(tube->radius.value, tube->length.value),
                     "I, all around"});
                meanings.note = "shines alike in all directions";
            }
        } else if (is<RectShape>()) {
            meanings.units = {honest(Dimension::luminous_flux, "I = Φ/π"), honest(Dimension::luminance, "I = A L"),
                              honest(Dimension::luminance_ev, "I = A L, L = 2^EV")};
        }
        return meanings;
    }

    Meanings unity() const {
        if (is<SphereShape>()) return none("unity-hdrp has disks, rectangles and tubes, no sphere lights");
        if (!has<DiskShape, RectShape, TubeShape>()) return none(lacks("unity-hdrp"));
        PunctualRule rule{4.0 * pi, 0.5 * pi, "I = Φ/4π, \"reflector\" off"};
        Meanings meanings = punctual(rule, true);
        if (is<FrustumShape>()) meanings.units = {lumens(facts_.solid_angle, 4.0 * pi, rule.spot_formula), candela()};
        if (const auto* tube = std::get_if<TubeShape>(&shape_)) {
            meanings.units = {{Dimension::luminous_flux,
                               closed_form::tube_solid_angle(tube->radius.value, tube->length.value) / (2.0 * pi),
                               "L = Φ/4πl of a line"}};
            meanings.note = "a line without a radius";
        } else {
            add_areas(meanings);
        }
        return meanings;
    }

    Meanings filament() const {
        if (has_area()) return none("filament has point, spot and directional lights only");
        if (is<FrustumShape>() || is<ProfileShape>())
            return none("filament has point, spot and directional lights only");
        return punctual({pi, 0.5 * pi, "I = Φ/π (SPOT; FOCUSED_SPOT: Φ/2π(1 − cos b))"}, false);
    }

    Meanings godot() const {
        if (has_area() || is<FrustumShape>() || is<ProfileShape>())
            return none("godot has point, spot and directional lights only");
        return punctual({pi, 0.5 * pi, "I = Φ/π"}, false);
    }

    Meanings threejs() const {
        if (!has<RectShape>() || is<FrustumShape>() || is<ProfileShape>())
            return none("three.js has point, spot, rectangular and directional lights only");
        Meanings meanings = punctual({pi, 0.5 * pi, "power = π I"}, false);
        if (is<RectShape>())
            meanings.units = {honest(Dimension::luminous_flux, "power = π w h L"), honest(Dimension::luminance, "L")};
        return meanings;
    }

    Meanings gltf() const {
        if (has_area() || is<FrustumShape>())
            return none("glTF has point, spot and directional lights only (KHR_lights_punctual)");
        Meanings meanings;
        meanings.units =
            is<SunShape>() ? std::vector{honest(Dimension::illuminance, "intensity = E")} : std::vector{candela()};
        return meanings;
    }

    Meanings usd() const {
        if (class_of(shape_) == ShapeClass::punctual)
            return none("UsdLux has lights with an area only; shape a sphere, disk, rectangle or cylinder");
        if (!has_flat_or<SphereShape, TubeShape, CylinderShape>()) return none(lacks("UsdLux"));
        Meanings meanings;
        meanings.units = {honest(Dimension::luminance, "intensity · 2^exposure = L")};
        if (is<SunShape>()) meanings.units.push_back(honest(Dimension::illuminance, "inputs:normalize = 1, E"));
        if (const auto* const tube = std::get_if<TubeShape>(&shape_)) {
            const double length = tube->length.value;
            meanings.units.front().emitted_over_said = length / (length + 2.0 * tube->radius.value);
            meanings.note = "CylinderLight has no caps: the same flux leaves its side";
        }
        return meanings;
    }

    Meanings blender() const {
        if (!has_flat_or<SphereShape>() || is<FrustumShape>() || is<ProfileShape>())
            return none("blender has point, spot, area and sun lights");
        Meanings meanings;
        if (is<SunShape>()) {
            meanings.note = "strength is W/m² across the sun's direction";
            return meanings;
        }
        Meanings::Entry watts = honest(Dimension::power, "Φ of the light");
        if (is<SpotShape>()) {
            watts.emitted_over_said = facts_.solid_angle / (4.0 * pi);
            watts.formula = "I = P/4π, cut to the cone and not scaled by it";
        }
        meanings.units = {watts};
        return meanings;
    }

    Meanings pbrt() const {
        Meanings meanings;
        meanings.units = {honest(Dimension::luminous_flux, "\"power\", exact for the light"),
                          honest(Dimension::power, "\"power\", exact for the light"), candela()};
        if (has_area()) meanings.units.push_back(honest(Dimension::luminance, "L"));
        if (is<SunShape>()) meanings.units = {honest(Dimension::illuminance, "\"illuminance\"")};
        return meanings;
    }

private:
    template<class S>
    bool is() const {
        return std::holds_alternative<S>(shape_);
    }
    bool has_area() const { return class_of(shape_) == ShapeClass::area; }
    // Whether the program has the shape: false only for an area light that is not one of these kinds.
    template<class... Kinds>
    bool has() const {
        return !has_area() || (is<Kinds>() || ...);
    }
    // The same for a program that has flat lights of any outline.
    template<class... Others>
    bool has_flat_or() const {
        return is_flat(shape_) || has<Others...>();
    }
    std::string lacks(std::string_view program) const {
        return fmt::format("{} does not have {} lights", program, kind_of(shape_));
    }

    static Meanings::Entry candela() { return honest(Dimension::luminous_intensity, "I"); }

    Meanings punctual(const PunctualRule& rule, bool profiles_are_masks) const {
        Meanings meanings;
        if (is<SunShape>()) {
            meanings.units = {honest(Dimension::illuminance, "E")};
        } else if (is<PointShape>()) {
            meanings.units = {lumens(facts_.solid_angle, 4.0 * pi, "I = Φ/4π"), candela()};
        } else if (const auto* spot = std::get_if<SpotShape>(&shape_)) {
            meanings.units = {lumens(facts_.solid_angle, rule.said_by(*spot), rule.spot_formula), candela()};
        } else if (is<FrustumShape>()) {
            meanings.units = {lumens(facts_.solid_angle, lobe_solid_angle(std::get<FrustumShape>(shape_)).value,
                                     "I = Φ/4 asin(sin(h/2) sin(v/2))"),
                              candela()};
        } else if (is<ProfileShape>() && profiles_are_masks) {
            meanings.units = {lumens(facts_.solid_angle, 4.0 * pi, "I = Φ/4π, times the profile over its peak"),
                              candela()};
            meanings.note = lumens_of_mask;
        }
        if (facts_.masked) meanings.note = lumens_of_mask;
        return meanings;
    }

    void add_areas(Meanings& meanings) const {
        if (!has_area()) return;
        meanings.units = {honest(Dimension::luminous_flux, by_area), honest(Dimension::luminance, "L"),
                          honest(Dimension::luminance_ev, "L = 2^(EV−3)")};
    }

    const Shape& shape_;
    Facts facts_;
};

struct PolicyRules {
    Policy policy;
    Meanings (*meanings)(const Rules& rules);
    std::optional<Falloff> lobe = {}; // of its spots; empty: any, or none that gonio has
    bool from_axis = false;           // the lobe falls from the axis on: its spots have no inner angle
};

constexpr std::array rules{
    PolicyRules{{"physical", "lumens are the emitted flux", "this program"}, nullptr},
    PolicyRules{{"frostbite", "spots read π lumens as 1 candela, for every cone",
                 "Lagarde and de Rousiers, Moving Frostbite to PBR, 2014"},
                [](const Rules& r) { return r.frostbite(false); },
                Falloff::frostbite},
    PolicyRules{{"frostbite-cone", "spots take lumens for the solid angle of their outer cone",
                 "Lagarde and de Rousiers, Moving Frostbite to PBR, 2014"},
                [](const Rules& r) { return r.frostbite(true); },
                Falloff::frostbite},
    PolicyRules{{"unreal", "spots by their outer cone; nits of spheres times the whole surface",
                 "Unreal Engine 5, SpotLightComponent, PointLightComponent, RectLightComponent"},
                [](const Rules& r) { return r.unreal(); },
                Falloff::frostbite},
    PolicyRules{{"unity-hdrp", "spots as points, unless \"reflector\" is on; tubes as lines",
                 "Unity Graphics, LightUnitUtils.cs"},
                [](const Rules& r) { return r.unity(); },
                Falloff::frostbite},
    PolicyRules{{"filament", "spots take lumens for π candela", "Filament, LightManager.cpp"},
                [](const Rules& r) { return r.filament(); },
                Falloff::frostbite},
    PolicyRules{{"godot", "spots take lumens for π candela", "Godot, light_storage.cpp"},
                [](const Rules& r) { return r.godot(); },
                Falloff::linear_cos,
                true},
    PolicyRules{{"threejs", "spots take lumens for π candela", "three.js, src/lights"},
                [](const Rules& r) { return r.threejs(); },
                Falloff::smoothstep_cos},
    PolicyRules{{"gltf", "candela and lux only", "Khronos, KHR_lights_punctual"},
                [](const Rules& r) { return r.gltf(); },
                Falloff::frostbite},
    PolicyRules{{"usd", "nits only", "OpenUSD, UsdLux"}, [](const Rules& r) { return r.usd(); }},
    PolicyRules{{"blender", "radiant watts; spots are cut out of a point", "Blender, Cycles light.cpp"},
                [](const Rules& r) { return r.blender(); }},
    PolicyRules{{"pbrt", "exact; spots are smoothstep over the cosine", "pbrt-v4, lights.cpp"},
                [](const Rules& r) { return r.pbrt(); },
                Falloff::smoothstep_cos},
};

constexpr auto policy_list = [] {
    std::array<Policy, rules.size()> list{};
    for (std::size_t i = 0; i < rules.size(); ++i)
        list[i] = rules[i].policy;
    return list;
}();

const PolicyRules* rules_of(const Policy& policy) {
    for (const PolicyRules& known : rules)
        if (known.policy.name == policy.name) return &known;
    return nullptr;
}

// Φ of one candela before any mask.
Result<Facts> facts_of(const Shape& shape) {
    Facts facts;
    const bool punctual = class_of(shape) == ShapeClass::punctual;
    if (!punctual && mask_of(shape).is_loaded())
        return fail(Failure::unsupported, "other programs do not have masks on lights with a size",
                    "name the shape without its mask");
    if (!punctual) return facts;
    facts.masked = mask_of(shape).is_loaded();
    if (const auto* spot = std::get_if<SpotShape>(&shape); spot != nullptr && !(spot->outer.value > 0.0))
        return fail(Failure::unsupported, "a spot of 0deg has no flux to compare");
    Result<PhotometricValue> lumen = parse_photometric_value("1lm");
    if (!lumen) return pass_on(lumen);
    Result<Emission> emission = emission_of(shape, *lumen);
    if (!emission) return pass_on(emission);
    facts.solid_angle = 1.0 / emission->intensity.value;
    return facts;
}

} // namespace

std::span<const Policy> policies() {
    return policy_list;
}

Result<const Policy*> find_policy(std::string_view name) {
    return find_named("policy", name, policy_list);
}

ProgramShape program_shape(const Policy& policy, Shape shape) {
    ProgramShape shown{std::move(shape), {}};
    const PolicyRules* const found = rules_of(policy);
    auto* const spot = std::get_if<SpotShape>(&shown.shape);
    if (found == nullptr || !found->lobe || spot == nullptr || spot->inner.value == spot->outer.value) return shown;
    const double inner = found->from_axis ? 0.0 : spot->inner.value;
    if (spot->falloff == *found->lobe && spot->inner.value == inner) return shown;
    spot->falloff = *found->lobe;
    spot->inner = Radians(inner);
    shown.note = fmt::format("its lobe is {}{}", to_text(*found->lobe), found->from_axis ? " from the axis on" : "");
    return shown;
}

Result<PolicyMeaning> policy_meaning(const Policy& policy, const Shape& shape, Dimension dimension) {
    PolicyMeaning meaning;
    const PolicyRules* const found = rules_of(policy);
    if (found == nullptr) return fail(Failure::internal, "a policy was asked for that does not exist");
    if (found->meanings == nullptr) {
        meaning.own = true;
        return meaning;
    }
    Result<Facts> facts = facts_of(shape);
    if (!facts) return pass_on(facts);
    Meanings meanings = found->meanings(Rules(shape, *facts));
    if (!meanings.lacks.empty())
        return fail(Failure::unsupported, std::move(meanings.lacks), "'gonio list policies' shows the others");
    meaning.note = std::move(meanings.note);
    for (Meanings::Entry& entry : meanings.units) {
        if (entry.dimension != dimension) continue;
        meaning.own = true;
        meaning.emitted_over_said = entry.emitted_over_said;
        meaning.formula = std::move(entry.formula);
        meaning.luminance_at_ev_0 = meanings.luminance_at_ev_0;
    }
    return meaning;
}

PhotometricValue physical_value(const PolicyMeaning& meaning, PhotometricValue value) {
    if (value.unit.unit->dimension == Dimension::luminance_ev)
        value.number += std::log2(8.0 * meaning.luminance_at_ev_0 * meaning.emitted_over_said);
    else if (value.unit.unit->dimension == Dimension::illuminance_ev)
        value.number += std::log2(meaning.emitted_over_said);
    else
        value.number *= meaning.emitted_over_said;
    return value;
}

double policy_number(const PolicyMeaning& meaning, const PhotometricUnit& unit, double number) {
    if (unit.unit->dimension == Dimension::luminance_ev)
        return number - std::log2(8.0 * meaning.luminance_at_ev_0 * meaning.emitted_over_said);
    if (unit.unit->dimension == Dimension::illuminance_ev) return number - std::log2(meaning.emitted_over_said);
    return number / meaning.emitted_over_said;
}

} // namespace gonio
