#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/scene/spatial_illuminance.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>

namespace gonio {

namespace {

constexpr double pi = std::numbers::pi;
constexpr glm::dvec3 zenith(0.0, 0.0, 1.0);
constexpr auto rule = gauss_legendre<16>();

constexpr std::array kinds{
    IlluminanceKindName{IlluminanceKind::planar, "planar", "of a surface with the normal of each point"},
    IlluminanceKindName{IlluminanceKind::horizontal, "horizontal", "of a surface that faces up"},
    IlluminanceKindName{IlluminanceKind::vertical, "vertical", "of an upright surface that faces --normal"},
    IlluminanceKindName{IlluminanceKind::cylindrical, "cylindrical", "mean over all upright surfaces, as on a face"},
    IlluminanceKindName{IlluminanceKind::semi_cylindrical, "semi-cylindrical",
                        "of half a cylinder that faces --normal: a face on a road"},
    IlluminanceKindName{IlluminanceKind::hemispherical, "hemispherical", "of a half sphere on the floor"},
    IlluminanceKindName{IlluminanceKind::modelling, "modelling", "modelling index: cylindrical over horizontal"},
};

double planar(const Light& light, const glm::dvec3& position, const glm::dvec3& normal) {
    return detail::illuminance_of(light, position, normal, {}).illuminance_lx;
}

double radius_of(const Light& light) {
    return with_traits(light.shape, [](const auto& shape, auto traits) { return traits.radius(shape); });
}

// The mean of E over all upright surfaces. A surface that turns sees a light, within the angle δ of its azimuth, wholly
// while its normal is within π/2 − δ of that: there E is A cos + B sin, and B cancels.
double cylindrical(const Light& light, const glm::dvec3& position) {
    const glm::dvec3 to = light.frame.origin - position;
    const double flat = std::hypot(to.x, to.y);
    const double radius = radius_of(light);
    const bool is_around = !(flat > radius);
    const double delta = is_around ? 0.5 * pi : std::asin(radius / flat);
    const double azimuth = is_around ? 0.0 : std::atan2(to.y, to.x);
    const auto at = [&](double angle) {
        return planar(light, position, {std::cos(azimuth + angle), std::sin(azimuth + angle), 0.0});
    };
    double sum = is_around ? 0.0 : 2.0 * std::cos(delta) * at(0.0);
    for (const QuadratureNode& node : rule)
        for (const double side : {-0.5 * pi, 0.5 * pi})
            sum += node.weight * delta * at(side + delta * node.at);
    return sum / (2.0 * pi);
}

// ∫ L dω: 1/π of the integral of E over all directions of a surface. Around the direction to the light it is linear in
// the normal; in the band of normals that have the light on their horizon, it is not.
double scalar(const Light& light, const glm::dvec3& position) {
    const glm::dvec3 to = light.frame.origin - position;
    const double distance = glm::length(to);
    const double radius = radius_of(light);
    const bool is_around = !(distance > radius);
    const double delta = is_around ? 0.5 * pi : std::asin(radius / distance);
    const Frame frame = aimed_frame({}, is_around ? -zenith : to, {0.0, 1.0, 0.0});
    const glm::dvec3 axis = -frame.z;
    double sum = is_around ? 0.0 : pi * std::cos(delta) * std::cos(delta) * planar(light, position, axis);
    constexpr int turns = 32;
    for (const QuadratureNode& node : rule) {
        const double theta = 0.5 * pi + delta * node.at;
        const double c = std::cos(theta);
        const double s = std::sin(theta);
        double ring = 0.0;
        for (int i = 0; i < turns; ++i) {
            const double phi = 2.0 * pi * (i + 0.5) / turns;
            ring += planar(light, position, c * axis + s * (std::cos(phi) * frame.x + std::sin(phi) * frame.y));
        }
        sum += node.weight * delta * s * ring * 2.0 * pi / turns;
    }
    return sum / pi;
}

// The share of a beam of 1 lx.
double beam_share(IlluminanceKind kind, const glm::dvec3& direction, const glm::dvec3& normal) {
    const double flat = std::hypot(direction.x, direction.y); // sin ε
    switch (kind) {
    case IlluminanceKind::cylindrical:
        return flat / pi;
    case IlluminanceKind::semi_cylindrical:
        return (flat + direction.x * normal.x + direction.y * normal.y) / pi;
    default:
        return 0.25 * (1.0 + direction.z);
    }
}

// Half the sides of a flat light, or half the axes of a round one.
struct FlatFace {
    double half_x = 0.0;
    double half_y = 0.0;
    bool is_round = false;
    bool is_two_sided = false;
};

std::optional<FlatFace> flat_face(const Shape& shape) {
    if (const auto* const rect = std::get_if<RectShape>(&shape))
        return FlatFace{0.5 * rect->width.value, 0.5 * rect->height.value, false, rect->two_sided};
    if (const auto* const disk = std::get_if<DiskShape>(&shape))
        return FlatFace{disk->radius.value, disk->radius.value, true, disk->two_sided};
    if (const auto* const ellipse = std::get_if<EllipseShape>(&shape))
        return FlatFace{0.5 * ellipse->width.value, 0.5 * ellipse->height.value, true, ellipse->two_sided};
    return std::nullopt;
}

// Over the elements of a flat light whose luminance depends on the direction or the place, which makes E itself costly:
// 2 by 2 nodes in cells that are seen under at most about 0.015 rad, finer than the angles of a profile.
double sum_over_face(IlluminanceKind kind, const Light& light, const FlatFace& face, const glm::dvec3& position,
                     const glm::dvec3& normal) {
    constexpr double cell_rad = 0.015;
    constexpr double most_cells = 128.0;
    static constexpr auto nodes = gauss_legendre<2>();
    const glm::dvec3 local = light.frame.to_local(position - light.frame.origin);
    const double away = std::hypot(std::fmax(std::abs(local.x) - face.half_x, 0.0),
                                   std::fmax(std::abs(local.y) - face.half_y, 0.0), local.z);
    const auto cells = [&](double length) {
        return static_cast<int>(std::clamp(std::ceil(length / (cell_rad * away)), 1.0, most_cells));
    };
    // Of a round face: along the radius, and around.
    const int columns = face.is_round ? cells(std::fmax(face.half_x, face.half_y)) : cells(2.0 * face.half_x);
    const int rows =
        face.is_round ? std::max(4, cells(2.0 * pi * std::fmax(face.half_x, face.half_y))) : cells(2.0 * face.half_y);
    double sum = 0.0;
    for (int i = 0; i < columns; ++i)
        for (const QuadratureNode& along : nodes) {
            const double u = (i + 0.5 + 0.5 * along.at) / columns; // 0 to 1
            for (int j = 0; j < rows; ++j)
                for (const QuadratureNode& across : nodes) {
                    const double v = (j + 0.5 + 0.5 * across.at) / rows;
                    const double weight = 0.25 * along.weight * across.weight / (columns * rows);
                    const double x = face.is_round ? u * std::cos(2.0 * pi * v) : 2.0 * u - 1.0;
                    const double y = face.is_round ? u * std::sin(2.0 * pi * v) : 2.0 * v - 1.0;
                    const double area = face.half_x * face.half_y * (face.is_round ? 2.0 * pi * u : 4.0);
                    const glm::dvec3 to = light.frame.origin + face.half_x * x * light.frame.x +
                                          face.half_y * y * light.frame.y - position;
                    const double r = glm::length(to);
                    if (!(r > 0.0)) continue;
                    const glm::dvec3 direction = to / r;
                    const double before = glm::dot(direction, light.frame.z);
                    const double cosine = face.is_two_sided ? std::abs(before) : before;
                    if (!(cosine > 0.0)) continue;
                    sum += weight * area * cosine / (r * r) * light.luminance_share_at(position, direction) *
                           beam_share(kind, direction, normal);
                }
        }
    return light.luminance.value * sum;
}

// E of a surface that faces a light without a size, and the direction to the light.
struct Beam {
    double lx = 0.0;
    glm::dvec3 direction{0.0};
};

Beam beam_of(const Light& light, const glm::dvec3& position) {
    if (std::holds_alternative<SunShape>(light.shape)) return {light.illuminance.value, light.frame.z};
    const std::optional<glm::dvec3> to = unit_vector(light.frame.origin - position);
    if (!to) return {};
    return {planar(light, position, *to), *to};
}

} // namespace

std::span<const IlluminanceKindName> illuminance_kinds() {
    return kinds;
}

Result<IlluminanceKind> parse_illuminance_kind(std::string_view name) {
    return find_named("quantity", name, kinds).map([](const IlluminanceKindName* known) { return known->kind; });
}

bool needs_direction(IlluminanceKind kind) {
    return kind == IlluminanceKind::vertical || kind == IlluminanceKind::semi_cylindrical;
}

double illuminance_of_kind(IlluminanceKind kind, const Light& light, const glm::dvec3& position,
                           const glm::dvec3& normal) {
    if (kind == IlluminanceKind::horizontal) return planar(light, position, zenith);
    if (kind == IlluminanceKind::planar || kind == IlluminanceKind::vertical) return planar(light, position, normal);
    if (detail::consists_of_parts(light, IrradianceMethod::exact)) {
        double sum = 0.0;
        for (const Light& part : *light.parts)
            sum += illuminance_of_kind(kind, part, position, normal);
        return sum;
    }
    const bool is_beam = !has_extent(light.shape) || std::holds_alternative<SunShape>(light.shape);
    if (is_beam) {
        const Beam beam = beam_of(light, position);
        return beam.lx * beam_share(kind, beam.direction, normal);
    }
    const std::optional<FlatFace> face = flat_face(light.shape);
    if (face && light.has_pattern() && !light.range) return sum_over_face(kind, light, *face, position, normal);
    const auto net = [&](const glm::dvec3& n) { return planar(light, position, n) - planar(light, position, -n); };
    if (kind == IlluminanceKind::hemispherical) return std::fmax(0.25 * (scalar(light, position) + net(zenith)), 0.0);
    const double mean = cylindrical(light, position);
    return kind == IlluminanceKind::cylindrical ? mean : std::fmax(mean + net(normal) / pi, 0.0);
}

std::vector<double> illuminance_parts(IlluminanceKind kind, std::span<const Light> lights,
                                      std::span<const Receiver> receivers, unsigned threads) {
    std::vector<double> parts(lights.size() * receivers.size());
    parallel_for(receivers.size(), threads, [&](std::size_t r) {
        const glm::dvec3 normal = unit_vector(receivers[r].normal).value_or(zenith);
        for (std::size_t l = 0; l < lights.size(); ++l)
            parts[r * lights.size() + l] = illuminance_of_kind(kind, lights[l], receivers[r].position, normal);
    });
    return parts;
}

std::vector<WeightedNormal> surfaces_of(IlluminanceKind kind, const glm::dvec3& normal) {
    if (kind == IlluminanceKind::horizontal) return {{zenith, 1.0}};
    if (kind == IlluminanceKind::planar || kind == IlluminanceKind::vertical) return {{normal, 1.0}};
    constexpr int turns = 24;
    std::vector<WeightedNormal> surfaces;
    const auto ring = [&](double z, double weight) {
        const double flat = std::sqrt(1.0 - z * z);
        for (int i = 0; i < turns; ++i) {
            const double angle = 2.0 * pi * (i + 0.5) / turns;
            surfaces.push_back({{flat * std::cos(angle), flat * std::sin(angle), z}, weight / turns});
        }
    };
    if (kind == IlluminanceKind::hemispherical) {
        // ∫ L dω is four times the mean of E over all directions.
        static constexpr auto heights = gauss_legendre<8>();
        for (const QuadratureNode& height : heights)
            ring(height.at, 0.5 * height.weight);
        surfaces.push_back({zenith, 0.25});
        surfaces.push_back({-zenith, -0.25});
        return surfaces;
    }
    ring(0.0, 1.0);
    if (kind == IlluminanceKind::semi_cylindrical) {
        surfaces.push_back({normal, 1.0 / pi});
        surfaces.push_back({-normal, -1.0 / pi});
    }
    return surfaces;
}

} // namespace gonio
