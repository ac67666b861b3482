// Directions and angles in both conversions, frames, rays against solids, overlapping caps, and directions sampled
// towards lights.
#include <gonio/base/frame.hpp>
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>
#include <gonio/shading/sample_tube.hpp>
#include <gonio/web/goniometer.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace gonio::measure::detail {

namespace {

using hostile::Pose;
using hostile::Stratum;
using shading::vec3;

glm::dvec3 as_glm(const hostile::Vec& v) {
    return {v.x, v.y, v.z};
}

std::string text(const glm::dvec3& v) {
    return fmt::format(" {:a} {:a} {:a}", v.x, v.y, v.z);
}

// Any direction; some along the axes or almost along them.
glm::dvec3 direction(Random& random) {
    glm::dvec3 d = as_glm(hostile::random_direction(random));
    if (random.bits() % 4 == 0) {
        const auto kept = static_cast<int>(random.bits() % 3);
        for (int k = 0; k < 3; ++k)
            if (k != kept && random.bits() % 2 == 0) d[k] *= std::exp(random.uniform(-700.0, 0.0));
    }
    return glm::normalize(d);
}

void angles(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 5) {
        const glm::dvec3 d = direction(random);
        const double far = std::exp(random.uniform(-300.0, 300.0));
        const auto hold = [&](const char* what, const glm::dvec3& back) {
            // Degrees up to 360 and radians up to 2π each have a relative rounding of 4e-16.
            tally.hold(glm::length(back - d) / 4e-15, [&] { return what + text(d) + " back" + text(back); });
        };
        hold("polar angles", direction_of(angles_of(d * far)));
        for (const Photometry type : {Photometry::c, Photometry::a, Photometry::b})
            hold("goniometer", direction_of(type, angles_of(type, d * far)));
        const glm::dvec3 up = random.bits() % 4 == 0 ? d * far : direction(random) * far;
        const Frame frame = aimed_frame(glm::dvec3(0.0), d * far, up);
        const double off = std::max({std::fabs(glm::length(frame.x) - 1.0), std::fabs(glm::length(frame.y) - 1.0),
                                     std::fabs(glm::dot(frame.x, frame.y)), std::fabs(glm::dot(frame.x, frame.z)),
                                     std::fabs(glm::dot(frame.y, frame.z)), glm::length(frame.z + d),
                                     glm::length(glm::cross(frame.x, frame.y) - frame.z)});
        tally.hold(off / 4e-15, [&] { return "frame along" + text(d) + " up" + text(up); });
    }
}

Primitive body(Random& random) {
    const auto size = [&] { return std::exp(random.uniform(std::log(1e-3), std::log(1e3))); };
    const glm::dvec3 at(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
    const Frame frame = aimed_frame(at, direction(random), direction(random));
    switch (random.bits() % 5) {
    case 0:
        return Plane{at, direction(random)};
    case 1:
        return Panel{frame, size(), size()};
    case 2:
        return Ball{at, size()};
    case 3:
        return Box{frame, {size(), size(), size()}};
    default:
        return Capsule{at, direction(random), size(), size()};
    }
}

// The distance of a point from the surface.
double off_surface(const Primitive& primitive, const glm::dvec3& p) {
    struct Visitor {
        glm::dvec3 p;
        double operator()(const Plane& plane) const { return std::fabs(glm::dot(p - plane.point, plane.normal)); }
        double operator()(const Panel& panel) const {
            const glm::dvec3 q = panel.frame.to_local(p - panel.frame.origin);
            return std::max({std::fabs(q.z), std::fabs(q.x) - 0.5 * panel.width, std::fabs(q.y) - 0.5 * panel.height});
        }
        double operator()(const Ball& ball) const { return std::fabs(glm::length(p - ball.center) - ball.radius); }
        double operator()(const Box& box) const {
            const glm::dvec3 q = glm::abs(box.frame.to_local(p - box.frame.origin)) - box.half_size;
            return std::fabs(std::max({q.x, q.y, q.z}));
        }
        double operator()(const Capsule& capsule) const {
            const glm::dvec3 from = p - capsule.center;
            const double along = std::clamp(glm::dot(from, capsule.axis), -capsule.half_length, capsule.half_length);
            return std::fabs(glm::length(from - capsule.axis * along) - capsule.radius);
        }
    };
    return std::visit(Visitor{p}, primitive);
}

double size_of(const Primitive& primitive) {
    const std::optional<Ball> around = bounds(primitive);
    return around ? around->radius : 1.0;
}

void rays(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; ++done) {
        const Primitive primitive = body(random);
        const double far = std::exp(random.uniform(std::log(1e-2), std::log(1e4)));
        const glm::dvec3 origin = direction(random) * far;
        // Half of the rays are aimed at the primitive.
        const glm::dvec3 aim = direction(random) * size_of(primitive) - origin;
        const bool aimed = random.bits() % 2 == 0 && glm::length(aim) > 0.0;
        const Ray ray{origin, aimed ? glm::normalize(aim) : direction(random)};
        const auto distance =
            std::visit([&](const auto& shape) -> std::optional<double> { return distance_to(shape, ray); }, primitive);
        const auto input = [&] {
            return fmt::format("body {} ray{}{} distance {}", primitive.index(), text(ray.origin), text(ray.direction),
                               distance.value_or(-1.0));
        };
        if (!distance) {
            tally.looked_at(1);
            continue;
        }
        const glm::dvec3 hit = ray.origin + ray.direction * *distance;
        const double reach = far + *distance + size_of(primitive) + 4.0;
        const double off = off_surface(primitive, hit) / (1e-12 * reach);
        tally.hold(*distance >= 0.0 && std::isfinite(*distance) ? off : HUGE_VAL, input);
        tally.require(std::fabs(glm::length(normal_at(primitive, hit)) - 1.0) < 1e-9, input);
    }
}

