#include <gonio/scene/detail/touching.hpp>
#include <gonio/scene/shadow_line.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gonio::detail {

namespace {

// The real roots of a t² + 2 b t + c, without cancellation; a linear equation has only its finite root.
template<class Take>
void for_roots(double a, double b, double c, const Take& take) {
    const double under = b * b - a * c;
    if (!(under >= 0.0)) return;
    const double q = -(b + std::copysign(std::sqrt(under), b));
    if (q != 0.0) take(c / q);
    if (a != 0.0) take(q / a);
}

bool on_line(double t) {
    return t >= 0.0 && t <= 1.0;
}

// A line of the light, with the receiver at the origin.
struct Line {
    glm::dvec3 from;
    glm::dvec3 along; // to − from

    glm::dvec3 at(double t) const { return from + t * along; }
    glm::dvec3 normal() const { return glm::cross(from, along); } // of the plane of the rays, of any length
};

// How a line passes a sphere, or an infinite cylinder, which follows the same formulas in the plane across its axis.
struct Round {
    glm::dvec3 from, along, center;
    double power; // of the receiver: |c|² − r²
    double radius2;

    Round(const glm::dvec3& line_from, const glm::dvec3& line_along, const glm::dvec3& middle, double radius)
        : from(line_from),
          along(line_along),
          center(middle),
          power(glm::dot(middle, middle) - radius * radius),
          radius2(radius * radius) {}

    // Where rays are tangent to it, with the share of the way to the line at which they touch.
    template<class Take>
    void tangents(const Take& take) const {
        const double fc = glm::dot(from, center);
        const double ac = glm::dot(along, center);
        for_roots(ac * ac - power * glm::dot(along, along), ac * fc - power * glm::dot(from, along),
                  fc * fc - power * glm::dot(from, from), [&](double t) {
                      if (!on_line(t)) return;
                      const glm::dvec3 way = from + t * along;
                      take(t, glm::dot(way, center) / glm::dot(way, way));
                  });
    }
    // Where the line enters and leaves it.
    template<class Take>
    void crossings(const Take& take) const {
        const glm::dvec3 off = from - center;
        for_roots(glm::dot(along, along), glm::dot(off, along), glm::dot(off, off) - radius2, [&](double t) {
            if (on_line(t)) take(t);
        });
    }
    // The share of the way to the point t of the line at which a ray enters; above 1 where it misses.
    double entry(double t) const {
        const glm::dvec3 way = from + t * along;
        const double middle = glm::dot(way, center);
        const double length2 = glm::dot(way, way);
        const double under = middle * middle - power * length2;
        return under >= 0.0 && middle > 0.0 ? (middle - std::sqrt(under)) / length2 : 2.0;
    }
};

bool before_line(double share) {
    return share > 0.0 && share <= 1.0;
}

void add_ball(HiddenPiece& hidden, const Line& line, const glm::dvec3& center, double radius) {
    const Round round(line.from, line.along, center, radius);
    round.tangents([&](double t, double share) {
        if (before_line(share)) hidden.add(t);
    });
    round.crossings([&](double t) { hidden.add(t); });
    for (const double end : {0.0, 1.0})
        if (before_line(round.entry(end))) hidden.add(end);
}

struct Hidden {
    const glm::dvec3& receiver;
    Line line;

    HiddenPiece operator()(const Ball& ball) const {
        HiddenPiece hidden;
        const glm::dvec3 center = ball.center - receiver;
        if (!(glm::dot(center, center) > ball.radius * ball.radius)) return hidden;
        const glm::dvec3 normal = line.normal();
        if (std::abs(glm::dot(normal, center)) <= ball.radius * glm::length(normal))
            add_ball(hidden, line, center, ball.radius);
        return hidden;
    }

