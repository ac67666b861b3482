#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace gonio::interchange_detail {

Unexpected scene_error(SceneCode code, Location location, std::string message, std::string hint) {
    const bool unsupported = code->code == "SCN0106" || code->code == "SCN0101";
    Error error = error_at(unsupported ? Failure::unsupported : Failure::malformed, std::move(location),
                           std::move(message), std::move(hint));
    error.diagnostics.back().code = code->code;
    return Unexpected(std::move(error));
}

Location LinePlaces::at(std::size_t offset) {
    offset = std::min(offset, text_.size());
    if (offset < line_begin_) {
        line_begin_ = 0;
        line_ = 1;
        line_end_ = text_.find('\n');
    }
    while (line_end_ < offset) { // npos is beyond every offset
        line_begin_ = line_end_ + 1;
        line_end_ = text_.find('\n', line_begin_);
        ++line_;
    }
    return {source_, line_, static_cast<std::uint32_t>(offset - line_begin_ + 1)};
}

PhotometricValue amount(double number, std::string_view unit) {
    PhotometricValue value;
    value.number = number;
    value.unit.unit = find_unit(unit);
    return value;
}

void remark(FoundLight& light, SceneCode code, std::string message, std::string hint) {
    light.remarks.push_back({&*code, std::move(message), std::move(hint)});
}

void warn(FoundScene& scene, SceneCode code, Location location, std::string message, std::string hint) {
    Diagnostic said;
    said.code = code->code;
    said.severity = code->severity;
    said.location = std::move(location);
    said.message = std::move(message);
    said.hint = std::move(hint);
    scene.diagnostics.push_back(std::move(said));
}

std::string plain_name(std::string_view name) {
    std::string plain;
    for (const char c : name)
        plain += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ? c : '_';
    return plain;
}

void only_list(FoundLight& light, std::string why, std::string hint) {
    light.shape.reset();
    remark(light, "SCN0203", std::move(why), std::move(hint));
}

std::string numbers_text(const glm::dvec3& v) {
    return fmt::format("{} {} {}", rounded(v.x + 0.0), rounded(v.y + 0.0), rounded(v.z + 0.0));
}

double take_color(FoundLight& light, const glm::dvec3& rgb) {
    light.stated_color_max = std::max({rgb.x, rgb.y, rgb.z});
    light.is_tinted = rgb.x != rgb.y || rgb.y != rgb.z;
    const double luminance = light.is_tinted ? glm::dot(rgb, rec709_luminance) : rgb.x;
    if (!(luminance > 0.0) || !std::isfinite(luminance)) return 0.0;
    if (light.is_tinted) {
        glm::dvec3 color = rgb / luminance;
        if (std::min({rgb.x, rgb.y, rgb.z}) < 0.0) {
            color = glm::dvec3(std::max(color.x, 0.0), std::max(color.y, 0.0), std::max(color.z, 0.0));
            color /= glm::dot(color, rec709_luminance);
            remark(light, "SCN0202", "the colour has a negative channel, which becomes 0");
        }
        light.color = color;
    }
    return luminance;
}

glm::dvec3 blackbody_color(FoundLight& light, double kelvin) {
    Diagnostics clipped;
    Result<glm::dvec3> color = parse_light_color(shortest(kelvin) + "K", &clipped);
    if (!color) {
        remark(light, "SCN0203", "no black body has that colour temperature for gonio: white is taken");
        return glm::dvec3(1.0);
    }
    if (!clipped.empty()) remark(light, "SCN0202", "the colour temperature lies outside Rec.709: clipped to it");
    return *color;
}

namespace {

// Unit length; rotations leave zeros as about 1e-16.
glm::dvec3 unit(const glm::dvec3& v) {
    glm::dvec3 one = v / glm::length(v);
    constexpr double rounding = 1e-15;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(one[axis]) < rounding) one[axis] = 0.0;
    return one;
}

} // namespace

bool place_light(FoundLight& light, const glm::dmat4& world, const glm::dvec3& aim, const glm::dvec3& up, char up_axis,
                 double meters_per_unit) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(world[column][row]) <= 1e100)) {
                only_list(light, "its transformation is not finite");
                return false;
            }
    const glm::dvec3 position = glm::dvec3(world[3]) * meters_per_unit;
    const glm::dvec3 direction = glm::dvec3(world * glm::dvec4(aim, 0.0));
    const glm::dvec3 upward = glm::dvec3(world * glm::dvec4(up, 0.0));
    const double length = glm::length(direction);
    const glm::dvec3 across = glm::cross(direction, upward);
    if (!(length > 0.0) || !(glm::length(across) > 0.0) || !std::isfinite(length)) {
        only_list(light, "its transformation has a scale of 0: the light has no direction");
        return false;
    }
    light.position = z_up(position, up_axis);
    light.direction = z_up(unit(direction), up_axis);
    const glm::dvec3 square = glm::cross(across, direction); // `up` across the direction
    light.up = z_up(unit(square), up_axis);
    return true;
}