// Two sectors minus the kite of the axes and the crossings, with the 11 extra bits of a long double on x86, because the
// sectors of the two caps cancel. a ≤ b; for a up to 1.4, because the kite of nearly opposite hemispheres has no
// corners.
long double sectors_less_kite(long double a, long double b, long double d) {
    const long double left = b - d;
    const long double less_a = std::sin(b - 0.5L * (a + left));
    const long double less_b = std::sin(0.5L * (a - left));
    const long double less_d = std::sin(0.5L * (a + left));
    const long double all = std::fmax(std::sin(b + 0.5L * (a - left)), 0.0L);
    const auto angle = [](long double up, long double down) {
        return 2.0L * std::atan2(std::sqrt(up), std::sqrt(down));
    };
    const long double at_a = angle(less_d * less_a, all * less_b);
    const long double at_b = angle(less_d * less_b, all * less_a);
    const long double crossing = angle(less_a * less_b, all * less_d);
    const long double half_a = std::sin(0.5L * a);
    const long double half_b = std::sin(0.5L * b);
    const long double tangents = std::tan(0.5L * a) * std::tan(0.5L * b);
    const long double excess = 2.0L * std::atan2(tangents * std::sin(crossing), 1.0L + tangents * std::cos(crossing));
    return 4.0L * (at_a * half_a * half_a + at_b * half_b * half_b) - 2.0L * excess;
}

// The intersection of two caps is at most as large as each of them, and agrees with sectors and triangles.
void caps(Random& random, std::uint64_t evaluations, StressTally& tally) {
    const auto half_angle = [&] {
        return random.bits() % 8 == 0 ? std::numbers::pi / 2.0
                                      : std::exp(random.uniform(std::log(1e-9), std::log(std::numbers::pi / 2.0)));
    };
    const auto area = [](double a) { return 4.0 * std::numbers::pi * std::sin(0.5 * a) * std::sin(0.5 * a); };
    for (std::uint64_t done = 0; done < evaluations; done += 2) {
        const double a = half_angle();
        double b = half_angle();
        if (random.bits() % 4 == 0) b = std::min(a * (1.0 + random.uniform(-1e-9, 1e-9)), std::numbers::pi / 2.0);
        double d = random.uniform(0.0, std::numbers::pi);
        const std::uint64_t choice = random.bits() % 4;
        if (choice == 0) d = std::fabs(a - b) + std::min(a, b) * random.uniform(-1e-9, 2.0);
        if (choice == 1) d = (a + b) * (1.0 + random.uniform(-1e-9, 1e-9));
        d = std::clamp(d, 0.0, std::numbers::pi);
        const double least = std::min(area(a), area(b));
        const double common = cap_overlap(a, b, d);
        const auto input = [&] { return fmt::format("caps {:a} {:a} at {:a}: {}", a, b, d, common); };
        tally.require(common >= 0.0 && common <= least * (1.0 + 1e-12), input);
        double off = 0.0;
        if (d < a + b && d > std::fabs(a - b) && std::min(a, b) < 1.4) {
            const long double cancelled = 1e-18L * static_cast<long double>(a) * static_cast<long double>(b);
            off = static_cast<double>(
                std::fabs(sectors_less_kite(std::min(a, b), std::max(a, b), d) - static_cast<long double>(common)) /
                (1e-12L * static_cast<long double>(least) + cancelled));
        }
        tally.hold(off, input);
        tally.looked_at(1);
    }
}

