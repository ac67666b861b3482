#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_sample.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::measure {

namespace {

using Kind = shading::LightConstants::Kind;
using Vec = shading::vec3<double>;
using shading::dot;

constexpr double pi = std::numbers::pi;

// A direction (of any length) for a point (u, v) of the unit square, and dω/(du dv).
struct Point {
    Vec toward;
    double density;
};

Vec vec(const float (&v)[3]) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

// The cap of half angle σ about `center`, uniform in solid angle.
auto cap(Vec center, double sine) {
    const shading::TangentFrame<double> frame(shading::normalized(center));
    const double cosine = std::sqrt((1.0 - sine) * (1.0 + sine));
    const double height = sine * sine / (1.0 + cosine);
    return [frame, height](double u, double v) {
        const double h = height * u;
        const double r = std::sqrt(h * (2.0 - h));
        const double phi = 2.0 * pi * v;
        return Point{frame.to_world({r * std::cos(phi), r * std::sin(phi), 1.0 - h}), 2.0 * pi * height};
    };
}

template<class ToPoint, class ToArea>
auto flat(Vec axis, ToPoint point, ToArea area) {
    return [axis, point, area](double u, double v) {
        const Vec p = point(u, v);
        const double square = dot(p, p);
        const double facing = std::max(-dot(axis, p), 0.0);
        return Point{p, area(u) * facing / (square * std::sqrt(square))};
    };
}

// Half planes through a line parallel to the axis; each cuts the capsule in a rectangle with round ends, of which a
// cylinder without caps has only the nearer side.
auto capsule(Vec center, Vec axis, double r, double half, bool is_capped) {
    const double z = dot(axis, center);
    const Vec across = center - axis * z;
    const double d = shading::length(across);
    const Vec f = across * (1.0 / d);
    const Vec g = shading::cross(axis, f);
    const double widest = std::asin(r / d);
    return [=](double u, double v) {
        // Uniform in the angle s of the sine, so that the width has no square root at its ends.
        const double s = (2.0 * u - 1.0) * pi / 2.0;
        const double w = widest * std::sin(s);
        const double near = d * std::cos(w);
        const double off = d * std::sin(w);
        const double thick = std::sqrt(std::max(r * r - off * off, 0.0));
        const auto edge = [&](double at, double sign) {
            if (!is_capped) return std::atan2(at, near - thick);
            return std::atan2(at, near) + sign * std::asin(std::min(thick / std::hypot(at, near), 1.0));
        };
        const double from = edge(z - half, -1.0);
        const double to = edge(z + half, 1.0);
        const double t = from + (to - from) * v;
        const Vec out = f * std::cos(w) + g * std::sin(w);
        return Point{out * std::cos(t) + axis * std::sin(t), std::cos(t) * (to - from) * widest * pi * std::cos(s)};
    };
}

constexpr std::size_t order = 7;
constexpr double nodes[order] = {-0.94910791234275852, -0.74153118559939444, -0.40584515137739717, 0.0,
                                 0.40584515137739717,  0.74153118559939444,  0.94910791234275852};
constexpr double weights[order] = {0.12948496616886969, 0.27970539148927667, 0.38183005050511894, 0.41795918367346939,
                                   0.38183005050511894, 0.27970539148927667, 0.12948496616886969};

// The integral over a region: a function of two numbers in [0, 1] that gives a Point.
template<class Region>
class Integral {
public:
    Integral(const Region& region, Vec normal, const LobeValue& lobe) : region_(region), normal_(normal), lobe_(lobe) {}

