#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/material.hpp>

#include <fmt/format.h>

#include <array>
#include <vector>

namespace gonio {

namespace {

constexpr std::array kinds{
    MaterialKind{"lambert", "lambert:albedo=0.5", "matte: the same luminance in every direction"},
    MaterialKind{"frostbite", "frostbite:base=0.5,smoothness=0.6,metal=0,reflectance=0.5",
                 "renormalised Disney diffuse and GGX (Lagarde and de Rousiers 2014)"},
};

Unexpected outside(const KindText& text, std::string_view key, std::string_view value) {
    return fail(Failure::usage, fmt::format("{} of '{}' must lie in [0, 1], not {}", key, text.kind, value));
}

Result<void> read_unit(const KindText& text, std::string_view key, double& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const std::optional<double> number = parse_number(*value);
    if (!number) return fail(Failure::usage, fmt::format("{} of '{}' is no number: '{}'", key, text.kind, *value));
    if (*number < 0.0 || *number > 1.0) return outside(text, key, *value);
    target = *number;
    return {};
}

Result<void> read_color(const KindText& text, std::string_view key, glm::dvec3& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const Result<glm::dvec3> rgb = parse_rgb(*value);
    if (!rgb)
        return fail(Failure::usage, fmt::format("{} of '{}' is no colour: '{}'", key, text.kind, *value),
                    "write a number in [0, 1] or rgb(r,g,b)");
    for (int channel = 0; channel < 3; ++channel)
        if ((*rgb)[channel] > 1.0) return outside(text, key, *value);
    target = *rgb;
    return {};
}

Result<void> all_have_values(const KindText& text) {
    for (const KindText::Entry& entry : text.entries)
        if (!entry.value)
            return fail(Failure::usage, fmt::format("key '{}' of '{}' has no value", entry.key, text.kind));
    return {};
}

Result<Material> parse_lambert(const KindText& text) {
    constexpr std::array<std::string_view, 1> keys{"albedo"};
    LambertMaterial material;
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "albedo", material.albedo);
    if (!read) return pass_on(read);
    return Material(material);
}

Result<Material> parse_frostbite(const KindText& text) {
    constexpr std::array<std::string_view, 4> keys{"base", "smoothness", "metal", "reflectance"};
    FrostbiteMaterial material;
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "base", material.base);
    if (read) read = read_unit(text, "smoothness", material.smoothness);
    if (read) read = read_unit(text, "metal", material.metal);
    if (read) read = read_unit(text, "reflectance", material.reflectance);
    if (!read) return pass_on(read);
    return Material(material);
}

} // namespace

std::span<const MaterialKind> material_kinds() {
    return kinds;
}

Result<Material> parse_material(std::string_view text) {
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    if (Result<void> whole = all_have_values(*parsed); !whole) return pass_on(whole);
    if (parsed->kind == "lambert") return parse_lambert(*parsed);
    if (parsed->kind == "frostbite") return parse_frostbite(*parsed);
    std::vector<std::string_view> names;
    for (const MaterialKind& kind : kinds)
        names.push_back(kind.kind);
    return unknown_name("material", parsed->kind, names);
}

} // namespace gonio