    HiddenPiece operator()(const Capsule& capsule) const {
        HiddenPiece hidden;
        const glm::dvec3 center = capsule.center - receiver;
        const glm::dvec3& w = capsule.axis;
        const std::array<glm::dvec3, 2> ends{center - capsule.half_length * w, center + capsule.half_length * w};
        // An object that the plane of the rays misses hides nothing, and costs almost nothing.
        const glm::dvec3 normal = line.normal();
        const double reach = capsule.radius * glm::length(normal);
        const std::array<double, 2> heights{glm::dot(normal, ends[0]), glm::dot(normal, ends[1])};
        if (std::min(heights[0], heights[1]) > reach || std::max(heights[0], heights[1]) < -reach) return hidden;
        if (hides(capsule, receiver)) return hidden;
        for (std::size_t i = 0; i < 2; ++i)
            if (std::abs(heights[i]) <= reach) add_ball(hidden, line, ends[i], capsule.radius);
        // The side between the ends.
        const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, w) * w; };
        const Round round(across(line.from), across(line.along), across(center), capsule.radius);
        const auto on_side = [&](double t, double share) {
            return before_line(share) && std::abs(glm::dot(w, share * line.at(t) - center)) <= capsule.half_length;
        };
        round.tangents([&](double t, double share) {
            if (on_side(t, share)) hidden.add(t);
        });
        round.crossings([&](double t) {
            if (on_side(t, 1.0)) hidden.add(t);
        });
        for (const double end : {0.0, 1.0})
            if (on_side(end, round.entry(end))) hidden.add(end);
        return hidden;
    }

    HiddenPiece operator()(const Box& box) const {
        const glm::dvec3 origin = box.frame.to_local(receiver - box.frame.origin);
        const glm::dvec3 from = box.frame.to_local(line.from);
        const glm::dvec3 along = box.frame.to_local(line.along);
        const glm::dvec3& half = box.half_size;
        HiddenPiece hidden;
        // Where the plane of the rays cuts its edges.
        const glm::dvec3 normal = glm::cross(from, along);
        std::array<glm::dvec3, 8> corner{};
        std::array<double, 8> side{};
        for (unsigned i = 0; i < 8; ++i) {
            corner[i] = glm::dvec3((i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                                   (i & 4U) != 0 ? half.z : -half.z) -
                        origin;
            side[i] = glm::dot(normal, corner[i]);
        }
        if (is_one_sided(side) || hides(box, receiver)) return hidden;
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) add_edge(hidden, normal, from, along, corner, side, i, i | bit);
        // Where the line itself and the rays to its ends enter the box.
        add_slabs(hidden, half, origin + from, along, [](double entry, double exit, HiddenPiece& to) {
            if (entry <= exit && exit >= 0.0 && entry <= 1.0) {
                to.add(std::max(entry, 0.0));
                to.add(std::min(exit, 1.0));
            }
        });
        for (const double end : {0.0, 1.0})
            add_slabs(hidden, half, origin, from + end * along, [end](double entry, double exit, HiddenPiece& to) {
                if (entry < exit && exit > 0.0 && entry <= 1.0) to.add(end);
            });
        return hidden;
    }

    HiddenPiece operator()(const Panel& panel) const {
        HiddenPiece hidden;
        const double height = glm::dot(receiver - panel.frame.origin, panel.frame.z);
        if (std::abs(height) <= touching(receiver)) return hidden;
        const glm::dvec3 normal = glm::cross(line.from, line.along);
        std::array<glm::dvec3, 4> corner = corners(panel);
        std::array<double, 4> side{};
        for (std::size_t i = 0; i < 4; ++i) {
            corner[i] -= receiver;
            side[i] = glm::dot(normal, corner[i]);
        }
        if (is_one_sided(side)) return hidden;
        for (std::size_t i = 0; i < 4; ++i)
            add_edge(hidden, normal, line.from, line.along, corner, side, i, (i + 1) % 4);
        const auto within = [&](const glm::dvec3& point) {
            const glm::dvec3 off = point + receiver - panel.frame.origin;
            return std::abs(glm::dot(off, panel.frame.x)) <= 0.5 * panel.width &&
                   std::abs(glm::dot(off, panel.frame.y)) <= 0.5 * panel.height;
        };
        const double from = height + glm::dot(line.from, panel.frame.z);
        const double to = from + glm::dot(line.along, panel.frame.z);
        if (from * to < 0.0 && within(line.at(from / (from - to)))) hidden.add(from / (from - to));
        for (const auto& [end, at_end] : {std::pair{0.0, from}, std::pair{1.0, to}})
            if (height * at_end < 0.0 && within(height / (height - at_end) * line.at(end))) hidden.add(end);
        return hidden;
    }

    HiddenPiece operator()(const Plane& plane) const {
        HiddenPiece hidden;
        const double height = glm::dot(receiver - plane.point, plane.normal);
        if (std::abs(height) <= touching(receiver)) return hidden;
        const double from = height + glm::dot(line.from, plane.normal);
        const double to = from + glm::dot(line.along, plane.normal);
        if (from * to < 0.0) hidden.add(from / (from - to));
        if (height * from < 0.0) hidden.add(0.0);
        if (height * to < 0.0) hidden.add(1.0);
        return hidden;
    }

