// The distance from which a luminaire is a point, against the plain search: every element and direction, by halves.
#include <gonio/base/diagnostics.hpp>
#include <gonio/base/frame.hpp>
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/light/far_field.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {
namespace {

constexpr double golden_angle = 2.399963229728653;

struct Element {
    glm::dvec3 position;
    glm::dvec3 normal;
    double area_m2;
};

glm::dvec3 on_spiral(int i, int count) {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double r = std::sqrt((1.0 - z) * (1.0 + z));
    return {r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z};
}

std::vector<QuadratureNode> midpoints(int count) {
    std::vector<QuadratureNode> all;
    for (int i = 0; i < count; ++i)
        all.push_back({(2.0 * i + 1.0) / count - 1.0, 2.0 / count});
    return all;
}

// By what a face is divided.
struct Rules {
    std::vector<QuadratureNode> along_side;
    std::vector<QuadratureNode> rings;
    int points_of_ring;
};
template<std::size_t count>
std::vector<QuadratureNode> gauss_nodes() {
    constexpr auto rule = gauss_legendre<count>();
    return {rule.begin(), rule.end()};
}
const Rules few{gauss_nodes<4>(), gauss_nodes<3>(), 8};
const Rules dense{midpoints(14), midpoints(10), 20};

// As a receiver in a direction and at a distance sees them.
std::vector<Element> elements_of(const LuminousBody& body, const Rules& rules, const glm::dvec3& direction,
                                 double distance_m) {
    std::vector<Element> all;
    for (const LuminousFace& face : body.faces()) {
        const auto add = [&](double x, double y, double share) {
            all.push_back({face.frame.origin + x * face.frame.x + y * face.frame.y, face.normal, face.area_m2 * share});
        };
        const auto round = [&](double half_x, double half_y) {
            for (std::size_t ring = 0; ring < rules.rings.size(); ++ring)
                for (int i = 0; i < rules.points_of_ring; ++i) {
                    const double r = std::sqrt(0.5 * (1.0 + rules.rings[ring].at));
                    const double angle =
                        2.0 * std::numbers::pi * (i + (ring % 2 == 0 ? 0.0 : 0.5)) / rules.points_of_ring;
                    add(half_x * r * std::cos(angle), half_y * r * std::sin(angle),
                        0.5 * rules.rings[ring].weight / rules.points_of_ring);
                }
        };
        if (const auto* const rect = std::get_if<RectShape>(&face.shape)) {
            for (const QuadratureNode& x : rules.along_side)
                for (const QuadratureNode& y : rules.along_side)
                    add(0.5 * x.at * rect->width.value, 0.5 * y.at * rect->height.value, 0.25 * x.weight * y.weight);
        } else if (const auto* const disk = std::get_if<DiskShape>(&face.shape)) {
            round(disk->radius.value, disk->radius.value);
        } else if (const auto* const ellipse = std::get_if<EllipseShape>(&face.shape)) {
            round(0.5 * ellipse->width.value, 0.5 * ellipse->height.value);
        } else if (const auto* const sphere = std::get_if<SphereShape>(&face.shape)) {
            // What is seen from there: rings about the direction.
            const std::vector<QuadratureNode>& rings = rules.along_side;
            const double least = sphere->radius.value / distance_m;
            const Frame about = aimed_frame(glm::dvec3(0.0), direction, {0.0, 0.0, 1.0});
            for (std::size_t ring = 0; ring < rings.size(); ++ring)
                for (int i = 0; i < rules.points_of_ring; ++i) {
                    const double half = 0.5 * (1.0 - least);
                    const double z = least + half * (1.0 + rings[ring].at);
                    const double r = std::sqrt((1.0 - z) * (1.0 + z));
                    const double angle =
                        2.0 * std::numbers::pi * (i + (ring % 2 == 0 ? 0.0 : 0.5)) / rules.points_of_ring;
                    const glm::dvec3 normal =
                        z * direction + r * (std::cos(angle) * about.x + std::sin(angle) * about.y);
                    all.push_back({sphere->radius.value * normal, normal,
                                   half * 0.5 * rings[ring].weight / rules.points_of_ring * face.area_m2});
                }
        }
    }
    return all;
}

double size_m_of(const LuminousBody& body) {
    double size_m = 0.0;
    for (const LuminousFace& face : body.faces()) {
        const auto reach = [&](double x, double y) {
            size_m = std::max(size_m, 2.0 * glm::length(face.frame.origin + x * face.frame.x + y * face.frame.y));
        };
        const auto rim = [&](double half_x, double half_y) {
            for (int i = 0; i < 32; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / 32;
                reach(half_x * std::cos(angle), half_y * std::sin(angle));
            }
        };
        if (const auto* const rect = std::get_if<RectShape>(&face.shape)) {
            for (const double x : {-0.5, 0.5})
                for (const double y : {-0.5, 0.5})
                    reach(x * rect->width.value, y * rect->height.value);
        } else if (const auto* const disk = std::get_if<DiskShape>(&face.shape)) {
            rim(disk->radius.value, disk->radius.value);
        } else if (const auto* const ellipse = std::get_if<EllipseShape>(&face.shape)) {
            rim(0.5 * ellipse->width.value, 0.5 * ellipse->height.value);
        } else if (const auto* const sphere = std::get_if<SphereShape>(&face.shape)) {
            size_m = std::max(size_m, 2.0 * sphere->radius.value);
        }
    }
    return size_m;
}

double over_point(const LuminousBody& body, const Web& web, const Rules& rules, const glm::dvec3& direction,
                  double distance_m) {
    double lx = 0.0;
    for (const Element& element : elements_of(body, rules, direction, distance_m)) {
        const glm::dvec3 away = distance_m * direction - element.position;
        const double r2 = glm::dot(away, away);
        const double at_light = glm::dot(away, element.normal);
        const double at_receiver = glm::dot(away, direction);
        if (!(at_light > 0.0) || !(at_receiver > 0.0)) continue;
        const double nt = std::max(web.candela(away), 0.0) / body.projected_area_m2(away);
        lx += nt * at_light * at_receiver * element.area_m2 / (r2 * r2);
    }
    return lx * distance_m * distance_m / web.candela(direction);
}

// The error that the directions of at most 5 % of the light exceed.
double error_at(const LuminousBody& body, const Web& web, const Rules& rules, double distance_m) {
    std::vector<std::pair<double, double>> errors; // and the candela that have them
    double all = 0.0;
    for (int i = 0; i < 120; ++i) {
        const glm::dvec3 direction = on_spiral(i, 120);
        const double candela = web.candela(direction);
        if (!(candela > 0.0)) continue;
        errors.emplace_back(std::abs(over_point(body, web, rules, direction, distance_m) - 1.0), candela);
        all += candela;
    }
    std::sort(errors.begin(), errors.end(), std::greater<>());
    double above = 0.0;
    for (const auto& [error, candela] : errors) {
        above += candela;
        if (above > (1.0 - 0.95) * all) return error;
    }
    return 0.0;
}

double plain_distance_m(const LuminousBody& body, const Web& web, double tolerance, const Rules& rules) {
    const double size_m = size_m_of(body);
    int far = 0;
    int near = static_cast<int>(std::log(64.0) / std::log(1.05)) + 1;
    while (near - far > 1) {
        const int middle = (far + near) / 2;
        const double distance_m = 64.0 * size_m / std::pow(1.05, middle);
        (error_at(body, web, rules, distance_m) <= tolerance ? far : near) = middle;
    }
    return 64.0 * size_m / std::pow(1.05, far);
}

std::vector<std::string> profiles() {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(test::source_folder) + "/profiles"))
        if (entry.path().extension() == ".ies" || entry.path().extension() == ".ldt")
            all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(FarField, IsTheDistanceOfThePlainSearchForEveryOpening) {
    int compared = 0;
    for (const std::string& file : profiles()) {
        const Profile profile = read_profile_file(file).value();
        const Web web = resolve_web(profile).value().web;
        std::vector<Opening> openings{opening_of(profile)};
        for (const OpeningShape shape :
             {OpeningShape::rectangle, OpeningShape::disk, OpeningShape::ellipse, OpeningShape::upright_disk,
              OpeningShape::box, OpeningShape::vertical_cylinder, OpeningShape::horizontal_cylinder,
              OpeningShape::ellipsoid, OpeningShape::sphere}) {
            Opening opening;
            opening.shape = shape;
            opening.size_m = {0.3, shape == OpeningShape::upright_disk ? 0.0 : 0.3, 0.3};
            if (shape == OpeningShape::rectangle || shape == OpeningShape::disk) opening.size_m.z = 0.0;
            openings.push_back(opening);
        }
        for (const Opening& opening : openings) {
            const auto body = LuminousBody::of(opening, web);
            if (!body) continue;
            ++compared;
            for (const double tolerance : {0.01, 0.1}) {
                const double found_m = point_distance(*body, web, tolerance).value;
                EXPECT_EQ(found_m, plain_distance_m(*body, web, tolerance, few))
                    << file << ' ' << static_cast<int>(opening.shape) << ' ' << tolerance;
                // As with many more elements, to one step of the search.
                const bool is_looked_at = tolerance == 0.01 && file.ends_with(".ies");
                const double finely_m = is_looked_at ? plain_distance_m(*body, web, tolerance, dense) : found_m;
                EXPECT_LT(std::abs(std::log(found_m / finely_m)), 1.01 * std::log(1.05))
                    << file << ' ' << static_cast<int>(opening.shape);
            }
        }
    }
    EXPECT_GE(compared, 80);
}

} // namespace
} // namespace gonio
