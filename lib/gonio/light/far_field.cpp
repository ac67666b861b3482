#include <gonio/light/far_field.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

namespace {

constexpr double golden_angle = 2.399963229728653;
constexpr double share_of_light = 0.95;

// A small piece of a face.
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

struct ElementsOf {
    const LuminousFace& face;
    std::vector<Element>& to;

    void operator()(const RectShape& rect) const {
        constexpr int n = 6;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                add(((i + 0.5) / n - 0.5) * rect.width.value, ((j + 0.5) / n - 0.5) * rect.height.value, n * n);
    }
    void operator()(const DiskShape& disk) const { round(disk.radius.value, disk.radius.value); }
    void operator()(const EllipseShape& ellipse) const { round(0.5 * ellipse.width.value, 0.5 * ellipse.height.value); }
    void operator()(const SphereShape& sphere) const {
        constexpr int n = 100;
        for (int i = 0; i < n; ++i) {
            const glm::dvec3 normal = on_spiral(i, n);
            to.push_back({sphere.radius.value * normal, normal, face.area_m2 / n});
        }
    }
    template<class Kind>
    void operator()(const Kind& /*no face*/) const {}

private:
    void round(double half_x, double half_y) const {
        constexpr int n = 36;
        for (int i = 0; i < n; ++i) {
            const double r = std::sqrt((i + 0.5) / n);
            add(half_x * r * std::cos(golden_angle * i), half_y * r * std::sin(golden_angle * i), n);
        }
    }
    void add(double x, double y, int count) const {
        to.push_back({face.frame.origin + x * face.frame.x + y * face.frame.y, face.normal, face.area_m2 / count});
    }
};

// The illuminance of a receiver that faces the middle, over that of a point.
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

} // namespace

Meters point_distance(const LuminousBody& body, const Web& web, double tolerance) {
    std::vector<Element> elements;
    double size_m = 0.0;
    for (const LuminousFace& face : body.faces())
        std::visit(ElementsOf{face, elements}, face.shape);
    for (const Element& element : elements)
        size_m = std::max(size_m, 2.0 * glm::length(element.position));
    struct Lit {
        glm::dvec3 direction;
        double candela;
    };
    constexpr int directions = 120;
    std::vector<Lit> lit;
    double all = 0.0;
    for (int i = 0; i < directions; ++i) {
        const glm::dvec3 direction = on_spiral(i, directions);
        const double candela = web.candela(direction);
        if (!(candela > 0.0)) continue;
        lit.push_back({direction, candela});
        all += candela;
    }
    // The error that the directions of at most 5 % of the light exceed.
    std::vector<std::pair<double, double>> errors; // and the candela that have them
    const auto error_at = [&](double distance_m) {
        errors.clear();
        for (const Lit& towards : lit)
            errors.emplace_back(std::abs(over_point(body, web, elements, towards.direction, distance_m) - 1.0),
                                towards.candela);
        std::sort(errors.begin(), errors.end(), std::greater<>());
        double above = 0.0;
        for (const auto& [error, candela] : errors) {
            above += candela;
            if (above > (1.0 - share_of_light) * all) return error;
        }
        return 0.0;
    };
    // Among steps of 5 % from 64 sizes, which count as far, down to one, the last that is far: the error is taken to
    // fall with the distance. It falls by nearly the square of it, which guesses the step; halves follow if that is
    // wrong.
    const double step = 1.05;
    const auto distance_after = [&](int count) { return 64.0 * size_m / std::pow(step, count); };
    constexpr int most_guesses = 6;
    int far = 0;
    int near = static_cast<int>(std::log(64.0) / std::log(step)) + 1;
    int next = (far + near) / 2;
    for (int guesses = 1; near - far > 1; ++guesses) {
        const double error = error_at(distance_after(next));
        (error <= tolerance ? far : near) = next;
        const double more = 0.5 * std::log(error / tolerance) / std::log(step); // steps back to where it is far
        const double guess =
            std::isfinite(more) && guesses < most_guesses ? next - std::ceil(more) : 0.5 * (far + near);
        next = std::clamp(static_cast<int>(guess), far + 1, std::max(near - 1, far + 1));
    }
    return Meters(distance_after(far));
}

} // namespace gonio
