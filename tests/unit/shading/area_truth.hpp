// Disks, rectangles and tubes in front of a receiver, in doubles, and their irradiance by quadrature.
//
// The quadrature shares nothing with the closed forms: it integrates ⟨n·ω⟩ over area, not along the outline. Disk and
// rectangle: over their surface, in strips, each clipped by the receiver's plane. Tube: over the half-planes through
// the receiver parallel to the axis; in each of them the tube is two circles and the part between them.
#pragma once

#include <gonio/measure/hostile_poses.hpp>

#include "poses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace area {

using poses::Random;
using poses::Vec;

using gonio::measure::hostile::bounding_radius;
using gonio::measure::hostile::exact;
using gonio::measure::hostile::Pose;
using gonio::measure::hostile::Shape;
using gonio::measure::hostile::subtended;

// The largest change of the result when one input moves to a neighbouring double: no code can be more accurate.
inline double conditioning(const Pose& pose) {
    const double base = exact<double>(pose);
    double worst = 0.0;
    for (int k = 0; k < 14; ++k)
        for (const double direction : {-1e300, 1e300}) {
            Pose moved = pose;
            double* const inputs[14] = {&moved.center.x, &moved.center.y, &moved.center.z, &moved.axis.x,
                                        &moved.axis.y,   &moved.axis.z,   &moved.across.x, &moved.across.y,
                                        &moved.across.z, &moved.normal.x, &moved.normal.y, &moved.normal.z,
                                        &moved.p,        &moved.q};
            *inputs[k] = std::nextafter(*inputs[k], direction);
            worst = std::max(worst, std::fabs(exact<double>(moved) - base));
        }
    return worst;
}

using Real = long double;

// ∫ f over [low, high]: double-exponential quadrature (Takahasi and Mori, 1974), insensitive to behaviour at the ends.
template<class Integrand>
Real integrate(Real low, Real high, const Integrand& f) {
    struct Node {
        Real from_end, weight;
    };
    static const std::vector<Node> nodes = [] {
        constexpr int count = 34;
        constexpr Real step = 3.3L / count;
        const Real half = std::numbers::pi_v<Real> / 2;
        std::vector<Node> made;
        for (int i = 0; i <= count; ++i) {
            const Real t = step * static_cast<Real>(i);
            const Real u = half * std::sinh(t);
            const Real c = std::cosh(u);
            made.push_back({1 / (std::exp(u) * c), step * half * std::cosh(t) / (c * c)}); // 1 − tanh u
        }
        return made;
    }();
    if (!(high > low)) return 0;
    const Real length = (high - low) / 2;
    Real sum = nodes[0].weight * f(low + length);
    for (std::size_t i = 1; i < nodes.size(); ++i)
        sum += nodes[i].weight * (f(low + length * nodes[i].from_end) + f(high - length * nodes[i].from_end));
    return sum * length;
}

// The same over pieces split at the numbers of `at` that lie inside, where f has kinks or peaks.
template<class Integrand>
Real integrate_split(Real low, Real high, const std::vector<Real>& at, const Integrand& f) {
    std::vector<Real> ends{low, high};
    for (const Real x : at)
        if (x > low && x < high) ends.push_back(x);
    std::sort(ends.begin(), ends.end());
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        sum += integrate(ends[i], ends[i + 1], f);
    return sum;
}

// Splits around a peak of the given width, so that the pieces are smooth.
inline std::vector<Real> around(Real peak, Real width) {
    std::vector<Real> at{peak};
    for (Real w = width; w < 1e5L * width; w *= 4)
        at.insert(at.end(), {peak - w, peak + w});
    return at;
}

