#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/material_charts.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <string_view>
#include <utility>

namespace gonio {

namespace {

struct Range {
    int low, high;

    [[nodiscard]] bool has(double value) const { return std::round(value) >= low && std::round(value) <= high; }
};
constexpr Range dielectric_albedo{32, 243};
constexpr Range dielectric_specular{43, 65};
constexpr Range metal_specular{186, 255};

double srgb(const glm::dvec3& linear) {
    return 255.0 * encode_srgb(glm::dot(linear, rec709_luminance));
}

class Charts {
public:
    void albedo(std::string_view kind, std::string_view key, const glm::dvec3& linear) {
        const double value = srgb(linear);
        if (!dielectric_albedo.has(value))
            say(fmt::format("{} of '{}' is {:.0f} in sRGB, and dielectrics lie within {} to {}", key, kind, value,
                            dielectric_albedo.low, dielectric_albedo.high));
    }
    void specular(std::string_view kind, const glm::dvec3& f0) {
        const double value = srgb(f0);
        if (!dielectric_specular.has(value) && !metal_specular.has(value))
            say(fmt::format("f0 of '{}' is {:.0f} in sRGB, and dielectrics lie within {} to {}, metals within {} to {}",
                            kind, value, dielectric_specular.low, dielectric_specular.high, metal_specular.low,
                            metal_specular.high));
    }
    void metal(std::string_view kind, const glm::dvec3& base) {
        const double value = srgb(base);
        if (!metal_specular.has(value))
            say(fmt::format("base of '{}' is {:.0f} in sRGB, and metals lie within {} to {}", kind, value,
                            metal_specular.low, metal_specular.high));
    }
    Diagnostics take() { return std::move(found_); }

private:
    void say(std::string message) {
        Diagnostic& diagnostic = found_.emplace_back();
        diagnostic.severity = Severity::warning;
        diagnostic.message = std::move(message);
        diagnostic.hint = "the artists' charts of Remember Me (2013); nothing is changed";
    }

    Diagnostics found_;
};

void judge(const LambertMaterial& m, Charts& charts) {
    charts.albedo("lambert", "albedo", m.albedo);
}
void judge(const EonMaterial& m, Charts& charts) {
    charts.albedo("eon", "albedo", m.albedo);
}
void judge(const GgxMaterial& m, Charts& charts) {
    charts.specular("ggx", m.f0);
}
void judge(const KullaContyMaterial& m, Charts& charts) {
    charts.specular("kulla-conty", m.f0);
}
void judge(const FrostbiteMaterial& m, Charts& charts) {
    if (m.metal == 1.0) charts.metal("frostbite", m.base);
    if (m.metal != 0.0) return;
    const auto f0 = core_material(m).f0;
    charts.albedo("frostbite", "base", m.base);
    charts.specular("frostbite", {f0.x, f0.y, f0.z});
}
void judge(const Ue4Material& m, Charts& charts) {
    if (m.metallic == 1.0) charts.metal("ue4", m.base);
    if (m.metallic != 0.0) return;
    const auto f0 = core_material(m).f0;
    charts.albedo("ue4", "base", m.base);
    charts.specular("ue4", {f0.x, f0.y, f0.z});
}
void judge(const BlinnMaterial& m, Charts& charts) {
    charts.specular("blinn", m.specular);
    if (srgb(m.specular) < metal_specular.low) charts.albedo("blinn", "albedo", m.albedo); // a metal's is black
}

} // namespace

Diagnostics check_charts(const Material& material) {
    Charts charts;
    std::visit([&](const auto& kind) { judge(kind, charts); }, material);
    return charts.take();
}

} // namespace gonio
