#include <gonio/scene/detail/touching.hpp>
#include <gonio/scene/shadow_line.hpp>

#include <glm/common.hpp>
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

using Line = LightLineSeen;

void add_ball(HiddenPiece& hidden, const Line& line, const glm::dvec3& center, double radius) {
    const Round round(line.from, line.along, center, radius);
    round.tangents([&](double t, double share) {
        if (before_line(share)) hidden.add(t);
    });
    round.crossings([&](double t) { hidden.add(t); });
    for (const double end : {0.0, 1.0})
        if (before_line(round.entry(end))) hidden.add(end);
}

// Where the plane of the rays cuts edges, if that point is in front of the line.
class CutEdges {
public:
    explicit CutEdges(const Line& line)
        : share_of_way_(glm::cross(line.along, line.normal)),
          share_of_line_(glm::cross(line.normal, line.from)),
          area_(glm::dot(line.normal, line.normal)) {}

    // An edge between points at `side_a` and `side_b` along the normal.
    void add(HiddenPiece& hidden, const glm::dvec3& a, double side_a, const glm::dvec3& b, double side_b) const {
        if ((side_a < 0.0) == (side_b < 0.0)) return;
        // cut = u from + v along, where u is the share of the way and v/u the position on the line.
        const glm::dvec3 cut = a + side_a / (side_a - side_b) * (b - a);
        const double u = glm::dot(cut, share_of_way_);
        const double v = glm::dot(cut, share_of_line_);
        if (u > 0.0 && u <= area_ && v >= 0.0 && v <= u) hidden.add(v / u);
    }

private:
    glm::dvec3 share_of_way_, share_of_line_; // both over the area
    double area_;
};

// Whether the plane of the rays misses the whole object with these corners.
template<std::size_t n>
bool is_one_sided(const std::array<double, n>& side) {
    return std::all_of(side.begin(), side.end(), [](double height) { return height > 0.0; }) ||
           std::all_of(side.begin(), side.end(), [](double height) { return height < 0.0; });
}

// What the objects are to one receiver, which all positions are relative to.

struct HidingBall {
    glm::dvec3 center;
    double radius;
    bool is_inside; // the receiver

    HidingBall(const Ball& ball, const glm::dvec3& receiver)
        : center(ball.center - receiver),
          radius(ball.radius),
          is_inside(!(glm::dot(center, center) > radius * radius)) {}

    HiddenPiece hidden(const Line& line) const {
        HiddenPiece piece;
        if (!is_inside && std::abs(glm::dot(line.normal, center)) <= radius * line.normal_length)
            add_ball(piece, line, center, radius);
        return piece;
    }
};

struct HidingCapsule {
    glm::dvec3 center;
    glm::dvec3 axis;
    double half_length;
    double radius;
    std::array<glm::dvec3, 2> ends;
    bool is_inside;

    HidingCapsule(const Capsule& capsule, const glm::dvec3& receiver)
        : center(capsule.center - receiver),
          axis(capsule.axis),
          half_length(capsule.half_length),
          radius(capsule.radius),
          ends{center - half_length * axis, center + half_length * axis},
          is_inside(hides(capsule, receiver)) {}

    HiddenPiece hidden(const Line& line) const {
        HiddenPiece piece;
        // An object that the plane of the rays misses hides nothing, and costs almost nothing.
        const double reach = radius * line.normal_length;
        const std::array<double, 2> heights{glm::dot(line.normal, ends[0]), glm::dot(line.normal, ends[1])};
        if (std::min(heights[0], heights[1]) > reach || std::max(heights[0], heights[1]) < -reach) return piece;
        if (is_inside) return piece;
        for (std::size_t i = 0; i < 2; ++i)
            if (std::abs(heights[i]) <= reach) add_ball(piece, line, ends[i], radius);
        // The side between the ends.
        const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, axis) * axis; };
        const Round round(across(line.from), across(line.along), across(center), radius);
        const auto on_side = [&](double t, double share) {
            return before_line(share) && std::abs(glm::dot(axis, share * line.at(t) - center)) <= half_length;
        };
        round.tangents([&](double t, double share) {
            if (on_side(t, share)) piece.add(t);
        });
        round.crossings([&](double t) {
            if (on_side(t, 1.0)) piece.add(t);
        });
        for (const double end : {0.0, 1.0})
            if (on_side(end, round.entry(end))) piece.add(end);
        return piece;
    }
};

