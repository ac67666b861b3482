// The irradiance of sphere, disk, rectangle and capsule by their outlines in long double: a second evaluation of the
// contour integral that shares no step with the library's.
//
// Nothing here avoids cancellation, because long double has 64 bits and can afford to lose some. Outlines are clipped
// piece by piece: each arc is cut where it meets the receiver's plane, and the pieces with their middle above it are
// added up. The library does none of this: it uses no angle of a disk's rim, no azimuth of a capsule's ends, and no
// list of pieces.
#pragma once

#include "area_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace area {

struct LongVec {
    Real x, y, z;
    friend LongVec operator+(LongVec a, LongVec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend LongVec operator-(LongVec a, LongVec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend LongVec operator*(LongVec a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
};
inline LongVec lengthen(Vec a) {
    return {a.x, a.y, a.z};
}
inline Real dot(LongVec a, LongVec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LongVec cross(LongVec a, LongVec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(LongVec a) {
    return std::sqrt(dot(a, a));
}
inline LongVec unit(LongVec a) {
    return a * (1 / length(a));
}

inline constexpr Real long_pi = std::numbers::pi_v<Real>;

// Accumulates a visible outline. Points are relative to the light's centre, so that distant points do not cancel;
// crossings of the horizon are kept in pairs.
struct LongOutline {
    LongVec center, n;
    Real sum = 0;
    std::vector<LongVec> crossings{};

    Real angle(LongVec from, LongVec step) const {
        const LongVec p = center + from;
        return std::atan2(length(cross(p, step)), dot(p, p + step));
    }

    Real finish() {
        // A convex outline leaves at most one gap.
        if (crossings.size() >= 2) sum += angle(crossings[0], crossings[1] - crossings[0]) / 2;
        return std::clamp(sum, Real(0), long_pi);
    }

    void great_arc(LongVec p, LongVec q) {
        const Real from = dot(n, center + p);
        const Real to = from + dot(n, q - p);
        if (from < 0 && to < 0) return;
        if ((from < 0) != (to < 0)) {
            const LongVec at = p + (q - p) * (from / (from - to));
            crossings.push_back(at);
            (from < 0 ? p : q) = at;
        }
        const LongVec plane = cross(center + p, q - p);
        const Real area = length(plane);
        if (area > 0) sum += angle(p, q - p) * dot(n, plane) / area / 2;
    }

    // The outline of a sphere of radius r at `end` from the centre, with u × v towards the sphere, from azimuth −h to
    // h.
    void circle(LongVec end, Real r, LongVec u, LongVec v, Real h) {
        const LongVec at_end = center + end;
        const Real d = length(at_end);
        const Real sine = r / d;
        const Real cosine = std::sqrt((d - r) * (d + r)) / d;
        const LongVec axis = at_end * (1 / d);
        const Real n_axis = dot(n, axis);
        const Real n_u = dot(n, u);
        const Real n_v = dot(n, v);
        const Real k = cosine * n_axis;
        const Real m = sine * std::hypot(n_u, n_v);
        std::vector<Real> ends{-h, h};
        if (std::fabs(k) < m) {
            const Real middle = std::atan2(n_v, n_u);
            const Real reach = std::atan2(std::sqrt((m - k) * (m + k)), -k);
            for (Real at : {middle - reach, middle + reach}) {
                at -= 2 * long_pi * std::round(at / (2 * long_pi));
                if (at > -h && at < h) {
                    ends.push_back(at);
                    crossings.push_back(end + ((u * std::cos(at) + v * std::sin(at)) * cosine - axis * sine) * r);
                }
            }
        }
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Real a = ends[i];
            const Real b = ends[i + 1];
            const Real half = (a + b) / 2;
            if (k + sine * (n_u * std::cos(half) + n_v * std::sin(half)) < 0) continue;
            sum += sine / 2 *
                   (sine * (b - a) * n_axis -
                    cosine * ((std::sin(b) - std::sin(a)) * n_u + (std::cos(a) - std::cos(b)) * n_v));
        }
    }
};

// For a sphere at `end` from `center`.
inline Real sphere_by_outline(LongVec center, LongVec end, Real r, LongVec n) {
    const LongVec at = center + end;
    if (length(at) < r) return long_pi;
    const LongVec axis = unit(at);
    const LongVec u = unit(cross(axis, std::fabs(axis.x) < 0.6L ? LongVec{1, 0, 0} : LongVec{0, 1, 0}));
    LongOutline outline{center, n};
    outline.circle(end, r, u, cross(axis, u), long_pi);
    return outline.finish();
}

inline Real rectangle_by_outline(const Pose& pose) {
    const LongVec c = lengthen(pose.center);
    const LongVec a = unit(lengthen(pose.axis));
    const LongVec n = unit(lengthen(pose.normal));
    const LongVec y_axis = unit(cross(a, lengthen(pose.across)));
    const LongVec x_axis = cross(y_axis, a);
    const LongVec x = x_axis * (Real(pose.p) / 2);
    const LongVec y = y_axis * (Real(pose.q) / 2);
    const Real behind = dot(lengthen(pose.axis), c);
    if (behind > 0) return 0;
    if (behind == 0) { // in its plane: the limit from the front
        const bool inside = 2 * std::fabs(dot(c, x_axis)) < pose.p && 2 * std::fabs(dot(c, y_axis)) < pose.q;
        return inside ? long_pi * (1 - dot(a, n)) / 2 : 0;
    }
    LongOutline outline{c, n};
    const LongVec corner[4] = {LongVec{0, 0, 0} - x - y, y - x, x + y, x - y};
    for (int i = 0; i < 4; ++i)
        outline.great_arc(corner[i], corner[(i + 1) % 4]);
    return outline.finish();
}

// The rim p(t) by the antiderivatives of 1/(q + e cos t) and similar terms, from angle t0 to t1.
inline Real disk_by_outline(const Pose& pose) {
    const LongVec c = lengthen(pose.center);
    const LongVec w = unit(lengthen(pose.axis)) * -1;
    const LongVec n = unit(lengthen(pose.normal));
    const Real r = pose.p;
    const Real z = dot(w, c);
    if (z < 0) return 0;
    const LongVec across = c - w * z;
    const Real x = length(across);
    const Real n_w = dot(n, w);
    if (z == 0) return x < r ? long_pi * (1 + n_w) / 2 : 0; // in its plane: the limit from the front
    // On the axis any direction works; close to it the computed direction is mostly rounding, part of it along w.
    const bool on_axis = x < 1e-17L * length(c);
    const LongVec towards = on_axis ? cross(w, std::fabs(w.x) < 0.6L ? LongVec{1, 0, 0} : LongVec{0, 1, 0}) : across;
    const LongVec u = unit(towards - w * dot(w, towards));
    const Real n_u = dot(n, u);
    const Real n_v = dot(n, cross(w, u));
    const Real k = z * n_w + x * n_u;
    const Real m = r * std::hypot(n_u, n_v);
    if (k <= -m) return 0;
    const Real q = x * x + z * z + r * r;
    const Real e = 2 * x * r;
    const Real near2 = z * z + (x - r) * (x - r);
    const Real rim = std::sqrt(near2) * std::sqrt(z * z + (x + r) * (x + r));
    const Real beta = e / (q + rim);
    const Real middle = std::atan2(n_v, n_u);
    const Real half = k >= m ? long_pi : std::atan2(std::sqrt((m - k) * (m + k)), -k);
    const Real t0 = middle - half;
    const Real t1 = middle + half;
    const auto ratio = [](Real y, auto f) { return y == 0 ? Real(1) : f(y) / y; };
    // Some C libraries have log1p of double alone, for which −1 + 1e-17 is −1.
    const auto log_of_1_plus = [](Real y) { return y < -0.5L ? std::log(1 + y) : std::log1p(y); };
    const auto j = [&](Real t) {
        const Real slope = std::sin(t) / (1 + beta * std::cos(t));
        return slope * ratio(beta * slope, [](Real y) { return std::atan(y); });
    };
    const Real along = j(t1) - j(t0);
    const Real cosine = std::cos(t0 / 2);
    const Real change = -2 * std::sin(middle) * std::sin(half) / (near2 + 2 * e * cosine * cosine);
    const Real sum = r * r * n_w * (2 * half - 2 * beta * along) / rim +
                     r * (x * n_w - z * n_u) * (2 * q * along - 2 * half * e) / (rim * (q + rim)) +
                     r * z * n_v * change * ratio(e * change, log_of_1_plus);
    const LongOutline rim_outline{{z, x, 0}, {n_w, n_u, n_v}};
    const LongVec from{0, r * std::cos(t1), r * std::sin(t1)};
    const LongVec to{0, r * std::cos(t0), r * std::sin(t0)};
    const Real closing = k >= m ? 0 : rim_outline.angle(from, to - from);
    return std::clamp((sum + closing) / 2, Real(0), long_pi);
}

inline Real tube_by_outline(const Pose& pose) {
    const LongVec c = lengthen(pose.center);
    const LongVec a = unit(lengthen(pose.axis));
    const LongVec n = unit(lengthen(pose.normal));
    const Real r = pose.p;
    const Real half = Real(pose.q) / 2;
    const Real z = dot(a, c);
    const LongVec across = c - a * z;
    const Real distance = length(across);
    const Real z0 = z - half;
    const Real z1 = z + half;
    const Real beyond = std::max({z0, -z1, Real(0)});
    if (std::hypot(distance, beyond) < r) return long_pi;
    if (distance <= r && beyond > 0) return sphere_by_outline(c, a * (z0 > 0 ? -half : half), r, n);
    const LongVec f = across * (1 / distance);
    const LongVec g = cross(a, f);
    const Real s = r / distance;
    const Real kappa = std::sqrt((distance - r) * (distance + r)) / distance;
    // The points where the tangent planes touch, from the centre.
    const auto tangent = [&](Real along, Real sign) { return f * (-r * s) + a * along + g * (sign * r * kappa); };
    LongOutline outline{c, n};
    const auto end = [&](Real along, Real sign) {
        const Real at = z + along;
        const Real d = std::hypot(distance, at);
        const LongVec u = (a * distance - f * at) * (sign / d);
        outline.circle(a * along, r, u, g * -sign, std::atan2(d * kappa, sign * s * at));
    };
    outline.great_arc(tangent(-half, 1), tangent(half, 1));
    end(half, 1);
    outline.great_arc(tangent(half, -1), tangent(-half, -1));
    end(-half, -1);
    return outline.finish();
}

inline Real by_outline(const Pose& pose) {
    switch (pose.shape) {
    case Shape::sphere:
        return sphere_by_outline(lengthen(pose.center), {0, 0, 0}, pose.p, unit(lengthen(pose.normal)));
    case Shape::disk:
        return disk_by_outline(pose);
    case Shape::rectangle:
        return rectangle_by_outline(pose);
    case Shape::tube:
        return tube_by_outline(pose);
    }
    return 0;
}

} // namespace area