glm::dvec3 axis_lengths(const glm::dmat4& world) {
    return {glm::length(glm::dvec3(world[0])), glm::length(glm::dvec3(world[1])), glm::length(glm::dvec3(world[2]))};
}

bool nearly(double a, double b) {
    return std::abs(a - b) <= 1e-6 * std::max(std::abs(a), std::abs(b));
}

void take_flat(FoundLight& light, const glm::dmat4& world, bool round, double aim, bool two_sided, char up,
               double meters_per_unit) {
    if (!place_light(light, world, {0.0, 0.0, aim}, {0.0, aim < 0.0 ? 1.0 : -1.0, 0.0}, up, meters_per_unit)) return;
    const glm::dvec3 x(world[0]);
    const glm::dvec3 y(world[1]);
    const double width = 2.0 * glm::length(x) * meters_per_unit;
    const double height = 2.0 * glm::length(y) * meters_per_unit;
    if (!(width > 0.0) || !(height > 0.0) || std::abs(glm::dot(x, y)) > 1e-6 * glm::length(x) * glm::length(y))
        return only_list(light, "its transformation shears it");
    // The normal of a surface stays across it.
    const glm::dvec3 across = glm::cross(x, y) * (glm::determinant(world) < 0.0 ? -1.0 : 1.0);
    light.direction = z_up(aim * across / glm::length(across), up);
    light.up = z_up((aim < 0.0 ? 1.0 : -1.0) * y / glm::length(y), up);
    if (!round)
        light.shape = RectShape{Meters(width), Meters(height), two_sided};
    else if (nearly(width, height))
        light.shape = DiskShape{Meters(0.5 * width), two_sided};
    else
        light.shape = EllipseShape{Meters(width), Meters(height), two_sided};
}

namespace {

// Places a flat shape by its middle, its normal and the direction of its width.
void place_flat(FoundLight& light, const glm::dvec3& middle, const glm::dvec3& normal, const glm::dvec3& width,
                char up) {
    light.position = z_up(middle, up);
    light.direction = z_up(unit(normal), up);
    light.up = z_up(unit(glm::cross(-normal, width)), up); // Y = Z × X
}

bool take_rectangle(FoundLight& light, const std::vector<glm::dvec3>& corners, const glm::dvec3& normal, double area,
                    char up) {
    const glm::dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    // The corner opposite to the first is the farthest of equal ones in a rectangle.
    for (std::size_t opposite = 1; opposite < 4; ++opposite) {
        const glm::dvec3 a = corners[opposite == 1 ? 2 : 1];
        const glm::dvec3 b = corners[opposite == 3 ? 2 : 3];
        const glm::dvec3 one = a - corners[0];
        const glm::dvec3 other = b - corners[0];
        const double width = glm::length(one);
        const double height = glm::length(other);
        const double size = std::max(width, height);
        if (glm::length(corners[0] + corners[opposite] - a - b) > 1e-6 * size) continue;
        if (std::abs(glm::dot(one, other)) > 1e-6 * width * height || !nearly(width * height, area)) continue;
        light.shape = RectShape{Meters(std::max(width, height)), Meters(std::min(width, height))};
        place_flat(light, middle, normal, width >= height ? one : other, up);
        return true;
    }
    return false;
}

bool take_ellipse(FoundLight& light, const std::vector<glm::dvec3>& corners, const glm::dvec3& normal, double area,
                  char up) {
    constexpr std::size_t fewest = 12;
    if (corners.size() < fewest) return false;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(infinity);
    glm::dvec3 high(-infinity);
    for (const glm::dvec3& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const double size = glm::length(high - low);
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    std::vector<glm::dvec2> rim; // without the middle
    const glm::dvec3 z = unit(normal);
    const glm::dvec3 x =
        unit(glm::cross(std::abs(z.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0), z));
    const glm::dvec3 y = glm::cross(z, x);
    for (const glm::dvec3& corner : corners)
        if (glm::length(corner - middle) > 1e-6 * size)
            rim.emplace_back(glm::dot(corner - middle, x), glm::dot(corner - middle, y));
    if (rim.size() < fewest - 1) return false;
    // Of corners at equal steps of the ellipse's angle the mean squares are half those of the semi-axes.
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const glm::dvec2& at : rim) {
        const double share = 2.0 / static_cast<double>(rim.size());
        xx += share * at.x * at.x;
        xy += share * at.x * at.y;
        yy += share * at.y * at.y;
    }
    const double turn = 0.5 * std::atan2(2.0 * xy, xx - yy);
    const glm::dvec2 major(std::cos(turn), std::sin(turn));
    const glm::dvec2 minor(-major.y, major.x);
    const double half = 0.5 * (xx + yy);
    const double spread = std::hypot(0.5 * (xx - yy), xy);
    const double a = std::sqrt(half + spread);
    const double b = std::sqrt(std::max(half - spread, 0.0));
    if (!(b > 1e-6 * a)) return false;
    for (const glm::dvec2& at : rim)
        if (std::abs(std::hypot(glm::dot(at, major) / a, glm::dot(at, minor) / b) - 1.0) > 1e-6) return false;
    const double factor = std::sqrt(area / (std::numbers::pi * a * b)); // a polygon of the ellipse's area
    if (!(factor > 0.9 && factor < 1.0 + 1e-6)) return false;
    if (nearly(a, b))
        light.shape = DiskShape{Meters(a * factor)};
    else
        light.shape = EllipseShape{Meters(2.0 * a * factor), Meters(2.0 * b * factor)};
    place_flat(light, middle, normal, major.x * x + major.y * y, up);
    return true;
}

} // namespace