template<class S>
bool good(const shading::LightSample<S>& sample, S off_unit) {
    const S length2 = shading::dot(sample.direction, sample.direction);
    return std::fabs(length2 - S(1)) < off_unit && sample.pdf > S(0) && std::isfinite(sample.pdf);
}

// What a direction sampled towards the light must be, and how far outside of the light's bounding sphere it points, as
// a share of the sine of that sphere's angle.
template<class S>
void drawn(const Pose& pose, Random& random, StressTally& tally) {
    const auto narrow = [](const hostile::Vec& v) {
        return vec3<S>{static_cast<S>(v.x), static_cast<S>(v.y), static_cast<S>(v.z)};
    };
    const vec3<S> center = narrow(pose.center);
    const vec3<S> axis = narrow(pose.axis);
    const auto p = static_cast<S>(pose.p);
    const auto q = static_cast<S>(pose.q);
    const auto u = [&] { return static_cast<S>(random.bits() % 16 == 0 ? 0.0 : random.uniform(0.0, 1.0 - 1e-7)); };
    const auto look = [&](const auto& sampler) {
        for (int i = 0; i < 4; ++i) {
            const S u0 = u();
            const S u1 = u();
            const shading::LightSample<S> sample = sampler.sample(u0, u1);
            const auto input = [&] {
                return fmt::format("{} bytes, u {:a} {:a}, pdf {}, {}", sizeof(S), u0, u1, sample.pdf,
                                   hostile::to_text(pose));
            };
            tally.looked_at(1);
            tally.require(good(sample, sizeof(S) == 4 ? S(1e-5) : S(1e-12)), input);
            const S density = sampler.pdf(sample.direction);
            tally.require(density >= S(0) && std::isfinite(density), input);
            const double d = std::sqrt(shading::dot(pose.center, pose.center));
            const double sine = hostile::bounding_radius(pose) / d;
            if (sine >= 1.0) continue;
            const hostile::Vec to{double(sample.direction.x), double(sample.direction.y), double(sample.direction.z)};
            const hostile::Vec across = shading::cross(to, pose.center * (1.0 / d));
            const double off = std::sqrt(shading::dot(across, across));
            tally.require(off <= sine * 1.001 + (sizeof(S) == 4 ? 1e-6 : 1e-14), input);
        }
    };
    switch (pose.shape) {
    case hostile::Shape::sphere:
        return look(shading::SphereSampler<S>(center, p));
    case hostile::Shape::disk:
        return look(shading::DiskSampler<S>(center, axis, p));
    case hostile::Shape::rectangle:
        return look(shading::RectangleSampler<S>(center, axis, narrow(pose.across), p, q));
    case hostile::Shape::tube:
        return look(shading::TubeSampler<S>(center, axis, p, q));
    }
}

// Floats from 1e-3 to 1e3 sizes and off the edge, doubles to 1e4, or 1e3 near the edge. All poses are where a light has
// an outline: not inside it, and not in the plane of a flat light.
void towards_lights(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 8) {
        const auto shape = static_cast<hostile::Shape>(random.bits() % 4);
        const auto stratum = static_cast<Stratum>(random.bits() % hostile::stratum_count);
        if (stratum == Stratum::on || stratum == Stratum::inside) continue;
        const Pose pose = hostile::as_float(hostile::receiver(hostile::random_light(shape, random), stratum, random));
        const double sizes =
            std::sqrt(shading::dot(pose.center, pose.center)) / std::min(pose.p, hostile::bounding_radius(pose));
        if (sizes < (stratum == Stratum::grazing ? 1e3 : 1e4)) drawn<double>(pose, random, tally);
        if (sizes > 1e-3 && sizes < 1e3 && stratum != Stratum::grazing) drawn<float>(pose, random, tally);
    }
}

} // namespace

std::span<const StressSubject> geometry_stress() {
    static constexpr std::array subjects{
        StressSubject{"directions to angles and back, frames", "4e-15", 0.1, angles},
        StressSubject{"rays against solids", "1e-12 of the way; normals unit", 0.1, rays},
        StressSubject{"caps that overlap",
                      "within both; two sectors less a kite to 1e-12 of the smaller and 1e-18 of both sizes", 0.1,
                      caps},
        StressSubject{"directions drawn towards lights", "unit, within the light, densities above 0 and finite", 0.1,
                      towards_lights},
    };
    return subjects;
}

} // namespace gonio::measure::detail
