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
    MaterialKind{"eon", "eon:albedo=0.5,roughness=0.4",
                 "rough and matte, energy-preserving Oren-Nayar (Portsmouth, Kutz and Hill 2025)"},
    MaterialKind{"frostbite", "frostbite:base=0.5,smoothness=0.6,metal=0,reflectance=0.5",
                 "renormalised Disney diffuse and GGX (Lagarde and de Rousiers 2014)"},
    MaterialKind{"ue4", "ue4:base=0.5,roughness=0.4,metallic=0,specular=0.5,cavity=1", "Lambert and GGX (Karis 2013)"},
    MaterialKind{"blinn", "blinn:albedo=0.5,specular=0.04,smoothness=0.6,wet=0",
                 "Lambert and a cosine power, dry to wet, of Remember Me (Lagarde and Harduin 2013)"},
    MaterialKind{"ggx", "ggx:f0=1,alpha=0.3", "GGX alone, scattered once; or roughness, alpha's root"},
    MaterialKind{"kulla-conty", "kulla-conty:f0=1,alpha=0.3",
                 "GGX that loses no light between its facets (Kulla and Conty 2017); or roughness"},
};

Unexpected outside(const KindText& text, std::string_view key, std::string_view value) {
    return fail(Failure::usage, fmt::format("{} of '{}' must lie in [0, 1], not {}", key, text.kind, value));
}

Result<void> read_unit(const KindText& text, std::string_view key, double& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const std::optional<double> number = parse_number(*value);
    if (!number) return fail(Failure::usage, fmt::format("{} of '{}' is not a number: '{}'", key, text.kind, *value));
    if (*number < 0.0 || *number > 1.0) return outside(text, key, *value);
    target = *number;
    return {};
}

Result<void> read_color(const KindText& text, std::string_view key, glm::dvec3& target) {
    const std::string* value = text.value(key);
    if (value == nullptr) return {};
    const Result<glm::dvec3> rgb = parse_rgb(*value);
    if (!rgb)
        return fail(Failure::usage, fmt::format("{} of '{}' is not a colour: '{}'", key, text.kind, *value),
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

// alpha, or roughness, its root.
Result<void> read_alpha(const KindText& text, double& alpha) {
    if (text.value("alpha") != nullptr && text.value("roughness") != nullptr)
        return fail(Failure::usage, fmt::format("'{}' is given both alpha and roughness", text.kind),
                    "alpha is the square of roughness");
    if (text.value("roughness") == nullptr) return read_unit(text, "alpha", alpha);
    double roughness = 0.0;
    Result<void> read = read_unit(text, "roughness", roughness);
    alpha = roughness * roughness;
    return read;
}

Result<Material> parse(const KindText& text, LambertMaterial material) {
    constexpr std::array<std::string_view, 1> keys{"albedo"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "albedo", material.albedo);
    if (!read) return pass_on(read);
    return Material(material);
}

Result<Material> parse(const KindText& text, EonMaterial material) {
    constexpr std::array<std::string_view, 2> keys{"albedo", "roughness"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "albedo", material.albedo);
    if (read) read = read_unit(text, "roughness", material.roughness);
    if (!read) return pass_on(read);
    return Material(material);
}

Result<Material> parse(const KindText& text, FrostbiteMaterial material) {
    constexpr std::array<std::string_view, 4> keys{"base", "smoothness", "metal", "reflectance"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "base", material.base);
    if (read) read = read_unit(text, "smoothness", material.smoothness);
    if (read) read = read_unit(text, "metal", material.metal);
    if (read) read = read_unit(text, "reflectance", material.reflectance);
    if (!read) return pass_on(read);
    return Material(material);
}

Result<Material> parse(const KindText& text, Ue4Material material) {
    constexpr std::array<std::string_view, 5> keys{"base", "roughness", "metallic", "specular", "cavity"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "base", material.base);
    if (read) read = read_unit(text, "roughness", material.roughness);
    if (read) read = read_unit(text, "metallic", material.metallic);
    if (read) read = read_unit(text, "specular", material.specular);
    if (read) read = read_unit(text, "cavity", material.cavity);
    if (!read) return pass_on(read);
    return Material(material);
}

Result<Material> parse(const KindText& text, BlinnMaterial material) {
    constexpr std::array<std::string_view, 4> keys{"albedo", "specular", "smoothness", "wet"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "albedo", material.albedo);
    if (read) read = read_color(text, "specular", material.specular);
    if (read) read = read_unit(text, "smoothness", material.smoothness);
    if (read) read = read_unit(text, "wet", material.wet);
    if (!read) return pass_on(read);
    return Material(material);
}

// GgxMaterial or KullaContyMaterial.
template<class Facets>
Result<Material> parse(const KindText& text, Facets material) {
    constexpr std::array<std::string_view, 3> keys{"f0", "alpha", "roughness"};
    Result<void> read = only_keys(text, keys);
    if (read) read = read_color(text, "f0", material.f0);
    if (read) read = read_alpha(text, material.alpha);
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
    if (parsed->kind == "lambert") return parse(*parsed, LambertMaterial());
    if (parsed->kind == "eon") return parse(*parsed, EonMaterial());
    if (parsed->kind == "frostbite") return parse(*parsed, FrostbiteMaterial());
    if (parsed->kind == "ue4") return parse(*parsed, Ue4Material());
    if (parsed->kind == "blinn") return parse(*parsed, BlinnMaterial());
    if (parsed->kind == "ggx") return parse(*parsed, GgxMaterial());
    if (parsed->kind == "kulla-conty") return parse(*parsed, KullaContyMaterial());
    std::vector<std::string_view> names;
    for (const MaterialKind& kind : kinds)
        names.push_back(kind.kind);
    return unknown_name("material", parsed->kind, names);
}

} // namespace gonio
