#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/shadow_body.hpp>
#include <gonio/scene/shadow_separation.hpp>

#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

template<class Numbers>
void put_frame(Numbers& to, const Frame& frame) {
    put(to.x, frame.x);
    put(to.y, frame.y);
    put(to.z, frame.z);
}

struct BodyNumbers {
    ShadowBody& to;

    void operator()(const Plane& plane) const {
        to.kind = ShadowBody::Kind::plane;
        put(to.middle, plane.point);
        put(to.z, plane.normal);
    }
    void operator()(const Panel& panel) const {
        to.kind = ShadowBody::Kind::panel;
        put(to.middle, panel.frame.origin);
        put_frame(to, panel.frame);
        put(to.half_size, {0.5 * panel.width, 0.5 * panel.height, 0.0});
    }
    void operator()(const Ball& ball) const {
        to.kind = ShadowBody::Kind::ball;
        put(to.middle, ball.center);
        to.radius = ball.radius;
    }
    void operator()(const Box& box) const {
        to.kind = ShadowBody::Kind::box;
        put(to.middle, box.frame.origin);
        put_frame(to, box.frame);
        put(to.half_size, box.half_size);
    }
    void operator()(const Capsule& capsule) const {
        to.kind = ShadowBody::Kind::capsule;
        put(to.middle, capsule.center);
        put(to.x, capsule.axis);
        to.half_size[0] = capsule.half_length;
        to.radius = capsule.radius;
    }
};

struct LightNumbers {
    LinedLight& to;

    void operator()(const SphereShape& sphere) const { round(LinedLight::Kind::ball, sphere.radius.value, 0.0); }
    void operator()(const TubeShape& tube) const {
        round(LinedLight::Kind::tube, tube.radius.value, 0.5 * tube.length.value);
    }
    void operator()(const CylinderShape& cylinder) const {
        round(LinedLight::Kind::cylinder, cylinder.radius.value, 0.5 * cylinder.length.value);
    }
    void operator()(const DiskShape& disk) const {
        round(LinedLight::Kind::disk, disk.radius.value, disk.radius.value);
        to.is_two_sided = disk.two_sided;
    }
    void operator()(const EllipseShape& ellipse) const {
        flat(LinedLight::Kind::ellipse, ellipse.width.value, ellipse.height.value, ellipse.two_sided);
    }
    void operator()(const RectShape& rect) const {
        flat(LinedLight::Kind::rectangle, rect.width.value, rect.height.value, rect.two_sided);
    }
    void operator()(const SunShape& /*no surface at a finite distance*/) const {}
    template<PunctualShape Kind>
    void operator()(const Kind& /*no surface*/) const {}

private:
    void round(LinedLight::Kind kind, double radius, double half_length) const {
        to.kind = kind;
        to.radius = radius;
        to.half_size[0] = half_length;
    }
    void flat(LinedLight::Kind kind, double width, double height, bool is_two_sided) const {
        to.kind = kind;
        to.half_size[0] = 0.5 * width;
        to.half_size[1] = 0.5 * height;
        to.is_two_sided = is_two_sided;
    }
};

} // namespace

ShadowBody shadow_body(const Primitive& body, const LinedLight& light) {
    ShadowBody numbers;
    std::visit(BodyNumbers{numbers}, body);
    if (const std::optional<Separation> between = separation(body, light)) {
        numbers.is_apart = true;
        put(numbers.between, between->point);
        put(numbers.to_light, between->normal);
    }
    if (const std::optional<Ball> around = bounds(body)) numbers.around = around->radius;
    return numbers;
}

LinedLight lined_light(const Light& light, const Ball& around) {
    LinedLight numbers;
    std::visit(LightNumbers{numbers}, light.shape);
    put(numbers.center, light.frame.origin);
    put_frame(numbers, light.frame);
    put(numbers.around, around.center);
    numbers.around_radius = around.radius;
    return numbers;
}

} // namespace gonio::detail
