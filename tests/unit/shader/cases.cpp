#include "cases.hpp"

// The scalar is double here; the recording scalar has come first, as its header asks.
#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/brdf_blinn.hpp>
#include <gonio/shading/brdf_eon.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_gltf.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_ue4.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/occlusion.hpp>
#include <gonio/shading/sample_disk.hpp>
#include <gonio/shading/sample_rectangle.hpp>
#include <gonio/shading/sample_sphere.hpp>
#include <gonio/shading/sample_tube.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/specular_by_share.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gonio::shader {

namespace {

using core_vector = shading::vec3<double>;
constexpr double pi = std::numbers::pi;

// Each draw is a statement of its own: compilers compute the sides of an operator in different orders.
class Dice {
public:
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    bool one_in(unsigned n) { return engine_() % n == 0; }
    core_vector direction() {
        const double z = between(-1.0, 1.0);
        const double phi = between(0.0, 2.0 * pi);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    core_vector anywhere(double least, double most) {
        const core_vector towards = direction();
        return towards * log_between(least, most);
    }
    core_vector across(core_vector axis) { return shading::normalized(shading::cross(axis, direction())); }
    core_vector color() { return {between(0.0, 1.0), between(0.0, 1.0), between(0.0, 1.0)}; }

private:
    std::mt19937_64 engine_{20260101};
};

// The inputs of one case: what is put in comes back as the float that the shader gets.
struct Inputs {
    std::vector<float> numbers;

    double put(double x) {
        numbers.push_back(static_cast<float>(x));
        return static_cast<double>(numbers.back());
    }
    core_vector put(core_vector a) {
        const double x = put(a.x);
        const double y = put(a.y);
        return {x, y, put(a.z)};
    }
    double at(std::size_t i) const { return static_cast<double>(numbers[i]); }
    core_vector vector(std::size_t i) const { return {at(i), at(i + 1), at(i + 2)}; }
};

// A light of any shape: half extents along three axes of its own, rounded by a radius.
struct Extent {
    core_vector x, y;
    double half_x, half_y, rounding;

