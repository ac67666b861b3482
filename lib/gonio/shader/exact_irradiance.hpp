// The exact irradiance of lights with a size, recorded: in stages, with names for what a reader looks for.
#pragma once

#include <gonio/shader/parameters.hpp>
// After the recording scalar.
#include <gonio/shading/irradiance_area.hpp>

#include <string>
#include <string_view>

namespace gonio::shader {

inline void name_direction(Function& f, const core::Direction<S>& d) {
    f.label("inverse_distance", d.inverse_distance);
    f.label("n_dot_l", d.n_dot_l);
}

// Names of intermediate results, for readers: computed again here, they are the same nodes. A name that the function
// does not need is not printed.

inline void label_rectangle(Function& f, core::detail::RectanglePose<S> p) {
    f.label("x", p.x, "From the receiver to the centre.");
    f.label("y", p.y);
    f.label("z", p.z);
    f.label("half_x", p.half_x,
            "The rectangle in its own axes: x along its width, y along its height, z to the receiver's side.");
    f.label("half_y", p.half_y);
    f.label("n_x", p.n_x);
    f.label("n_y", p.n_y);
    f.label("up", p.up, "Heights over the horizon: of the centre, and by which the corners differ from it.");
    f.label("rise_x", p.rise_x);
    f.label("rise_y", p.rise_y);
    // The edges' lines, as they are and mirrored so that n_x, n_y ≥ 0.
    const auto cut = p.up < simd::abs(p.rise_x) + simd::abs(p.rise_y);
    f.label("cut", cut);
    for (const bool mirrored : {false, true}) {
        if (mirrored) {
            p.z = simd::max(p.z, S(core::detail::least_rectangle_height<S>));
            core::detail::mirror(p);
            f.label("mirrored_x", p.x,
                    "Mirrored so that the normal points to +x and +y: corners go below the horizon in a fixed order.");
            f.label("mirrored_y", p.y);
            f.label("height_over", p.z);
        }
        const S x0 = p.x - p.half_x;
        const S x1 = p.x + p.half_x;
        const S y0 = p.y - p.half_y;
        const S y1 = p.y + p.half_y;
        const S z2 = p.z * p.z;
        const std::string_view prefix = mirrored ? "mirrored_" : "";
        const auto label = [&](std::string_view name, S value) {
            f.label(std::string(prefix) + std::string(name), value);
        };
        label("x0", x0);
        label("x1", x1);
        label("y0", y0);
        label("y1", y1);
        label("to_x0", simd::mul_add(x0, x0, z2));
        label("to_x1", simd::mul_add(x1, x1, z2));
        label("to_y0", simd::mul_add(y0, y0, z2));
        label("to_y1", simd::mul_add(y1, y1, z2));
    }
    const auto c = core::detail::rectangle_cut(p);
    f.label("a_x", c.a_x);
    f.label("a_y", c.a_y);
    f.label("b_x", c.b_x);
    f.label("b_y", c.b_y);
    f.label("before3", c.before3, "Where the horizon cuts the outline: at A and B, both from the centre.");
    f.label("before1", c.before1);
}

inline void label_disk(Function& f, core::detail::DiskPose<S> d) {
    f.label("x", d.x, "The disk in its own axes: the receiver is z in front of it and x aside.");
    f.label("inverse_x", d.inverse_x);
    f.label("n_u", d.n_u);
    f.label("n_v", d.n_v);
    f.label("n_across", d.n_across);
    f.label("gap", d.gap);
    f.label("beyond2", d.beyond2);
    f.label("k", simd::mul_add(d.z, d.n_w, d.x * d.n_u),
            "k is the height of the centre over the horizon, m the reach of the rim.");
    f.label("m", d.r * d.n_across);
    d.z = simd::max(d.z, S(core::detail::least_disk_height<S>));
    f.label("z", d.z);
    const S z2 = d.z * d.z;
    f.label("z2", z2);
    const S near2 = simd::mul_add(d.gap, d.gap, z2);
    const S far = d.x + d.r;
    const S far2 = simd::mul_add(far, far, z2);
    const S rim = simd::sqrt(near2) * simd::sqrt(far2);
    f.label("near2", near2, "The rim's nearest and farthest point.");
    f.label("far2", far2);
    f.label("rim", rim);
    f.label("e", S(2) * d.x * d.r);
}

inline void label_end(Function& f, const core::detail::EndCircle<S>& end, std::string_view suffix,
                      std::string_view note) {
    const auto label = [&](std::string_view name, auto value, std::string_view text = {}) {
        f.label(std::string(name) + std::string(suffix), value, text);
    };
    label("tangent", end.tangent, note);
    label("inverse_distance", end.inverse_distance);
    label("cos_h", end.cos_h);
    label("sin_h", end.sin_h);
    label("cos_reach", end.cos_reach);
    label("cos_sink", end.cos_sink);
    label("sin_sink", end.sin_sink);
    label("cos_rise", end.cos_rise);
    label("sin_rise", end.sin_rise);
    label("across", end.across);
}

inline void label_tube(Function& f, core::detail::TubePose<S> t) {
    f.label("half_length", t.half);
    f.label("z", t.z, "The tube in its own axes: a along it, f to it, g across; end 1 is the higher one.");
    f.label("z0", t.z0);
    f.label("z1", t.z1);
    f.label("d", t.d);
    f.label("inverse_d", t.inverse_d);
    f.label("n_a", t.n_a);
    f.label("n_f", t.n_f);
    f.label("n_g", t.n_g);
    f.label("up", t.up);
    t.gap2 = simd::max(t.gap2, S(core::detail::least_tube_gap2<S>) * t.d * t.d);
    const S gap = simd::sqrt(t.gap2);
    const S s = t.r * t.inverse_d;
    const S kappa = gap * t.inverse_d;
    const S up_by = t.half * t.n_a;
    f.label("gap", gap);
    f.label("s", s);
    f.label("kappa", kappa);
    f.label("up0", t.up - up_by);
    f.label("up1", t.up + up_by);
    const S level = t.up - s * t.r * t.n_f;
    const S out = t.r * kappa * t.n_g;
    const S level_plus = level + out;
    const S level_minus = level - out;
    f.label("level_plus", level_plus, "Heights of the lines where the receiver's planes touch the tube.");
    f.label("level_minus", level_minus);
    f.label("above0_plus", level_plus - up_by >= S(0));
    f.label("above0_minus", level_minus - up_by >= S(0));
    f.label("above1_plus", level_plus + up_by >= S(0));
    f.label("above1_minus", level_minus + up_by >= S(0));
    label_end(f, core::detail::end_circle(t, gap, t.z0, t.tangent0, t.up - up_by, S(-1)), "0",
              "The circle of end 0, and where the horizon cuts it.");
    label_end(f, core::detail::end_circle(t, gap, t.z1, t.tangent1, t.up + up_by, S(1)), "1", "The circle of end 1.");
}

// The exact form of each light: simple cases first, then all of it.

inline void sphere_stages(Function& f, const Sphere& light) {
    const core::Direction<S> d = core::direction(light.to_center, light.normal);
    name_direction(f, d);
    const core::SphereAbove<S> uncut(d, light.radius);
    f.label("s", uncut.s);
    f.label("above", uncut.irradiance);
    f.label("straddling", uncut.straddling);
    const Vector p = light.to_center;
    const S gap = simd::difference_of_squares(p.x, p.y, p.z, light.radius);
    const S kappa = simd::sqrt(simd::max(gap, S(0))) * d.inverse_distance;
    f.label("gap", gap, "The horizon cuts it, or the receiver is inside or on it.");
    f.label("kappa", kappa);
    f.label("w", simd::sqrt(simd::max((uncut.s - d.n_dot_l) * (uncut.s + d.n_dot_l), S(0))));
    f.early(!uncut.is_cut, uncut.irradiance, "All of it, or nothing, is above the horizon.");
    f.returns(core::irradiance_sphere(d, light.radius));
}

inline void disk_stages(Function& f, const Disk& light) {
    const auto above = core::detail::survey_disk_above(light.to_center, light.axis, light.radius, light.normal, false);
    f.early(!above.hard, above.irradiance, "All of it is above the horizon.");
    label_disk(f, core::detail::disk_pose(light.to_center, light.axis, light.radius, light.normal, false));
    f.returns(core::detail::survey_disk(light.to_center, light.axis, light.radius, light.normal, false).irradiance);
}

inline void rectangle_stages(Function& f, const Rectangle& light) {
    label_rectangle(f, core::detail::rectangle_pose<S>(light.to_center, light.axis, light.width_direction, light.width,
                                                       light.height, light.normal, false));
    const auto above = core::detail::survey_rectangle_above(light.to_center, light.axis, light.width_direction,
                                                            light.width, light.height, light.normal, false);
    f.early(!above.hard, above.irradiance, "All of it is above the horizon.");
    f.returns(core::detail::survey_rectangle(light.to_center, light.axis, light.width_direction, light.width,
                                             light.height, light.normal, false)
                  .irradiance);
}

inline void tube_stages(Function& f, const Tube& light) {
    const auto above =
        core::detail::survey_tube_above(light.to_center, light.axis, light.radius, light.length, light.normal);
    f.early(!above.hard, above.irradiance, "All of it is above the horizon.");
    label_tube(f, core::detail::tube_pose(light.to_center, light.axis, light.radius, light.length, light.normal));
    const auto tube = core::detail::survey_tube(light.to_center, light.axis, light.radius, light.length, light.normal);
    f.early(
        tube.end,
        core::detail::survey_tube_end(light.to_center, light.axis, light.radius, light.length, light.normal).irradiance,
        "From beyond an end, only the sphere of the nearer end is seen.");
    f.returns(tube.irradiance);
}

} // namespace gonio::shader
