#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/base/base64.hpp>
#include <gonio/base/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

using std::numbers::pi;

std::string describe(const MeasuredLight& light) {
    return fmt::format("{:.6g} lm, peak {:.6g} cd, of {}", light.flux.value, light.peak.value,
                       ascii(light.source_file));
}

std::string ascii(std::string_view text) {
    std::string plain;
    for (const char c : text)
        plain += static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? '?' : c;
    return plain;
}

std::string quoted(std::string_view text) {
    const auto is_plain = [](char c) { return c == '\n' || (c >= 0x20 && c <= 0x7e); };
    if (!std::all_of(text.begin(), text.end(), is_plain)) return detail::Json(text).dump(-1, true);
    std::string literal = "\"";
    literal.reserve(text.size() + 4);
    for (const char c : text) {
        if (c == '"' || c == '\\') literal += '\\';
        if (c == '\n')
            literal += "\\n";
        else
            literal += c;
    }
    return literal += '"';
}

std::string triple(const glm::dvec3& v, std::string_view separator) {
    // Adding 0 removes the sign of a negative zero.
    return fmt::format("{}{}{}{}{}", v.x + 0.0, separator, v.y + 0.0, separator, v.z + 0.0);
}

std::string identifier(std::string_view name) {
    std::string plain;
    for (const char c : name)
        plain += c == '-' || c == '.' ? '_' : c;
    return plain[0] >= '0' && plain[0] <= '9' ? "_" + plain : plain;
}

std::string texels_in_base64(const std::vector<double>& texels) {
    std::string bytes;
    for (const double texel : texels) {
        const auto value = static_cast<unsigned>(std::lround(65535.0 * std::clamp(texel, 0.0, 1.0)));
        bytes += static_cast<char>(value & 0xffU);
        bytes += static_cast<char>(value >> 8);
    }
    return base64(bytes);
}

ScaledColor scaled(const glm::dvec3& color) {
    const double most = std::max({color.x, color.y, color.z});
    return {color / most, most};
}

double reach_of(const SceneLight& light, double units_per_meter) {
    return light.range.value_or(std::sqrt(1.0887 * light.intensity / window_loss_lx) * units_per_meter);
}

AssetPicture baked_picture(const Web& web, BakeOptions options, int channels) {
    options.threads = 1; // the lights of a batch are spread over the threads
    const Result<Texture> texture = bake_texture(web, options);
    if (!texture) return {};
    return {picture_of(*texture, 0, texture->image.width, channels), options.texel_type};
}

AssetPicture engine_picture(std::string_view engine, const Web& web) {
    const Engine& reader = **find_engine(engine);
    return baked_picture(web, reader.bake, reader.channels);
}

Mesh capsule_mesh(double radius, double length) {
    constexpr int around = 48;
    constexpr int half = 12; // rings of a hemisphere
    Mesh mesh;
    for (int end = 0; end < 2; ++end)
        for (int ring = end == 0 ? 0 : half; end == 0 ? ring <= half : ring >= 0; ring += end == 0 ? 1 : -1) {
            const double polar = 0.5 * pi * ring / half; // from the tip
            const double x = (end == 0 ? -1.0 : 1.0) * (0.5 * length + radius * std::cos(polar));
            for (int i = 0; i < around; ++i) {
                const double turn = 2.0 * pi * i / around;
                mesh.points.emplace_back(x, radius * std::sin(polar) * std::cos(turn),
                                         radius * std::sin(polar) * std::sin(turn));
            }
        }
    const int rings = 2 * (half + 1);
    for (int ring = 0; ring + 1 < rings; ++ring)
        for (int i = 0; i < around; ++i) {
            const int a = ring * around + i;
            const int b = ring * around + (i + 1) % around;
            if (ring > 0) mesh.faces.emplace_back(a, b, b + around);
            if (ring + 2 < rings) mesh.faces.emplace_back(a, b + around, a + around);
        }
    // Flat faces lie inside the capsule: move them out from the axis and the ends alike until the areas agree.
    double area = 0.0;
    for (const glm::ivec3& f : mesh.faces)
        area += 0.5 * glm::length(glm::cross(
                          mesh.points[static_cast<std::size_t>(f.y)] - mesh.points[static_cast<std::size_t>(f.x)],
                          mesh.points[static_cast<std::size_t>(f.z)] - mesh.points[static_cast<std::size_t>(f.x)]));
    const double factor = std::sqrt((2.0 * pi * radius * length + 4.0 * pi * radius * radius) / area);
    for (glm::dvec3& point : mesh.points)
        point *= factor;
    return mesh;
}

Mesh cylinder_mesh(double radius, double length) {
    constexpr int around = 96;
    const double r = radius * pi / around / std::sin(pi / around);
    Mesh mesh;
    for (const double x : {-0.5 * length, 0.5 * length})
        for (int i = 0; i < around; ++i)
            mesh.points.emplace_back(x, r * std::cos(2.0 * pi * i / around), r * std::sin(2.0 * pi * i / around));
    for (int i = 0; i < around; ++i) {
        const int a = i;
        const int b = (i + 1) % around;
        mesh.faces.emplace_back(a, b, b + around);
        mesh.faces.emplace_back(a, b + around, a + around);
    }
    return mesh;
}

Mesh rectangle_mesh(double width, double height) {
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return {{{-x, -y, 0.0}, {-x, y, 0.0}, {x, y, 0.0}, {x, -y, 0.0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Mesh ellipse_mesh(double half_width, double half_height) {
    constexpr int around = 96;
    const double beyond = std::sqrt(2.0 * pi / around / std::sin(2.0 * pi / around));
    const double x = half_width * beyond;
    const double y = half_height * beyond;
    Mesh mesh;
    mesh.points.emplace_back(0.0, 0.0, 0.0);
    for (int i = 0; i < around; ++i)
        mesh.points.emplace_back(x * std::cos(2.0 * pi * i / around), -y * std::sin(2.0 * pi * i / around), 0.0);
    for (int i = 0; i < around; ++i)
        mesh.faces.emplace_back(0, 1 + i, 1 + (i + 1) % around);
    return mesh;
}

} // namespace gonio::asset_detail