    double size() const { return std::hypot(half_x, half_y) + rounding; }
};

// The vector to the light's centre: near its surface in one case of three, anywhere else.
core_vector place(Dice& dice, const Extent& extent) {
    if (!dice.one_in(3)) return dice.anywhere(0.02 * extent.size(), 300.0 * extent.size());
    const double along_x = extent.half_x * dice.between(-1.0, 1.0);
    const double along_y = extent.half_y * dice.between(-1.0, 1.0);
    core_vector on = extent.x * along_x + extent.y * along_y;
    if (dice.one_in(3)) on = on * (1.0 / std::max(1e-3, dice.between(0.0, 1.0))); // beside it
    const core_vector away = dice.direction();
    return on + away * (extent.rounding + extent.size() * dice.log_between(1e-4, 0.1));
}

// Often so that the horizon cuts a light of this size.
core_vector facing(Dice& dice, core_vector to_center, double size) {
    const core_vector l = shading::normalized(to_center);
    if (dice.one_in(2)) return dice.direction();
    const double reach = 1.2 * std::min(1.0, size / std::max(shading::length(to_center), 1e-30));
    const core_vector across = dice.across(l);
    return shading::normalized(across + l * dice.between(-reach, reach));
}

double subtended(double distance, double size) {
    return distance > size ? 2.0 * std::asin(size / distance) : pi;
}

struct Expected {
    double value;
    double scale;
    bool is_near;
};

// A flat light within a rectangle or a disk, or the axis of a tube: how far its surface is.
double distance_from(const Extent& extent, core_vector to_center, bool is_round) {
    double x = std::fabs(shading::dot(extent.x, to_center));
    double y = std::fabs(shading::dot(extent.y, to_center));
    const double z = std::fabs(shading::dot(shading::cross(extent.x, extent.y), to_center));
    if (is_round) {
        x = std::hypot(x, y);
        y = 0.0;
    }
    return std::hypot(std::hypot(std::max(x - extent.half_x, 0.0), std::max(y - extent.half_y, 0.0)), z) -
           extent.rounding;
}

Expected sphere_case(Dice& dice, Inputs& in, std::string_view method) {
    const double r = dice.log_between(0.02, 2.0);
    const Extent extent{{1, 0, 0}, {0, 1, 0}, 0.0, 0.0, r};
    const core_vector c = in.put(place(dice, extent));
    const double radius = in.put(r);
    const core_vector n = in.put(facing(dice, c, radius));
    const double d = shading::length(c);
    const bool is_near = std::fabs(d - radius) < 0.1 * radius;
    const auto value = [&] {
        if (method == "frostbite") return shading::irradiance_sphere_frostbite(c, radius, n);
        if (method == "ue4") return shading::irradiance_sphere_ue4(c, radius, n);
        if (method == "point") return shading::irradiance_sphere_point(c, radius, n);
        return shading::irradiance_sphere(c, radius, n);
    };
    return {value(), 0.1 * subtended(d, radius), is_near};
}

Expected disk_case(Dice& dice, Inputs& in, std::string_view method) {
    const core_vector axis = dice.direction();
    const core_vector across = dice.across(axis);
    const double r = dice.log_between(0.02, 2.0);
    const Extent extent{across, shading::cross(axis, across), r, r, 0.0};
    const core_vector c = in.put(place(dice, extent));
    const core_vector a = in.put(axis);
    const double radius = in.put(r);
    const core_vector n = in.put(facing(dice, c, radius));
    const auto value = [&] {
        if (method == "frostbite") return shading::irradiance_disk_frostbite(c, a, radius, n);
        if (method == "point") return shading::irradiance_disk_point(c, a, radius, n);
        return shading::irradiance_disk(c, a, radius, n);
    };
    return {value(), 0.1 * subtended(shading::length(c), radius), distance_from(extent, c, true) < 0.1 * r};
}

Expected rectangle_case(Dice& dice, Inputs& in, std::string_view method) {
    const core_vector axis = dice.direction();
    const core_vector across = dice.across(axis);
    const double w = dice.log_between(0.05, 4.0);
    const double h = dice.log_between(0.05, 4.0);
    const Extent extent{across, shading::cross(axis, across), 0.5 * w, 0.5 * h, 0.0};
    const core_vector c = in.put(place(dice, extent));
    const core_vector a = in.put(axis);
    const core_vector b = in.put(across);
    const double width = in.put(w);
    const double height = in.put(h);
    const core_vector n = in.put(facing(dice, c, extent.size()));
    const auto value = [&] {
        if (method == "frostbite") return shading::irradiance_rectangle_frostbite(c, a, b, width, height, n);
        if (method == "point") return shading::irradiance_rectangle_point(c, a, b, width, height, n);
        return shading::irradiance_rectangle(c, a, b, width, height, n);
    };
    return {value(), 0.1 * subtended(shading::length(c), extent.size()),
            distance_from(extent, c, false) < 0.1 * extent.size()};
}

Expected tube_case(Dice& dice, Inputs& in, std::string_view method) {
    const core_vector axis = dice.direction();
    const core_vector across = dice.across(axis);
    const double r = dice.log_between(0.01, 0.5);
    const double l = dice.log_between(0.05, 4.0);
    const Extent extent{axis, across, 0.5 * l, 0.0, r};
    const core_vector c = in.put(place(dice, extent));
    const core_vector a = in.put(axis);
    const double radius = in.put(r);
    const double length = in.put(l);
    const core_vector n = in.put(facing(dice, c, extent.size()));
    const auto value = [&] {
        if (method == "frostbite") return shading::irradiance_tube_frostbite(c, a, radius, length, n);
        if (method == "ue4") return shading::irradiance_tube_ue4(c, a, radius, length, n);
        if (method == "point") return shading::irradiance_tube_point(c, a, radius, length, n);
        return shading::irradiance_tube(c, a, radius, length, n);
    };
    return {value(), 0.1 * subtended(shading::length(c), extent.size()),
            distance_from(extent, c, false) < 0.1 * extent.size()};
}

Expected sun_case(Dice& dice, Inputs& in) {
    const double angle = dice.log_between(1e-3, 1.5);
    shading::SunLight<double> sun{};
    sun.toward = in.put(dice.direction());
    sun.sine = in.put(std::sin(angle));
    sun.cosine = in.put(std::cos(angle));
    const core_vector n = in.put(facing(dice, sun.toward, std::sin(angle)));
    return {shading::detail::irradiance(sun, sun.toward, n), 0.2 * angle, false};
}

// E/I of a point light without a window.
double inverse_square(core_vector to_light, core_vector n) {
    const double d2 = shading::dot(to_light, to_light);
    return std::max(shading::dot(n, to_light), 0.0) / (d2 * std::sqrt(d2));
}

Expected point_case(Dice& dice, Inputs& in, std::string_view method) {
    const core_vector l = in.put(dice.anywhere(0.01, 100.0));
    const core_vector n = in.put(dice.direction());
    const double d = shading::length(l);
    double window = 1.0;
    if (method != "inverse-square") {
        const double inverse_range = in.put(dice.one_in(4) ? 0.0 : dice.between(0.2, 1.5) / d);
        window = method == "window-gltf" ? shading::window_gltf(d, inverse_range)
                                         : shading::window_squared(d, inverse_range);
    }
    return {inverse_square(l, n) * window, 0.1 / (d * d), false};
}

Expected spot_case(Dice& dice, Inputs& in, std::string_view method) {
    const core_vector l = in.put(dice.anywhere(0.01, 100.0));
    const core_vector n = in.put(dice.direction());
    const double from = dice.log_between(0.02, 1.5);
    const double to = from + dice.log_between(0.02, 1.5);
    const double turn = dice.between(0.0, 1.2 * to);
    const core_vector away = shading::normalized(l * -1.0);
    const core_vector aim = in.put(away * std::cos(turn) + dice.across(away) * std::sin(turn));
    const double inner = in.put(from);
    const double outer = in.put(to);
    const double theta = shading::angle_from_aim(aim, l * -1.0);
    const auto lobe = [&] {
        if (method == "hard") return shading::lobe_hard(theta, inner, outer);
        if (method == "frostbite") return shading::lobe_frostbite(theta, inner, outer);
        if (method == "linear-cos") return shading::lobe_linear_cos(theta, inner, outer);
        if (method == "smoothstep-cos") return shading::lobe_smoothstep_cos(theta, inner, outer);
        if (method == "linear-angle") return shading::lobe_linear_angle(theta, inner, outer);
        return shading::lobe_smoothstep_angle(theta, inner, outer);
    };
    return {inverse_square(l, n) * lobe(), 0.1 / shading::dot(l, l), false};
}

// A direction on the upper side of n, grazing in one case of four.
core_vector above(Dice& dice, core_vector n) {
    const double cosine = dice.one_in(4) ? dice.log_between(1e-3, 1.0) : dice.between(-0.1, 1.0);
    return n * cosine + dice.across(n) * std::sqrt(1.0 - cosine * cosine);
}

// Roughness whose square is at least 0.01.
double roughness(Dice& dice) {
    return dice.between(0.1, 1.0);
}

struct Ways {
    core_vector n, l, v;
};

// Calls `use` with a random material of that name, for these directions.
template<class Use>
core_vector with_material(Dice& dice, Inputs& in, std::string_view material, const Ways& ways, const Use& use) {
    const core_vector color = in.put(dice.color());
    if (material == "lambert") return use(shading::Lambert<double>{color});
    if (material == "eon") return use(shading::Eon<double>{color, in.put(dice.between(0.0, 1.0))});
    if (material == "frostbite") {
        const double smoothness = in.put(1.0 - roughness(dice));
        const double metallic = in.put(dice.between(0.0, 1.0));
        return use(shading::frostbite_material(color, smoothness, metallic, in.put(dice.between(0.0, 1.0))));
    }
    if (material == "ue4") {
        const double metallic = in.put(dice.between(0.0, 1.0));
        const double rough = in.put(roughness(dice));
        const double specular = in.put(dice.between(0.0, 1.0));
        return use(shading::ue4_material(color, metallic, rough, specular, in.put(dice.between(0.0, 1.0))));
    }
    if (material == "gltf") {
        const double metallic = in.put(dice.between(0.0, 1.0));
        return use(shading::gltf_material(color, metallic, in.put(roughness(dice))));
    }
    if (material == "blinn") {
        const core_vector f0 = in.put(dice.color());
        const double smoothness = in.put(dice.between(0.0, 1.0));
        return use(shading::blinn_material(color, f0, smoothness, in.put(dice.between(0.0, 1.0))));
    }
    if (material == "kulla-conty") {
        const double to_light = std::clamp(shading::dot(ways.n, ways.l), 0.0, 1.0);
        const double to_eye = std::clamp(shading::dot(ways.n, ways.v), 0.0, 1.0);
        // An albedo that rounds to 1 leaves out the wide lobe, to which the core gives one sample in ten.
        double alpha = 0.0;
        do
            alpha = static_cast<double>(static_cast<float>(dice.between(0.01, 1.0)));
        while (to_eye > 1e-3 && shading::ggx_loss(alpha)(to_eye) < 1e-6);
        const shading::KullaConty<double> of = shading::kulla_conty_material(color, in.put(alpha));
        // In the place of the table's they are the core's own: the shader has to give what the core gives.
        in.put(1.0 - of.loss(to_light));
        in.put(1.0 - of.loss(to_eye));
        in.put(1.0 - of.loss.mean());
        return use(of);
    }
    const double alpha = in.put(dice.between(0.01, 1.0));
    return use(shading::Ggx<double>{color, alpha});
}

Expected area_case(Dice& dice, Inputs& in, std::string_view light, std::string_view method) {
    if (light == "sphere") return sphere_case(dice, in, method);
    if (light == "disk") return disk_case(dice, in, method);
    if (light == "rect") return rectangle_case(dice, in, method);
    if (light == "tube" || light == "capsule") return tube_case(dice, in, method);
    if (light == "sun") return sun_case(dice, in);
    if (light == "point") return point_case(dice, in, method);
    return spot_case(dice, in, method);
}

// A surface that is rougher along one direction, with a tangent anywhere across its normal.
struct Grain {
    core_vector tangent;
    shading::AnisotropicAlpha<double> alphas;

