#include <gonio/base/amount_range.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/shape_keys.hpp>
#include <gonio/scene/surface_emission.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <utility>

namespace gonio {

namespace {

constexpr std::array<std::string_view, 1> emission_keys{"color"};

struct SurfaceSize {
    std::string_view kind;
    std::array<std::string_view, 3> keys;
    std::size_t count; // of the keys
    Primitive (*made)(const std::array<double, 3>& lengths);
};

constexpr std::array sizes{
    SurfaceSize{"box",
                {"w", "h", "d"},
                3,
                [](const auto& l) -> Primitive {
                    return Box{{}, 0.5 * glm::dvec3(l[0], l[1], l[2])};
                }},
    SurfaceSize{"panel",
                {"w", "h"},
                2,
                [](const auto& l) -> Primitive {
                    return Panel{{}, l[0], l[1]};
                }},
    SurfaceSize{"capsule",
                {"r", "l"},
                2,
                [](const auto& l) -> Primitive {
                    return Capsule{glm::dvec3(0.0), {0.0, 0.0, 1.0}, 0.5 * l[1], l[0]};
                }},
};

struct LitArea {
    double operator()(const Plane& /*without end*/) const { return std::numeric_limits<double>::infinity(); }
    double operator()(const Panel& panel) const { return panel.width * panel.height; }
    double operator()(const Ball& ball) const { return 4.0 * std::numbers::pi * ball.radius * ball.radius; }
    double operator()(const Box& box) const {
        const glm::dvec3& half = box.half_size;
        return 8.0 * (half.x * half.y + half.x * half.z + half.y * half.z);
    }
    double operator()(const Capsule& capsule) const {
        return 4.0 * std::numbers::pi * capsule.radius * (capsule.half_length + capsule.radius);
    }
};

struct AsLight {
    std::optional<Shape> operator()(const Plane& /*without end*/) const { return std::nullopt; }
    std::optional<Shape> operator()(const Panel& panel) const {
        return RectShape{Meters(panel.width), Meters(panel.height)};
    }
    std::optional<Shape> operator()(const Ball& ball) const { return SphereShape{Meters(ball.radius)}; }
    std::optional<Shape> operator()(const Box& /*six lights*/) const { return std::nullopt; }
    std::optional<Shape> operator()(const Capsule& capsule) const {
        return TubeShape{Meters(capsule.radius), Meters(2.0 * capsule.half_length)};
    }
};

PhotometricValue nits(double luminance) {
    return {luminance, {find_unit("nt"), std::nullopt, std::nullopt}};
}

Unexpected plane_refused() {
    return fail("USE0107", "a plane cannot emit light: it has no end, so neither a flux nor a light of its shape",
                "use a panel, which has a width and a height");
}

Unexpected box_refused(const PhotometricUnit& unit) {
    return fail("USE0105",
                fmt::format("a box has no {} in {}: it emits from six faces, in no direction more than in others",
                            dimension_name(unit.unit->dimension), unit.unit->symbol),
                "give its luminance or its flux, for example 500nt or 800lm");
}

bool is_flux(Dimension dimension) {
    return dimension == Dimension::luminous_flux || dimension == Dimension::power;
}

bool is_luminance(Dimension dimension) {
    return dimension == Dimension::luminance || dimension == Dimension::luminance_ev;
}

void note(ConversionSteps* steps, std::string formula, double value, const char* unit) {
    if (steps != nullptr) steps->push_back({std::move(formula), value, unit});
}

Result<double> luminance_of(const Shape& shape, const PhotometricValue& amount, ConversionSteps* steps) {
    Result<Emission> emission = emission_of(shape, amount, steps);
    if (!emission) return pass_on(emission);
    return emission->luminance.value;
}

constexpr const char* flux_of_box = "Φ = 2π (w h + w d + h d) L";

Result<double> luminance_of_box(double area_m2, const PhotometricValue& amount, ConversionSteps* steps) {
    const Dimension dimension = amount.unit.unit->dimension;
    if (is_luminance(dimension)) return convert_unit(amount, nits(0.0).unit, steps);
    if (!is_flux(dimension)) return box_refused(amount.unit);
    double lumens = amount.number * amount.unit.unit->base_per_unit;
    if (const std::optional<double> efficacy = amount.unit.efficacy_lm_per_w) {
        lumens *= *efficacy;
        note(steps, fmt::format("Φ = P · {} lm/W", rounded(*efficacy)), lumens, "lm");
    }
    const double luminance = lumens / (std::numbers::pi * area_m2);
    note(steps, fmt::format("L from {}", flux_of_box), luminance, "nt");
    return luminance;
}

Result<double> express_box(double area_m2, Nits luminance, const PhotometricUnit& unit, ConversionSteps* steps) {
    const Dimension dimension = unit.unit->dimension;
    if (is_luminance(dimension)) return convert_unit(nits(luminance.value), unit, steps);
    if (!is_flux(dimension)) return box_refused(unit);
    double amount = std::numbers::pi * area_m2 * luminance.value;
    note(steps, flux_of_box, amount, "lm");
    if (const std::optional<double> efficacy = unit.efficacy_lm_per_w) {
        amount /= *efficacy;
        note(steps, fmt::format("P = Φ / {} lm/W", rounded(*efficacy)), amount, "W");
    }
    return amount / unit.unit->base_per_unit;
}

} // namespace

double lit_area(const Primitive& geometry) {
    return std::visit(LitArea(), geometry);
}

Result<SurfaceEmission> parse_surface_emission(std::string_view text, Diagnostics* diagnostics, FileScope* files) {
    constexpr std::string_view example = "for example 500nt, 800lm or 500nt,color=3000K";
    Result<KindText> words = parse_kind_text(fmt::format("emits:{}", text));
    if (!words) return pass_on(words);
    if (words->entries.empty() || words->entries.front().value)
        return fail("USE0104", fmt::format("'{}' has no amount of light", text), std::string(example));
    const std::string amount = words->entries.front().key;
    words->entries.erase(words->entries.begin());
    if (Result<void> known = only_keys(*words, emission_keys); !known) return pass_on(known);
    Result<PhotometricValue> value = parse_photometric_value(amount, files);
    if (!value) return pass_on(value);
    SurfaceEmission emission{*value};
    if (words->entries.empty()) return emission;
    const std::string* const color = words->value("color");
    if (color == nullptr) return fail("USE0104", "'color' has no value", std::string(example));
    Result<glm::dvec3> rgb = parse_light_color(*color, diagnostics, files);
    if (!rgb) return pass_on(rgb);
    emission.color = *rgb;
    return emission;
}

std::optional<Shape> light_shape(const Primitive& geometry) {
    return std::visit(AsLight(), geometry);
}

Result<std::optional<Primitive>> parse_surface_size(std::string_view text) {
    const std::string_view kind = text.substr(0, text.find(':'));
    const auto found =
        std::find_if(sizes.begin(), sizes.end(), [&](const SurfaceSize& size) { return size.kind == kind; });
    if (found == sizes.end()) return std::optional<Primitive>();
    Result<KindText> words = parse_kind_text(text);
    if (!words) return pass_on(words);
    const auto keys = std::span(found->keys).first(found->count);
    if (Result<void> known = only_keys(*words, keys); !known) return pass_on(known);
    std::array<double, 3> lengths{};
    for (std::size_t i = 0; i < keys.size(); ++i) {
        Result<Meters> length = read_length(*words, keys[i]);
        if (!length) return pass_on(length);
        lengths.at(i) = length->value;
    }
    const Primitive made = found->made(lengths);
    const double area = lit_area(made);
    if (!(area > 0.0) || !std::isfinite(area))
        return fail("USE0106", fmt::format("the size of this {} is out of the range of a number", kind));
    return std::optional(made);
}

Result<Nits> emitted_luminance(const Primitive& geometry, const PhotometricValue& amount, ConversionSteps* steps) {
    if (std::holds_alternative<Plane>(geometry)) return plane_refused();
    const std::optional<Shape> shape = light_shape(geometry);
    Result<double> luminance =
        shape ? luminance_of(*shape, amount, steps) : luminance_of_box(lit_area(geometry), amount, steps);
    if (!luminance) return pass_on(luminance);
    if (!(*luminance > 0.0))
        return fail("USE0106", "a surface that emits needs an amount greater than 0",
                    "a surface that only reflects needs none");
    if (!in_amount_range(*luminance))
        return fail("USE0106",
                    fmt::format("the surface has a luminance of {} cd/m2, above {} cd/m2", *luminance, greatest_amount),
                    "its amount is too large, or too large for its size");
    return Nits(*luminance);
}

Result<double> express_emission(const Primitive& geometry, Nits luminance, const PhotometricUnit& unit,
                                ConversionSteps* steps) {
    if (std::holds_alternative<Plane>(geometry)) return plane_refused();
    const std::optional<Shape> shape = light_shape(geometry);
    if (!shape) return express_box(lit_area(geometry), luminance, unit, steps);
    Result<Emission> emission = emission_of(*shape, nits(luminance.value), steps);
    if (!emission) return pass_on(emission);
    return express(*shape, *emission, unit, steps);
}

} // namespace gonio
