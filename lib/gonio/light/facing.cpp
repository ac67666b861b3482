#include <gonio/light/facing.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

// A/√(1+A²) · atan(B/√(1+A²))
double corner_term(double a, double b) {
    const double root = std::hypot(1.0, a);
    return a / root * std::atan(b / root);
}

} // namespace

double facing_illuminance(const SphereShape& sphere, Meters distance) {
    const double s = sphere.radius / distance;
    return pi * s * s;
}

double facing_illuminance(const DiskShape& disk, Meters distance) {
    const double s = disk.radius.value / std::hypot(distance.value, disk.radius.value);
    return pi * s * s;
}

double facing_illuminance(const RectShape& rect, Meters distance) {
    const double a = 0.5 * (rect.width / distance);
    const double b = 0.5 * (rect.height / distance);
    return 2.0 * (corner_term(a, b) + corner_term(b, a));
}

double facing_illuminance(const TubeShape& tube, Meters distance) {
    // In units of d.
    const double s = std::min(tube.radius / distance, 1.0);
    const double z = 0.5 * (tube.length / distance);
    const double kappa = std::sqrt((1.0 - s) * (1.0 + s));
    const double end = std::hypot(1.0, z);
    const double h = std::atan2(end * kappa, s * z);
    const double sin_end = s / end;
    const double arcs = 2.0 * s * std::atan2(z, kappa);
    const double caps = 2.0 * sin_end / end * (sin_end * h + std::hypot(kappa, z) / end * z * std::sin(h));
    return arcs + caps;
}

} // namespace gonio
