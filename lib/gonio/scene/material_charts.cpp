#include <gonio/base/codes/result.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/scene/material_description.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

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
            say(fmt::format("{} of '{}' is {:.0f} in sRGB, but dielectrics lie within {} to {}", key, kind, value,
                            dielectric_albedo.low, dielectric_albedo.high));
    }
    void specular(std::string_view kind, std::string_view key, const glm::dvec3& f0) {
        const double value = srgb(f0);
        if (!dielectric_specular.has(value) && !metal_specular.has(value))
            say(fmt::format("{} of '{}' is {:.0f} in sRGB, and dielectrics lie within {} to {}, metals within {} to {}",
                            key, kind, value, dielectric_specular.low, dielectric_specular.high, metal_specular.low,
                            metal_specular.high));
    }
    void metal(std::string_view kind, std::string_view key, const glm::dvec3& base) {
        const double value = srgb(base);
        if (!metal_specular.has(value))
            say(fmt::format("{} of '{}' is {:.0f} in sRGB, and metals lie within {} to {}", key, kind, value,
                            metal_specular.low, metal_specular.high));
    }
    Diagnostics take() { return std::move(found_); }

private:
    void say(std::string message) {
        found_.push_back(
            result_diagnostic("RES0108", std::move(message),
                              "from the artists' charts of Remember Me (2013); the value is used as given"));
    }

    Diagnostics found_;
};

// A metal has no diffuse part, so its albedo is not checked.
bool has_metal(const ChartColors& colors) {
    return std::any_of(colors.begin(), colors.end(), [](const ChartColor& color) {
        return color.as == ChartColor::As::specular && srgb(color.value) >= metal_specular.low;
    });
}

} // namespace

Diagnostics check_charts(const Material& material) {
    Charts charts;
    std::visit(
        [&]<class M>(const M& kind) {
            const ChartColors colors = MaterialDescription<M>::chart_colors(kind);
            for (const ChartColor& color : colors)
                switch (color.as) {
                case ChartColor::As::albedo:
                    if (!has_metal(colors)) charts.albedo(MaterialDescription<M>::kind, color.key, color.value);
                    break;
                case ChartColor::As::specular:
                    charts.specular(MaterialDescription<M>::kind, color.key, color.value);
                    break;
                case ChartColor::As::metal:
                    charts.metal(MaterialDescription<M>::kind, color.key, color.value);
                    break;
                }
        },
        base_of(material));
    return charts.take();
}

} // namespace gonio