// In the axes of the box.
struct HidingBox {
    Frame frame;
    glm::dvec3 half;
    glm::dvec3 receiver; // relative to the middle of the box
    std::array<glm::dvec3, 8> corner{};
    bool is_inside;

    HidingBox(const Box& box, const glm::dvec3& of_receiver)
        : frame(box.frame),
          half(box.half_size),
          receiver(box.frame.to_local(of_receiver - box.frame.origin)),
          is_inside(hides(box, of_receiver)) {
        for (unsigned i = 0; i < 8; ++i)
            corner[i] = glm::dvec3((i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                                   (i & 4U) != 0 ? half.z : -half.z) -
                        receiver;
    }

    HiddenPiece hidden(const Line& of_world) const {
        HiddenPiece piece;
        const glm::dvec3 normal = frame.to_local(of_world.normal);
        std::array<double, 8> side{};
        for (unsigned i = 0; i < 8; ++i)
            side[i] = glm::dot(normal, corner[i]);
        if (is_one_sided(side) || is_inside) return piece;
        const Line line{frame.to_local(of_world.from), frame.to_local(of_world.along), normal, of_world.normal_length};
        // Where the plane of the rays cuts its edges.
        const CutEdges edges(line);
        for (unsigned i = 0; i < 8; ++i)
            for (unsigned bit = 1; bit < 8; bit *= 2)
                if ((i & bit) == 0) edges.add(piece, corner[i], side[i], corner[i | bit], side[i | bit]);
        // Where the line itself and the rays to its ends enter the box.
        through_slabs(receiver + line.from, line.along, [&](double entry, double exit) {
            if (entry <= exit && exit >= 0.0 && entry <= 1.0) {
                piece.add(std::max(entry, 0.0));
                piece.add(std::min(exit, 1.0));
            }
        });
        for (const double end : {0.0, 1.0})
            through_slabs(receiver, line.at(end), [&](double entry, double exit) {
                if (entry < exit && exit > 0.0 && entry <= 1.0) piece.add(end);
            });
        return piece;
    }

    template<class Take>
    void through_slabs(const glm::dvec3& origin, const glm::dvec3& direction, const Take& take) const {
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
        take(entry, exit);
    }
};

struct HidingPanel {
    Frame frame;
    double half_width;
    double half_height;
    double height; // of the receiver
    bool is_touched;
    std::array<glm::dvec3, 4> corner;
    glm::dvec3 middle;

    HidingPanel(const Panel& panel, const glm::dvec3& receiver)
        : frame(panel.frame),
          half_width(0.5 * panel.width),
          half_height(0.5 * panel.height),
          height(glm::dot(receiver - panel.frame.origin, panel.frame.z)),
          is_touched(std::abs(height) <= touching(receiver)),
          corner(corners(panel)),
          middle(panel.frame.origin - receiver) {
        for (glm::dvec3& at : corner)
            at -= receiver;
    }

    HiddenPiece hidden(const Line& line) const {
        HiddenPiece piece;
        if (is_touched) return piece;
        std::array<double, 4> side{};
        for (std::size_t i = 0; i < 4; ++i)
            side[i] = glm::dot(line.normal, corner[i]);
        if (is_one_sided(side)) return piece;
        const CutEdges edges(line);
        for (std::size_t i = 0; i < 4; ++i)
            edges.add(piece, corner[i], side[i], corner[(i + 1) % 4], side[(i + 1) % 4]);
        const auto within = [&](const glm::dvec3& point) {
            return std::abs(glm::dot(point - middle, frame.x)) <= half_width &&
                   std::abs(glm::dot(point - middle, frame.y)) <= half_height;
        };
        const double from = height + glm::dot(line.from, frame.z);
        const double to = from + glm::dot(line.along, frame.z);
        if (from * to < 0.0 && within(line.at(from / (from - to)))) piece.add(from / (from - to));
        for (const auto& [end, at_end] : {std::pair{0.0, from}, std::pair{1.0, to}})
            if (height * at_end < 0.0 && within(height / (height - at_end) * line.at(end))) piece.add(end);
        return piece;
    }
};

struct HidingPlane {
    glm::dvec3 normal;
    double height;
    bool is_touched;