// Disk and rectangle: strips along `x`, each from −y to y of the outline, clipped to up + x up_x + y up_y ≥ 0.
inline Real flat_by_quadrature(const Pose& pose) {
    const Vec x_axis = poses::unit(pose.across);
    const Vec y_axis = gonio::shading::cross(pose.axis, x_axis);
    const auto dot = [](Vec a, Vec b) { return Real(a.x) * b.x + Real(a.y) * b.y + Real(a.z) * b.z; };
    const Real toward = -dot(pose.axis, pose.center);
    if (toward <= 0) return 0;
    const Real up = dot(pose.normal, pose.center);
    const Real up_x = dot(pose.normal, x_axis);
    const Real up_y = dot(pose.normal, y_axis);
    const Real cx = dot(pose.center, x_axis);
    const Real cy = dot(pose.center, y_axis);
    const bool disk = pose.shape == Shape::disk;
    const Real half_x = disk ? Real(pose.p) : Real(pose.p) / 2;
    const auto half_y = [&](Real x) { return disk ? std::sqrt((half_x - x) * (half_x + x)) : Real(pose.q) / 2; };
    const auto strip = [&](Real x) -> Real {
        Real low = -half_y(x);
        Real high = -low;
        const Real level = up + x * up_x;
        if (up_y > 0) low = std::max(low, -level / up_y);
        if (up_y < 0) high = std::min(high, -level / up_y);
        if (up_y == 0 && level <= 0) return 0;
        const Real away2 = toward * toward + (cx + x) * (cx + x);
        return integrate_split(low, high, around(-cy, std::sqrt(away2)), [&](Real y) {
            const Real d2 = away2 + (cy + y) * (cy + y);
            return std::max(level + y * up_y, Real(0)) / (d2 * d2);
        });
    };
    std::vector<Real> splits = around(-cx, toward);
    if (up_x != 0 && up_y != 0) { // where the clipped end of the strips sweeps over the peak
        const auto sweep = around(-(up - cy * up_y) / up_x, toward * std::fabs(up_y / up_x));
        splits.insert(splits.end(), sweep.begin(), sweep.end());
    }
    // Kinks: where the receiver's plane meets the outline.
    Real kink[2] = {2 * half_x, 2 * half_x};
    if (disk) {
        const Real tilt2 = up_x * up_x + up_y * up_y;
        const Real root = half_x * half_x * tilt2 - up * up;
        if (root > 0) {
            kink[0] = (-up * up_x - std::fabs(up_y) * std::sqrt(root)) / tilt2;
            kink[1] = (-up * up_x + std::fabs(up_y) * std::sqrt(root)) / tilt2;
        }
    } else if (up_x != 0) {
        kink[0] = -(up + up_y * half_y(0)) / up_x;
        kink[1] = -(up - up_y * half_y(0)) / up_x;
    }
    splits.insert(splits.end(), {kink[0], kink[1]});
    return toward * integrate_split(-half_x, half_x, splits, strip);
}

// Only outside the extended cylinder (D > r).
inline Real tube_by_quadrature(const Pose& pose) {
    const auto dot = [](Vec a, Vec b) { return Real(a.x) * b.x + Real(a.y) * b.y + Real(a.z) * b.z; };
    const Real z = dot(pose.axis, pose.center);
    const Vec to_line = gonio::shading::detail::perpendicular(pose.center, pose.axis);
    const Real distance = std::sqrt(dot(to_line, to_line));
    const Vec f = poses::unit(to_line);
    const Vec g = gonio::shading::cross(pose.axis, f);
    const Real n_a = dot(pose.normal, pose.axis);
    const Real n_f = dot(pose.normal, f);
    const Real n_g = dot(pose.normal, g);
    const Real r = pose.p;
    const Real z0 = z - Real(pose.q) / 2;
    const Real z1 = z + Real(pose.q) / 2;
    const Real widest = std::asin(r / distance);
    const Real quarter = std::numbers::pi_v<Real> / 2;
    // The half-plane at azimuth α: ω = cosβ(cosα f + sinα g) + sinβ a, dω = cosβ dβ dα; the light from low to high.
    struct Slice {
        Real low, high, zenith, steep; // n·ω = steep cos(β − zenith)
    };
    const auto slice = [&](Real alpha) -> Slice {
        const Real x = distance * std::cos(alpha);
        const Real sine = distance * std::sin(alpha);
        const Real rho = std::sqrt(std::max((r - sine) * (r + sine), Real(0)));
        const auto spread = [&](Real end) { return std::asin(std::min(rho / std::hypot(x, end), Real(1))); };
        const Real n_e = n_f * std::cos(alpha) + n_g * std::sin(alpha);
        return {std::atan2(z0, x) - spread(z0), std::atan2(z1, x) + spread(z1), std::atan2(n_a, n_e),
                std::hypot(n_a, n_e)};
    };
    const auto of_slice = [&](Real alpha) -> Real {
        const Slice s = slice(alpha);
        return s.steep * integrate(std::max({s.low, -quarter, s.zenith - quarter}),
                                   std::min({s.high, quarter, s.zenith + quarter}), [&](Real beta) {
                                       return std::cos(beta) * std::max(std::cos(beta - s.zenith), Real(0));
                                   });
    };
    // Kinks where the horizon passes an end of the slice.
    const auto height = [&](Real alpha, bool of_high) {
        const Slice s = slice(alpha);
        return std::cos((of_high ? s.high : s.low) - s.zenith);
    };
    std::vector<Real> kinks{0};
    for (const bool of_high : {false, true}) {
        constexpr int scan = 200;
        for (int i = 0; i < scan; ++i) {
            Real a = widest * (-1 + 2 * Real(i) / scan);
            Real b = widest * (-1 + 2 * Real(i + 1) / scan);
            if ((height(a, of_high) < 0) == (height(b, of_high) < 0)) continue;
            for (int k = 0; k < 60; ++k) {
                const Real m = (a + b) / 2;
                ((height(m, of_high) < 0) == (height(a, of_high) < 0) ? a : b) = m;
            }
            kinks.push_back(a);
        }
    }
    return integrate_split(-widest, widest, kinks, of_slice);
}

inline double by_quadrature(const Pose& pose) {
    return static_cast<double>(pose.shape == Shape::tube ? tube_by_quadrature(pose) : flat_by_quadrature(pose));
}

} // namespace area