void take_mesh(FoundLight& light, const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& faces,
               char up) {
    double area = 0.0;
    glm::dvec3 normal(0.0);
    std::vector<bool> used(points.size());
    for (const glm::ivec3& face : faces) {
        const auto a = static_cast<std::size_t>(face.x);
        const auto b = static_cast<std::size_t>(face.y);
        const auto c = static_cast<std::size_t>(face.z);
        const glm::dvec3 of_face = 0.5 * glm::cross(points[b] - points[a], points[c] - points[a]);
        area += glm::length(of_face);
        normal += of_face;
        used[a] = used[b] = used[c] = true;
    }
    const std::string what = fmt::format("a mesh of {} triangles and {} m²", faces.size(), rounded(area, 4));
    if (!(area > 0.0) || !std::isfinite(area)) return only_list(light, "a mesh without an area");
    if (std::abs(glm::length(normal) - area) <= 1e-9 * area) { // flat, all faces to one side
        constexpr std::size_t most = 512;                      // of an ellipse; others are not looked at in pairs
        std::vector<glm::dvec3> corners;
        for (std::size_t i = 0; i < points.size() && corners.size() <= most; ++i)
            if (used[i] && std::none_of(corners.begin(), corners.end(), [&](const glm::dvec3& other) {
                    return glm::length(points[i] - other) <= 1e-9 * std::sqrt(area);
                }))
                corners.push_back(points[i]);
        if (corners.size() > most) corners.clear();
        if (corners.size() == 4 && take_rectangle(light, corners, normal, area, up)) return;
        if (take_ellipse(light, corners, normal, area, up)) return;
    }
    const double flux = std::numbers::pi * area * (light.intensity ? light.intensity->number : 0.0);
    only_list(light, what + " is neither a rectangle nor an ellipse",
              fmt::format("it emits {} lm to its front side", rounded(flux, 4)));
}

void join_capsules(std::vector<FoundLight>& lights) {
    // Writers put the spheres directly in front of their cylinder or behind it.
    std::vector<bool> gone(lights.size());
    bool any = false;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto* const tube = lights[i].shape ? std::get_if<TubeShape>(&*lights[i].shape) : nullptr;
        if (tube == nullptr || !lights[i].intensity) continue;
        const glm::dvec3 axis = glm::cross(lights[i].up, -lights[i].direction);
        bool joined = false;
        const auto caps = [&](std::size_t first, std::size_t second) {
            if (first >= lights.size() || second >= lights.size() || gone[first] || gone[second]) return false;
            double sides = 0.0;
            for (const std::size_t at : {first, second}) {
                const auto* const sphere = lights[at].shape ? std::get_if<SphereShape>(&*lights[at].shape) : nullptr;
                if (sphere == nullptr || !lights[at].intensity || !nearly(sphere->radius.value, tube->radius.value) ||
                    !nearly(lights[at].intensity->number, lights[i].intensity->number))
                    return false;
                const double along = glm::dot(lights[at].position - lights[i].position, axis);
                const double tolerance = 1e-6 * tube->length.value;
                if (std::abs(std::abs(along) - 0.5 * tube->length.value) > tolerance ||
                    glm::length(lights[at].position - lights[i].position - along * axis) > tolerance)
                    return false;
                sides += along;
            }
            return std::abs(sides) <= 1e-5 * tube->length.value;
        };
        for (const auto& [first, second] :
             {std::pair{i - 2, i - 1}, std::pair{i - 1, i + 1}, std::pair{i + 1, i + 2}}) {
            if (!caps(first, second)) continue;
            gone[first] = gone[second] = any = joined = true;
            if (lights[i].name.empty()) lights[i].name = lights[first].name;
            break;
        }
        if (!joined) lights[i].shape = CylinderShape{tube->radius, tube->length};
    }
    if (!any) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!gone[i]) {
            if (kept != i) lights[kept] = std::move(lights[i]);
            ++kept;
        }
    lights.resize(kept);
}

} // namespace gonio::interchange_detail
