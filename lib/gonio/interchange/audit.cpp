#include <gonio/base/codes/scene.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/audit.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/web.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double watts_factor = 683.0; // [lm/W], what exporters take

bool agrees(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::abs(b);
}

// The value to some significant digits.
double to_digits(double value, int digits) {
    if (!(value > 0.0)) return 0.0;
    const double step = std::pow(10.0, std::floor(std::log10(value)) - (digits - 1));
    return std::round(value / step) * step;
}

// Whether it has two significant digits at most; and whether `derived` has not three.
bool is_round(double value) {
    return value >= 0.5 && agrees(value, to_digits(value, 2), 1e-4);
}
bool is_round_but_not(double value, double derived) {
    return is_round(value) && !agrees(derived, to_digits(derived, 3), 1e-6);
}

bool is_sun(const FoundLight& light) {
    return light.shape && std::holds_alternative<SunShape>(*light.shape);
}

// Whether the file's own number is candela of a point or a spot.
bool states_candela(const FoundLight& light) {
    return light.intensity && light.intensity->unit.unit->symbol == "cd" && !light.profile &&
           (light.kind == "point" || light.kind == "spot");
}

std::optional<double> flux_of(const FoundLight& light) {
    if (!light.shape || !light.intensity || is_sun(light)) return std::nullopt;
    if (const auto* const profile = std::get_if<ProfileShape>(&*light.shape); profile != nullptr && !profile->web)
        return std::nullopt;
    const Result<Emission> emission = emission_of(*light.shape, *light.intensity);
    const Result<PhotometricUnit> lumen = parse_photometric_unit("lm");
    if (!emission || !lumen) return std::nullopt;
    const Result<double> flux = express(*light.shape, *emission, *lumen);
    return flux ? std::optional(*flux) : std::nullopt;
}

class Auditor {
public:
    Auditor(const FoundScene& scene, std::optional<double> lumens_per_watt)
        : scene_(scene), lumens_per_watt_(lumens_per_watt) {}

    std::vector<SceneFinding> findings() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        glm::dvec3 low(infinity);
        glm::dvec3 high(-infinity);
        std::size_t placed = 0;
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const FoundLight& light = scene_.lights[i];
            of_one(i);
            if (!light.shape || is_sun(light)) continue;
            low = glm::min(low, light.position);
            high = glm::max(high, light.position);
            ++placed;
        }
        const double extent = placed > 1 ? glm::length(high - low) : 0.0;
        lengths(extent);
        unitless(extent, placed);
        neighbours();
        std::vector<SceneFinding> all;
        for (auto& [code, found] : by_code_)
            std::move(found.findings.begin(), found.findings.end(), std::back_inserter(all));
        return all;
    }

