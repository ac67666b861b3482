// The distance from which a luminaire is a point, against the plain search: every element and direction, by halves.
#include <gonio/base/diagnostics.hpp>
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

std::vector<Element> elements_of(const LuminousBody& body) {
    std::vector<Element> all;
    for (const LuminousFace& face : body.faces()) {
        const auto add = [&](double x, double y) {
            all.push_back({face.frame.origin + x * face.frame.x + y * face.frame.y, face.normal, face.area_m2 / 36});
        };
        const auto round = [&](double half_x, double half_y) {
            for (int i = 0; i < 36; ++i) {
                const double r = std::sqrt((i + 0.5) / 36);
                add(half_x * r * std::cos(golden_angle * i), half_y * r * std::sin(golden_angle * i));
            }
        };
        if (const auto* const rect = std::get_if<RectShape>(&face.shape)) {
            for (int i = 0; i < 36; ++i)
                add(((i / 6 + 0.5) / 6 - 0.5) * rect->width.value, ((i % 6 + 0.5) / 6 - 0.5) * rect->height.value);
        } else if (const auto* const disk = std::get_if<DiskShape>(&face.shape)) {
            round(disk->radius.value, disk->radius.value);
        } else if (const auto* const ellipse = std::get_if<EllipseShape>(&face.shape)) {
            round(0.5 * ellipse->width.value, 0.5 * ellipse->height.value);
        } else if (const auto* const sphere = std::get_if<SphereShape>(&face.shape)) {
            for (int i = 0; i < 100; ++i)
                all.push_back({sphere->radius.value * on_spiral(i, 100), on_spiral(i, 100), face.area_m2 / 100});
        }
    }
    return all;
}

double over_point(const LuminousBody& body, const Web& web, const std::vector<Element>& elements,
                  const glm::dvec3& direction, double distance_m) {
    double lx = 0.0;
    for (const Element& element : elements) {
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
double error_at(const LuminousBody& body, const Web& web, const std::vector<Element>& elements, double distance_m) {
    std::vector<std::pair<double, double>> errors; // and the candela that have them
    double all = 0.0;
    for (int i = 0; i < 120; ++i) {
        const glm::dvec3 direction = on_spiral(i, 120);
        const double candela = web.candela(direction);
        if (!(candela > 0.0)) continue;
        errors.emplace_back(std::abs(over_point(body, web, elements, direction, distance_m) - 1.0), candela);
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

double plain_distance_m(const LuminousBody& body, const Web& web, double tolerance) {
    const std::vector<Element> elements = elements_of(body);
    double size_m = 0.0;
    for (const Element& element : elements)
        size_m = std::max(size_m, 2.0 * glm::length(element.position));
    int far = 0;
    int near = static_cast<int>(std::log(64.0) / std::log(1.05)) + 1;
    while (near - far > 1) {
        const int middle = (far + near) / 2;
        const double distance_m = 64.0 * size_m / std::pow(1.05, middle);
        (error_at(body, web, elements, distance_m) <= tolerance ? far : near) = middle;
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
            for (const double tolerance : {0.01, 0.1})
                EXPECT_EQ(point_distance(*body, web, tolerance).value, plain_distance_m(*body, web, tolerance))
                    << file << ' ' << static_cast<int>(opening.shape) << ' ' << tolerance;
        }
    }
    EXPECT_GE(compared, 80);
}

} // namespace
} // namespace gonio