private:
    // Whether the plane of the rays misses the whole object with these corners.
    template<std::size_t n>
    static bool is_one_sided(const std::array<double, n>& side) {
        return std::all_of(side.begin(), side.end(), [](double height) { return height > 0.0; }) ||
               std::all_of(side.begin(), side.end(), [](double height) { return height < 0.0; });
    }

    // Where the plane of the rays cuts an edge, if that point is in front of the line.
    template<std::size_t n>
    static void add_edge(HiddenPiece& hidden, const glm::dvec3& normal, const glm::dvec3& from, const glm::dvec3& along,
                         const std::array<glm::dvec3, n>& corner, const std::array<double, n>& side, std::size_t a,
                         std::size_t b) {
        if ((side[a] < 0.0) == (side[b] < 0.0)) return;
        const glm::dvec3 cut = corner[a] + side[a] / (side[a] - side[b]) * (corner[b] - corner[a]);
        // cut = u from + v along, where u is the share of the way and v/u the position on the line.
        const double area = glm::dot(normal, normal);
        const double u = glm::dot(glm::cross(cut, along), normal) / area;
        const double v = glm::dot(glm::cross(from, cut), normal) / area;
        if (before_line(u) && v >= 0.0 && v <= u) hidden.add(v / u);
    }

    template<class Take>
    static void add_slabs(HiddenPiece& hidden, const glm::dvec3& half, const glm::dvec3& origin,
                          const glm::dvec3& direction, const Take& take) {
        double entry = -1e300;
        double exit = 1e300;
        for (int axis = 0; axis < 3; ++axis) {
            if (direction[axis] == 0.0) {
                if (!(std::abs(origin[axis]) < half[axis])) return;
                continue;
            }
            const double towards = std::copysign(half[axis], direction[axis]);
            entry = std::max(entry, (-towards - origin[axis]) / direction[axis]);
            exit = std::min(exit, (towards - origin[axis]) / direction[axis]);
        }
        take(entry, exit, hidden);
    }
};

struct NearestEdge {
    const glm::dvec3& receiver;
    const glm::dvec3& towards;

    ShadowEdge operator()(const Ball& ball) const { return round(ball.center - receiver, ball.radius); }

    ShadowEdge operator()(const Capsule& capsule) const {
        const glm::dvec3 a = capsule.center - capsule.half_length * capsule.axis - receiver;
        const glm::dvec3 b = capsule.center + capsule.half_length * capsule.axis - receiver;
        const glm::dvec3 way = b - a;
        const double place = std::clamp(-glm::dot(a, way) / glm::dot(way, way), 0.0, 1.0);
        const double nearest = glm::length(a + place * way);
        if (!(nearest > capsule.radius)) return {0.0, towards};
        ShadowEdge edge = segment(a, b);
        edge.distance -= std::asin(capsule.radius / nearest);
        return edge;
    }

    ShadowEdge operator()(const Box& box) const {
        ShadowEdge nearest;
        std::array<glm::dvec3, 8> corner{};
        for (unsigned i = 0; i < 8; ++i)
            corner[i] = box.frame.origin - receiver + ((i & 1U) != 0 ? 1.0 : -1.0) * box.half_size.x * box.frame.x +
                        ((i & 2U) != 0 ? 1.0 : -1.0) * box.half_size.y * box.frame.y +
                        ((i & 4U) != 0 ? 1.0 : -1.0) * box.half_size.z * box.frame.z;
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) take(nearest, segment(corner[i], corner[i | bit]));
        return nearest;
    }

    ShadowEdge operator()(const Panel& panel) const {
        ShadowEdge nearest;
        const std::array<glm::dvec3, 4> corner = corners(panel);
        for (std::size_t i = 0; i < 4; ++i)
            take(nearest, segment(corner[i] - receiver, corner[(i + 1) % 4] - receiver));
        return nearest;
    }

    ShadowEdge operator()(const Plane& plane) const { return {glm::dot(towards, plane.normal), plane.normal}; }

private:
    static void take(ShadowEdge& nearest, const ShadowEdge& other) {
        if (other.distance < nearest.distance) nearest = other;
    }

    ShadowEdge round(const glm::dvec3& center, double radius) const {
        const double distance = glm::length(center);
        if (!(distance > radius)) return {0.0, towards};
        const glm::dvec3 off = center / distance - towards;
        return {2.0 * std::asin(std::min(0.5 * glm::length(off), 1.0)) - std::asin(radius / distance), off};
    }

    // The plane through the segment and the receiver if the direction passes the segment, else the segment's nearer
    // end.
    ShadowEdge segment(const glm::dvec3& a, const glm::dvec3& b) const {
        const glm::dvec3 normal = glm::cross(a, b);
        const double length2 = glm::dot(normal, normal);
        const double length_a = glm::length(a);
        const double length_b = glm::length(b);
        if (!(length2 > 0.0)) {
            if (!(length_a > 0.0) || !(length_b > 0.0) || glm::dot(a, b) < 0.0) return {0.0, towards};
            return {glm::length(a / length_a - towards), a / length_a - towards};
        }
        // The direction projected into that plane: u a + v b.
        const double u = glm::dot(glm::cross(towards, b), normal);
        const double v = glm::dot(glm::cross(a, towards), normal);
        if (u > 0.0 && v > 0.0) return {std::abs(glm::dot(normal, towards)) / std::sqrt(length2), normal};
        const double off_a = glm::length(a / length_a - towards);
        const double off_b = glm::length(b / length_b - towards);
        return {std::min(off_a, off_b), normal};
    }
};

} // namespace

ShadowEdge nearest_edge(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& towards) {
    return std::visit(NearestEdge{receiver, towards}, body);
}

HiddenPiece hidden_piece(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& from,
                         const glm::dvec3& to) {
    return std::visit(Hidden{receiver, {from, to - from}}, body);
}

} // namespace gonio::detail