    Grain(Dice& dice, Inputs& in, core_vector n) {
        tangent = in.put(dice.across(n));
        alphas.x = in.put(dice.between(0.01, 1.0));
        alphas.y = in.put(dice.between(0.01, 1.0));
    }
    shading::TangentFrame<double> frame(core_vector n) const { return {tangent, n}; }
    shading::FacetPose<double> pose(core_vector n, core_vector l, core_vector v) const { return {frame(n), l, v}; }
    core_vector brdf(core_vector f0, core_vector n, core_vector l, core_vector v) const {
        return shading::reflected_part(f0, 1.0, shading::specular_ggx(pose(n, l, v), alphas, alphas));
    }
    shading::AnisotropicGgxInFrame<double> lobe(core_vector n, core_vector v) const {
        const shading::LtcFrame<double> in = shading::ltc_frame(n, v);
        return {alphas, {shading::dot(in.x, tangent), shading::dot(in.y, tangent)}, alphas.mean()};
    }
};

// An entry of the table at the nearest place, put in; returns the transformed cosine that it describes.
auto put_cosine(Inputs& in, core_vector n, core_vector v, double rough) {
    constexpr auto last = static_cast<double>(shading::ltc_ggx_size - 1);
    const double mu = std::clamp(shading::dot(n, v), 0.0, 1.0);
    const auto column = static_cast<std::size_t>(std::lround(std::min(rough, 1.0) * last));
    const auto row = static_cast<std::size_t>(std::lround(std::sqrt(mu) * last));
    const shading::LtcEntry entry = shading::ltc_ggx_table[row * shading::ltc_ggx_size + column];
    in.put(core_vector{static_cast<double>(entry.along), static_cast<double>(entry.raised),
                       static_cast<double>(entry.across)});
    in.put(core_vector{static_cast<double>(entry.slant), static_cast<double>(entry.albedo),
                       static_cast<double>(entry.grazing)});
    return [entry, alpha = rough * rough](double n_dot_v, double sine) {
        return shading::detail::lobe_from<double>(static_cast<double>(entry.along), static_cast<double>(entry.raised),
                                                  static_cast<double>(entry.across), static_cast<double>(entry.slant),
                                                  static_cast<double>(entry.albedo), static_cast<double>(entry.grazing),
                                                  alpha, std::clamp(n_dot_v, 0.0, 1.0), sine);
    };
}

// Calls `work` with the light that begins the inputs.
template<class Work>
auto with_light(const Inputs& in, std::string_view light, const Work& work) {
    const core_vector one{1.0, 1.0, 1.0};
    const core_vector c = in.vector(0);
    if (light == "sphere") return work(shading::SphereLight<double>{c, one, in.at(3), 0.0});
    if (light == "disk") return work(shading::DiskLight<double>{c, one, in.vector(3), in.at(6), 0.0, false});
    if (light == "rect")
        return work(
            shading::RectangleLight<double>{c, one, in.vector(3), in.vector(6), in.at(9), in.at(10), 0.0, false});
    return work(shading::TubeLight<double>{c, one, in.vector(3), in.at(6), in.at(7), 0.0});
}

// The luminance of a material under a light that begins the inputs, with the highlight by a representative point.
template<class Material>
core_vector shaded(const Inputs& in, std::string_view light, const shading::SurfacePoint<double>& point,
                   const Material& material) {
    if constexpr (Material::lobe != shading::LobeKind::none)
        return with_light(in, light, [&](const auto& shape) {
            return shading::shade<shading::SpecularMethod::representative_point>(point, shape, material);
        });
    return {};
}

// The highlight of GGX by rows of points or by the share of the transformed cosine, under a light that begins the
// inputs.
core_vector highlight(Dice& dice, Inputs& in, const ShaderFormula& names, core_vector c, core_vector n, core_vector v) {
    const core_vector f0 = in.put(dice.color());
    const double f90 = in.put(dice.between(0.0, 1.0));
    const auto found = [&] {
        if (names.material == "ggx-anisotropic") {
            const shading::AnisotropicGgxInFrame<double> lobe = Grain(dice, in, n).lobe(n, v);
            const double alpha = lobe.even_alpha();
            const auto even = put_cosine(in, n, v, std::sqrt(alpha));
            const auto cosine_of = [&](double n_dot_v, double sine) {
                return lobe.stretched(even(n_dot_v, sine), alpha);
            };
            return with_light(in, names.light, [&](const auto& shape) {
                return shading::specular_ltc(shape, c, n, v, lobe, cosine_of);
            });
        }
        const double rough = in.put(roughness(dice));
        const auto cosine_of = put_cosine(in, n, v, rough);
        const shading::GgxLobe<double> lobe{rough * rough};
        return with_light(in, names.light, [&](const auto& shape) {
            return names.method == "ltc" ? shading::specular_ltc(shape, c, n, v, lobe, cosine_of)
                                         : shading::specular_by_share(shape, c, n, v, lobe, cosine_of);
        });
    }();
    return (f0 + (core_vector{f90, f90, f90} - f0) * found.grazing) * found.scale;
}

// A material whose lobe is such a highlight, with its diffuse part, as shade.hpp adds both.
core_vector shaded_by_ltc(Dice& dice, Inputs& in, const ShaderFormula& names, core_vector c, core_vector n,
                          core_vector v) {
    return with_material(dice, in, names.material, {n, n, v}, [&]<class Material>(const Material& of) -> core_vector {
        if constexpr (Material::lobe == shading::LobeKind::ggx) {
            const auto gloss = shading::gloss(of);
            const auto cosine_of = put_cosine(in, n, v, std::sqrt(gloss.lobe.alpha));
            return with_light(in, names.light, [&](const auto& shape) {
                const shading::SurfacePoint<double> point{{0.0, 0.0, 0.0}, n, v};
                const double lx = shading::illuminance(point, shape);
                const core_vector diffuse = shading::scattered_parts(point, shape, of, lx).diffuse;
                const auto found = shading::specular_ltc(shape, c, n, v, gloss.lobe, cosine_of);
                return diffuse + gloss({found.scale, found.grazing});
            });
        } else {
            return {};
        }
    });
}

// Calls `work` with the core's sampler of the light that begins the inputs, with distances times `stretch`: in double,
// but a rectangle chooses its map as in float.
template<class Work>
auto with_sampler(const Inputs& in, std::string_view light, double stretch, const Work& work) {
    const core_vector c = in.vector(0) * stretch;
    if (light == "sphere") return work(shading::SphereSampler<double>(c, in.at(3)));
    if (light == "disk") return work(shading::DiskSampler<double>(c, in.vector(3), in.at(6)));
    if (light == "rect")
        return work(shading::RectangleSampler<double, float>(c, in.vector(3), in.vector(6), in.at(9), in.at(10)));
    return work(shading::TubeSampler<double, float>(c, in.vector(3), in.at(6), in.at(7)));
}

// Whether rounding decides nothing: `at(digits, stretch)` changes by at most 1e-4 of itself where inputs differ in
// their last digits, and by 2 % where distances differ by as much as float mistakes the solid angle that chooses a map.
template<class At>
bool is_steady(const At& at) {
    const core_vector here = at(0.0, 1.0);
    const auto is_alike = [&](double digits, double stretch, double share) {
        return shading::length(at(digits, stretch) - here) <= share * shading::length(here);
    };
    return is_alike(1e-6, 1.0, 1e-4) && is_alike(-1e-6, 1.0, 1e-4) && is_alike(0.0, 0.998, 0.02) &&
           is_alike(0.0, 1.002, 0.02);
}

// A direction towards a light, divided by its density.
bool draw_light_sample(Dice& dice, Inputs& in, std::string_view light, core_vector& value) {
    const double u0 = in.put(dice.between(0.0, 0.9999));
    const double u1 = in.put(dice.between(0.0, 0.9999));
    const auto at = [&](double digits, double stretch) {
        const auto drawn = with_sampler(in, light, stretch, [&](const auto& sampler) {
            return sampler.sample(std::max(u0 + digits, 0.0), std::max(u1 + digits, 0.0));
        });
        return drawn.pdf > 0.0 ? drawn.direction * (1.0 / drawn.pdf) : core_vector{0.0, 0.0, 0.0};
    };
    value = at(0.0, 1.0);
    return is_steady(at);
}

// The density of a direction that meets a light, or in one case of eight of one that misses it; at least 0.01 rad off
// the plane of a flat light, near which the cosine at the light has lost its digits.
bool draw_light_density(Dice& dice, Inputs& in, std::string_view light, core_vector& value) {
    const double u0 = dice.between(0.0, 0.9999);
    const double u1 = dice.between(0.0, 0.9999);
    core_vector drawn =
        with_sampler(in, light, 1.0, [&](const auto& sampler) { return sampler.sample(u0, u1); }).direction;
    const core_vector across = dice.across(drawn);
    const bool misses = dice.one_in(8);
    if (misses) drawn = shading::normalized(drawn + across * dice.log_between(1e-2, 1.0));
    const core_vector direction = in.put(drawn);
    if (is_flat(light) && std::fabs(shading::dot(in.vector(3), direction)) < 0.01) return false;
    const core_vector up = shading::cross(direction, across);
    const auto at = [&](double digits, double stretch) {
        const core_vector turned = direction + (across + up * 0.5) * digits;
        const double pdf = with_sampler(in, light, stretch,
                                        [&](const auto& sampler) { return sampler.pdf(shading::normalized(turned)); });
        return core_vector{pdf, pdf, pdf};
    };
    value = at(0.0, 1.0);
    return (misses || value.x > 0.0) && is_steady(at);
}

Case random_case(const Formula& formula, Dice& dice) {
    const ShaderFormula& names = formula.names;
    Inputs in;
    core_vector value{};
    double scale = 0.1;
    bool is_near = false;
    const bool is_grained = names.material == "ggx-anisotropic";
    const auto take = [&](const Expected& expected) {
        value = {expected.value, expected.value, expected.value};
        scale = expected.scale;
        is_near = expected.is_near;
    };
    if (names.what == "brdf") {
        const core_vector n = in.put(dice.direction());
        const core_vector l = in.put(above(dice, n));
        const core_vector v = in.put(above(dice, n));
        if (is_grained) {
            const core_vector f0 = in.put(dice.color());
            value = Grain(dice, in, n).brdf(f0, n, l, v);
        } else {
            value = with_material(dice, in, names.material, {n, l, v},
                                  [&](const auto& of) { return shading::brdf(of, n, l, v); });
        }
    } else if (!names.light.empty() && (names.what == "sample" || names.what == "pdf")) {
        const bool is_sample = names.what == "sample";
        const auto draw = is_sample ? draw_light_sample : draw_light_density;
        do {
            in.numbers.clear();
            const Expected lit = area_case(dice, in, names.light, names.method);
            scale = is_sample ? 10.0 * lit.scale * lit.scale : 0.0;
            is_near = lit.is_near;
        } while (!draw(dice, in, names.light, value));
        if (!is_sample && value.x == 0.0) scale = 1.0;
    } else if (names.what == "sample") {
        const core_vector n = in.put(dice.direction());
        core_vector eye = above(dice, n);
        while (names.material == "kulla-conty" && shading::dot(n, eye) < 1e-3) // no table has a loss there
            eye = above(dice, n);
        const core_vector v = in.put(eye);
        const core_vector u = in.put(dice.color());
        if (is_grained) {
            in.put(dice.color());
            const Grain grain(dice, in, n);
            const shading::TangentFrame<double> frame = grain.frame(n);
            value = frame.to_world(shading::reflected_direction_ggx(frame.to_local(v), grain.alphas, u.x, u.y));
        } else {
            value = with_material(dice, in, names.material, {n, n, v},
                                  [&](const auto& of) { return shading::sample_brdf(of, n, v, u).l; });
        }
    } else if (names.what == "pdf") {
        const core_vector n = in.put(dice.direction());
        const core_vector v = in.put(above(dice, n));
        const core_vector l = in.put(above(dice, n));
        const auto all_alike = [](double pdf) { return core_vector{pdf, pdf, pdf}; };
        if (is_grained) {
            in.put(dice.color());
            const Grain grain(dice, in, n);
            value = all_alike(shading::pdf_reflected_ggx(grain.pose(n, l, v), grain.alphas));
        } else {
            value = with_material(dice, in, names.material, {n, l, v},
                                  [&](const auto& of) { return all_alike(shading::pdf_brdf(of, n, v, l)); });
        }
    } else if (names.what == "roughness") {
        const core_vector n = in.put(dice.direction());
        const core_vector v = in.put(above(dice, n));
        value.x = std::sqrt(Grain(dice, in, n).lobe(n, v).even_alpha());
    } else if (names.what == "shade" && (names.light == "point" || names.light == "spot")) {
        const bool is_spot = names.light == "spot";
        const Expected lit = is_spot ? spot_case(dice, in, names.method) : point_case(dice, in, names.method);
        const core_vector to_light = in.vector(0);
        const core_vector n = in.vector(3);
        const core_vector v = in.put(above(dice, n));
        const core_vector l = shading::normalized(to_light);
        if (is_grained) {
            const core_vector f0 = in.put(dice.color());
            value = Grain(dice, in, n).brdf(f0, n, l, v) * lit.value;
        } else {
            value = with_material(dice, in, names.material, {n, l, v},
                                  [&](const auto& of) { return shading::brdf(of, n, l, v) * lit.value; });
        }
        scale = lit.scale;
    } else if (names.what == "shade") {
        const Expected lit = area_case(dice, in, names.light, names.method);
        const core_vector c = in.vector(0);
        const core_vector n = in.vector(in.numbers.size() - 3);
        scale = lit.scale;
        is_near = lit.is_near;
        if (names.material == "lambert") {
            value = in.put(dice.color()) * (lit.value / pi);
        } else {
            const core_vector v = in.put(above(dice, n));
            const bool by_cosine = names.method == "ltc" || names.method == "ltc-share";
            const bool is_lobe_alone = names.material == "ggx" || is_grained;
            if (by_cosine)
                value = is_lobe_alone ? highlight(dice, in, names, c, n, v) : shaded_by_ltc(dice, in, names, c, n, v);
            else
                value = with_material(dice, in, names.material, {n, n, v}, [&](const auto& of) {
                    return shaded(in, names.light, {{0.0, 0.0, 0.0}, n, v}, of);
                });
        }
    } else if (names.what == "visibility") {
        take(area_case(dice, in, names.shadow_of, names.method));
        const double left = std::clamp(1.0 - value.x / pi, 0.0, 1.0);
        value = {left, left, left};
    } else {
        take(area_case(dice, in, names.light, names.method));
    }
    return {std::move(in.numbers), {value.x, value.y, value.z}, scale, is_near};
}

} // namespace

std::vector<Case> random_cases(const Formula& formula, std::size_t count) {
    Dice dice;
    std::vector<Case> cases;
    for (std::size_t i = 0; i < count; ++i)
        cases.push_back(random_case(formula, dice));
    return cases;
}

double error_of(const Case& pose, const std::array<double, 3>& result, Type type) {
    double largest = 0.0;
    for (std::size_t i = 0; i < (type == Type::vector ? 3U : 1U); ++i) {
        const double error = std::fabs(result[i] - pose.expected[i]) / (std::fabs(pose.expected[i]) + pose.scale);
        largest = error >= largest ? error : (error < largest ? largest : 1e30); // a NaN is an error too
    }
    return largest;
}

} // namespace gonio::shader