private:
    // One finding for all lights with the same message.
    SceneFinding& add(SceneCode code, std::size_t light, std::string message, std::string hint = {}) {
        OfCode& of_code = by_code_[code->code];
        const auto [at, is_new] = of_code.by_message.try_emplace(message, of_code.findings.size());
        if (is_new) of_code.findings.push_back({&*code, {}, std::move(message), std::move(hint), {}});
        SceneFinding* const found = &of_code.findings[at->second];
        found->lights.push_back(light);
        return *found;
    }

    void of_one(std::size_t i) {
        const FoundLight& light = scene_.lights[i];
        const double stated = light.stated_amount;
        if (light.kind == "mesh") return;
        if (stated < 0.0) {
            SceneFinding& found = add("SCN0309", i, fmt::format("the amount is {}", rounded(stated)),
                                      "a light that darkens is a trick of one program");
            found.fixes.push_back({i, {light.kind == "ies" ? "multiplier" : "intensity"}, stated, -stated});
        }
        if ((light.shape && light.intensity && light.intensity->number == 0.0) || stated == 0.0 ||
            light.stated_color_max == 0.0)
            add("SCN0310", i, "it emits nothing", "delete it, or give it an amount");
        if (light.temperature && light.is_tinted)
            add("SCN0307", i, "it has a colour temperature and a tint: both multiply", "set the colour to white");
        if (light.stated_color_max > 0.0 && !agrees(light.stated_color_max, 1.0, 1e-3) && states_candela(light)) {
            SceneFinding& found = add(
                "SCN0312", i, fmt::format("the greatest channel of the colour is {}", rounded(light.stated_color_max)),
                "scale the colour to 1, and multiply the amount instead");
            const double most = light.stated_color_max;
            for (int channel = 0; channel < 3; ++channel) {
                found.fixes.push_back({i, {"color", std::to_string(channel)}, NAN, 1.0 / most});
            }
            found.fixes.push_back({i, {"intensity"}, stated, stated * most});
        }
        cone(i);
        watts(i);
        too_much(i);
        profile(i);
    }

    void cone(std::size_t i) {
        const FoundLight& light = scene_.lights[i];
        if (!light.stated_outer || scene_.format != "gltf") return;
        const double outer = *light.stated_outer;
        if (outer <= 0.5 * pi * (1.0 + 1e-6)) return;
        const bool in_degrees = outer > pi * (1.0 + 1e-6);
        SceneFinding& found =
            add("SCN0304", i,
                in_degrees
                    ? fmt::format("the outer cone angle is {}: degrees instead of radians", rounded(outer))
                    : fmt::format("the outer cone angle is {} rad: a full angle instead of a half one", rounded(outer)),
                in_degrees ? "multiply the angles by π/180" : "halve the angles");
        const double factor = in_degrees ? pi / 180.0 : 0.5;
        if (outer * factor > 0.5 * pi) return;
        found.fixes.push_back({i, {"spot", "outerConeAngle"}, outer, outer * factor});
        if (light.stated_inner && *light.stated_inner > 0.0)
            found.fixes.push_back({i, {"spot", "innerConeAngle"}, *light.stated_inner, *light.stated_inner * factor});
    }

    void watts(std::size_t i) {
        const FoundLight& light = scene_.lights[i];
        const double stated = light.stated_amount;
        if (scene_.format != "gltf" || !light.shape) return;
        const double factor = is_sun(light) ? watts_factor : watts_factor / (4.0 * pi);
        if (!is_sun(light) && !states_candela(light)) return;
        const double watts = stated / factor;
        constexpr double least_lux = 1e4; // of a sun
        if (is_sun(light) ? stated < least_lux || !is_round(watts) : !is_round_but_not(watts, stated)) return;
        const std::string_view unit = is_sun(light) ? "W/m²" : "W";
        SceneFinding& found = add("SCN0301", i,
                                  fmt::format("{} is {} {} × 683 lm/W{}", rounded(stated), rounded(to_digits(watts, 2)),
                                              unit, is_sun(light) ? "" : " / 4π"),
                                  "white light has about 180 lm/W: --lm-per-watt 180 --fix changes the amounts");
        if (lumens_per_watt_)
            found.fixes.push_back({i, {"intensity"}, stated, stated / watts_factor * *lumens_per_watt_});
    }

    void too_much(std::size_t i) {
        const FoundLight& light = scene_.lights[i];
        if (!light.shape || !light.intensity) return;
        constexpr double most_lux = 1.3e5;
        constexpr double most_candela = 1e6;
        constexpr double most_nits = 1.6e9;
        constexpr double most_lumens = 2e5;
        const double number = light.intensity->number;
        const std::string_view unit = light.intensity->unit.unit->symbol;
        const auto say = [&](double value, std::string_view of, double most) {
            add("SCN0302", i, fmt::format("{} {}, more than {} {}", rounded(value), of, rounded(most), of),
                "its amount may be in another unit");
        };
        if (unit == "lx" && number > most_lux) return say(number, "lx", most_lux);
        if (unit == "nt" && number > most_nits) return say(number, "cd/m²", most_nits);
        const std::optional<double> flux = flux_of(light);
        if (flux && *flux > most_lumens) return say(*flux, "lm", most_lumens);
        if (unit == "cd" && number > most_candela) return say(number, "cd", most_candela);
    }

    void profile(std::size_t i) {
        const FoundLight& light = scene_.lights[i];
        const auto* const shape = light.shape ? std::get_if<ProfileShape>(&*light.shape) : nullptr;
        if (shape == nullptr || !shape->web || !(light.stated_amount > 1.5)) return;
        const double peak_cd = peak(*shape->web).intensity.value;
        const double flux_lm = flux(*shape->web).value;
        const bool by_peak = agrees(light.stated_amount, peak_cd, 2e-3);
        if (!by_peak && !agrees(light.stated_amount, flux_lm, 2e-3)) return;
        SceneFinding& found = add("SCN0306", i,
                                  fmt::format("the multiplier {} is the profile's own {}", rounded(light.stated_amount),
                                              by_peak ? "peak" : "flux"),
                                  "a profile has its candela already: the multiplier should be 1");
        found.fixes.push_back({i, {"multiplier"}, light.stated_amount, 1.0});
    }

    void lengths(double extent) {
        constexpr double far_apart = 300.0;
        constexpr double large = 20.0;
        const std::string hint = "read it with --unit-scale cm, or export it in metres";
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const FoundLight& light = scene_.lights[i];
            if (!light.shape || is_sun(light)) continue;
            double longest = 0.0;
            for (const ShapeValue& value : values_of(*light.shape))
                if (const auto* const length = std::get_if<Meters>(&value.value))
                    longest = std::max(longest, length->value);
            if (longest > large) add("SCN0305", i, fmt::format("it is more than {} m large", large), hint);
            if (extent > far_apart)
                add("SCN0305", i, fmt::format("the lights are spread over {} m", rounded(extent, 3)), hint);
        }
    }

    void unitless(double extent, std::size_t placed) {
        constexpr double most = 20.0;
        if (placed < 2 || extent < 2.0) return;
        std::vector<std::size_t> small;
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const FoundLight& light = scene_.lights[i];
            if (!states_candela(light) || light.stated_amount == 0.0) continue;
            if (!(light.stated_amount > 0.0 && light.stated_amount <= most)) return;
            small.push_back(i);
        }
        if (small.size() < 2) return;
        for (const std::size_t i : small)
            add("SCN0311", i, fmt::format("all amounts are {} cd or less over {} m", most, rounded(extent, 3)),
                "a lamp of 800 lm has 64 cd");
    }

    // Pairs of one kind that differ by a factor which only a conversion has.
    void neighbours() {
        std::map<std::string, std::map<double, std::size_t>> amounts; // by kind: the first light of each amount
        for (std::size_t i = 0; i < scene_.lights.size(); ++i)
            if (const FoundLight& light = scene_.lights[i];
                light.shape && light.stated_amount > 0.0 && light.kind != "ies")
                amounts[light.kind].try_emplace(light.stated_amount, i);
        struct Ratio {
            double value;
            std::string_view text;
        };
        constexpr std::array ratios{Ratio{pi, "π"}, Ratio{4.0 * pi, "4π"}, Ratio{pi * pi, "π²"}};
        constexpr double tolerance = 1e-5;
        for (const auto& [kind, of_kind] : amounts)
            for (const auto& [number, light] : of_kind)
                for (const auto& [value, text] : ratios) {
                    const auto near = of_kind.lower_bound(number * value * (1.0 - tolerance));
                    if (near == of_kind.end() || near->first > number * value * (1.0 + tolerance)) continue;
                    SceneFinding& found = add("SCN0303", light,
                                              fmt::format("{} and the {} of '{}' differ by exactly {}", rounded(number),
                                                          rounded(near->first), scene_.lights[near->second].name, text),
                                              "one of the two was converted by another formula");
                    found.lights.push_back(near->second);
                }
    }

    const FoundScene& scene_;
    std::optional<double> lumens_per_watt_;
    struct OfCode {
        std::vector<SceneFinding> findings;
        std::unordered_map<std::string, std::size_t> by_message;
    };
    std::map<std::string_view, OfCode> by_code_;
};

} // namespace

std::vector<SceneFinding> audit_scene(const FoundScene& scene, std::optional<double> lumens_per_watt) {
    return Auditor(scene, lumens_per_watt).findings();
}

Diagnostic to_diagnostic(const SceneFinding& finding, const FoundScene& scene) {
    const FoundLight& first = scene.lights[finding.lights.front()];
    std::string who = fmt::format("light '{}'", first.name);
    if (finding.lights.size() > 1 && finding.code->code != "SCN0303")
        who += fmt::format(" and {} more", finding.lights.size() - 1);
    return {std::string(finding.code->code), finding.code->severity, first.location,
            fmt::format("{}: {}", who, finding.message), finding.hint};
}

} // namespace gonio