    HidingPlane(const Plane& plane, const glm::dvec3& receiver)
        : normal(plane.normal),
          height(glm::dot(receiver - plane.point, plane.normal)),
          is_touched(std::abs(height) <= touching(receiver)) {}

    HiddenPiece hidden(const Line& line) const {
        HiddenPiece piece;
        if (is_touched) return piece;
        const double from = height + glm::dot(line.from, normal);
        const double to = from + glm::dot(line.along, normal);
        if (from * to < 0.0) piece.add(from / (from - to));
        if (height * from < 0.0) piece.add(0.0);
        if (height * to < 0.0) piece.add(1.0);
        return piece;
    }
};

HidingPlane hiding(const Plane& plane, const glm::dvec3& receiver) {
    return {plane, receiver};
}
HidingPanel hiding(const Panel& panel, const glm::dvec3& receiver) {
    return {panel, receiver};
}
HidingBall hiding(const Ball& ball, const glm::dvec3& receiver) {
    return {ball, receiver};
}
HidingBox hiding(const Box& box, const glm::dvec3& receiver) {
    return {box, receiver};
}
HidingCapsule hiding(const Capsule& capsule, const glm::dvec3& receiver) {
    return {capsule, receiver};
}

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

// Of a point to a solid or surface; 0 inside.
struct DistanceTo {
    const glm::dvec3& point;

    double operator()(const Plane& plane) const { return std::abs(glm::dot(point - plane.point, plane.normal)); }
    double operator()(const Panel& panel) const {
        return to_box(panel.frame, {0.5 * panel.width, 0.5 * panel.height, 0.0});
    }
    double operator()(const Ball& ball) const { return std::max(glm::distance(point, ball.center) - ball.radius, 0.0); }
    double operator()(const Box& box) const { return to_box(box.frame, box.half_size); }
    double operator()(const Capsule& capsule) const {
        const glm::dvec3 off = point - capsule.center;
        const double along = std::clamp(glm::dot(off, capsule.axis), -capsule.half_length, capsule.half_length);
        return std::max(glm::length(off - along * capsule.axis) - capsule.radius, 0.0);
    }

private:
    double to_box(const Frame& frame, const glm::dvec3& half_size) const {
        const glm::dvec3 local = frame.to_local(point - frame.origin);
        return glm::length(glm::max(glm::abs(local) - half_size, glm::dvec3(0.0)));
    }
};

} // namespace

ShadowEdge nearest_edge(const Primitive& body, const glm::dvec3& receiver, const glm::dvec3& towards) {
    return std::visit(NearestEdge{receiver, towards}, body);
}

LightLineSeen::LightLineSeen(const glm::dvec3& begin, const glm::dvec3& end)
    : from(begin), along(end - begin), normal(glm::cross(from, along)), normal_length(glm::length(normal)) {}

void hidden_pieces(const Primitive& body, const glm::dvec3& receiver, std::span<const LightLineSeen> lines,
                   std::span<HiddenPiece> pieces) {
    std::visit(
        [&](const auto& shape) {
            const auto prepared = hiding(shape, receiver);
            for (std::size_t i = 0; i < lines.size(); ++i)
                pieces[i] = prepared.hidden(lines[i]);
        },
        body);
}

bool is_apart(const Primitive& body, const Ball& ball) {
    return std::visit(DistanceTo{ball.center}, body) > ball.radius;
}

} // namespace gonio::detail