    double value() {
        constexpr int cells = 12;
        constexpr double step = 1.0 / cells;
        double first = 0.0;
        for (int i = 0; i < cells; ++i)
            for (int k = 0; k < cells; ++k)
                first += cell(i * step, k * step, step);
        // A narrow peak at one of the points makes the first sum far too large, and the tolerance with it.
        double sum = first;
        double before = 0.0;
        do {
            before = sum;
            tolerance_ = 1e-6 * before / cells;
            sum = 0.0;
            for (int i = 0; i < cells; ++i)
                for (int k = 0; k < cells; ++k)
                    sum += refined(i * step, k * step, step, cell(i * step, k * step, step), 0);
        } while (sum < 0.5 * before);
        return sum;
    }

private:
    double cell(double u, double v, double side) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < order; ++i)
            for (std::size_t k = 0; k < order; ++k) {
                const Point p = region_(u + side * 0.5 * (1.0 + nodes[i]), v + side * 0.5 * (1.0 + nodes[k]));
                const Vec l = shading::normalized(p.toward);
                const double cosine = dot(normal_, l);
                if (cosine <= 0.0) continue;
                sum += weights[i] * weights[k] * p.density * cosine * lobe_(l);
            }
        return sum * side * side * 0.25;
    }
    // The tolerance is the same at every depth: there are few deep cells.
    double refined(double u, double v, double side, double whole, int depth) const { // NOLINT(misc-no-recursion)
        const double h = 0.5 * side;
        const double quarters[4] = {cell(u, v, h), cell(u + h, v, h), cell(u, v + h, h), cell(u + h, v + h, h)};
        const double sum = quarters[0] + quarters[1] + quarters[2] + quarters[3];
        if (depth >= 9 || std::fabs(sum - whole) <= tolerance_) return sum;
        return refined(u, v, h, quarters[0], depth + 1) + refined(u + h, v, h, quarters[1], depth + 1) +
               refined(u, v + h, h, quarters[2], depth + 1) + refined(u + h, v + h, h, quarters[3], depth + 1);
    }

    const Region& region_;
    Vec normal_;
    const LobeValue& lobe_;
    double tolerance_ = 0.0;
};

// Calls integrate(region) for the visible part of the light.
template<class Integrate>
double over_light(const shading::LightConstants& light, Vec center, Vec normal, const Integrate& integrate) {
    const auto r = static_cast<double>(light.radius);
    Vec axis = vec(light.axis);
    if (light.two_sided && dot(axis, center) > 0.0) axis = axis * -1.0;
    const auto sphere = [&](Vec at) {
        const double d = shading::length(at);
        return d < r ? integrate(cap(normal, 1.0)) : integrate(cap(at, r / d));
    };
    switch (light.kind) {
    case Kind::sphere:
        return sphere(center);
    case Kind::disk: {
        const shading::TangentFrame<double> frame(axis);
        return integrate(flat(
            axis,
            [=](double u, double v) {
                return center + frame.to_world({r * u * std::cos(2.0 * pi * v), r * u * std::sin(2.0 * pi * v), 0.0});
            },
            [r](double u) { return 2.0 * pi * r * r * u; }));
    }
    case Kind::ellipse: {
        const Vec x = vec(light.width_direction) * (0.5 * static_cast<double>(light.width));
        const Vec y = shading::cross(axis, vec(light.width_direction)) * (0.5 * static_cast<double>(light.height));
        const double area = 0.25 * pi * static_cast<double>(light.width) * static_cast<double>(light.height);
        return integrate(flat(
            axis,
            [=](double u, double v) {
                return center + x * (u * std::cos(2.0 * pi * v)) + y * (u * std::sin(2.0 * pi * v));
            },
            [area](double u) { return 2.0 * area * u; }));
    }
    case Kind::rectangle: {
        const Vec x = vec(light.width_direction) * static_cast<double>(light.width);
        const Vec y = shading::cross(axis, vec(light.width_direction)) * static_cast<double>(light.height);
        const double area = static_cast<double>(light.width) * static_cast<double>(light.height);
        return integrate(flat(
            axis, [=](double u, double v) { return center + x * (u - 0.5) + y * (v - 0.5); },
            [area](double) { return area; }));
    }
    default:
        break;
    }
    const double half = 0.5 * static_cast<double>(light.length);
    const double z = dot(axis, center);
    if (shading::length(center - axis * z) > r)
        return integrate(capsule(center, axis, r, half, light.kind != Kind::cylinder));
    if (light.kind == Kind::cylinder) return 0.0;
    if (std::fabs(z) <= half) return integrate(cap(normal, 1.0));
    return sphere(center - axis * std::copysign(half, z));
}

} // namespace

double specular_by_quadrature(const shading::LightConstants& light, shading::vec3<double> center,
                              shading::vec3<double> normal, shading::vec3<double> view, const LobeValue& lobe) {
    if (light.kind == Kind::punctual || dot(normal, view) <= 0.0) return 0.0;
    return over_light(light, center, normal,
                      [&](const auto& region) { return Integral(region, normal, lobe).value(); });
}

double specular_by_quadrature(const shading::LightConstants& light, shading::vec3<double> center,
                              shading::vec3<double> normal, shading::vec3<double> view, double alpha) {
    return specular_by_quadrature(light, center, normal, view,
                                  [&](Vec l) { return shading::specular_ggx(normal, l, view, alpha, alpha).scale; });
}

} // namespace gonio::measure
