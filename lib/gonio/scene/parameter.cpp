#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/scene/parameter.hpp>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>

namespace gonio {

namespace {

constexpr std::array of_lights{
    ParameterName{"cct", "2700K", "colour temperature: 2700K or 2700K/0.003"},
    ParameterName{"color", "d65", "colour, as --color takes it"},
    ParameterName{"intensity", "800lm", "amount: lm, cd, nt, lx, W"},
    ParameterName{"radius", "10cm", "sphere, disk, tube (r)"},
    ParameterName{"width", "60cm", "rect (w)"},
    ParameterName{"length", "1.2m", "tube (l)"},
    ParameterName{"size", "2", "sphere, disk, rect, tube: a factor on all of its lengths"},
    ParameterName{"h", "30cm", "rect: its height; frustum: its horizontal angle"},
    ParameterName{"v", "40deg", "frustum: its vertical angle"},
    ParameterName{"outer", "40deg", "spot: half angle of its edge"},
    ParameterName{"cone", "80deg", "spot: full angle of its edge"},
    ParameterName{"inner", "5deg", "spot: half angle up to which it is full"},
    ParameterName{"beam", "30deg", "spot: full angle at half of its peak; inner keeps its share of outer"},
    ParameterName{"falloff", "hard", "spot: from inner to outer"},
    ParameterName{"angle", "0.53deg", "sun: its diameter"},
    ParameterName{"x", "1m", "place of its centre"},
    ParameterName{"y", "1m", "place of its centre"},
    ParameterName{"height", "2.5m", "of its centre above 0"},
    ParameterName{"rotate", "90deg", "about its direction, C0 towards C90"},
    ParameterName{"yaw", "45deg", "turns its direction about the vertical, against the clock from above"},
    ParameterName{"range", "12m", "distance at which it is windowed to nothing"},
};

constexpr std::array of_materials{
    ParameterName{"albedo", "0.5", "lambert, eon, blinn"},
    ParameterName{"base", "0.5", "frostbite, ue4: base colour"},
    ParameterName{"f0", "0.9", "ggx, kulla-conty"},
    ParameterName{"roughness", "0.4", "ue4, eon, ggx, kulla-conty; frostbite and blinn: 1 - smoothness"},
    ParameterName{"smoothness", "0.6", "frostbite, blinn"},
    ParameterName{"alpha", "0.3", "ggx, kulla-conty: the square of roughness"},
    ParameterName{"metallic", "1", "ue4; frostbite: metal"},
    ParameterName{"reflectance", "0.5", "frostbite"},
    ParameterName{"specular", "0.5", "ue4, blinn"},
    ParameterName{"cavity", "0.5", "ue4"},
    ParameterName{"wet", "0.5", "blinn"},
};

// A shape of the kind, from text of its grammar.
template<class Kind>
Result<Kind> parse_as(const std::string& text) {
    Result<Shape> shape = parse_shape(text);
    if (!shape) return pass_on(shape);
    return std::get<Kind>(*shape);
}

// Takes the member of a shape that the grammar read.
template<class Kind, class Member>
Result<bool> take(Kind& shape, Member Kind::*member, const std::string& text) {
    Result<Kind> read = parse_as<Kind>(text);
    if (!read) return pass_on(read);
    shape.*member = (*read).*member;
    return true;
}

// The half angle at which a lobe has half of its peak.
Radians half_beam(const SpotShape& spot) {
    double inside = 0.0;
    double outside = spot.outer.value;
    for (int step = 0; step < 64; ++step) {
        const double middle = 0.5 * (inside + outside);
        (lobe(spot, Radians(middle)) >= 0.5 ? inside : outside) = middle;
    }
    return Radians(outside);
}

SpotShape with_outer(SpotShape spot, double outer, double inner_share) {
    spot.outer = Radians(outer);
    spot.inner = Radians(std::fmin(inner_share, 1.0) * outer);
    return spot;
}

// The beam widens with the outer angle, so that this is a search by halves.
Result<bool> set_beam(SpotShape& spot, const std::string& value) {
    Result<double> beam = parse_amount(value, Dimension::angle, "beam");
    if (!beam) return pass_on(beam);
    const double widest = 0.5 * std::numbers::pi;
    const double inner_share = spot.outer.value > 0.0 ? spot.inner / spot.outer : 0.0;
    const double most = 2.0 * half_beam(with_outer(spot, widest, inner_share)).value;
    if (!(*beam > 0.0) || *beam > most)
        return fail("USE0106",
                    fmt::format("beam of this 'spot' must be greater than 0deg and at most {}deg, not {}",
                                rounded(to_degrees(Radians(most))), value),
                    "it is the full angle at half of the peak");
    double low = 0.0;
    double high = widest;
    for (int step = 0; step < 64; ++step) {
        const double middle = 0.5 * (low + high);
        (2.0 * half_beam(with_outer(spot, middle, inner_share)).value < *beam ? low : high) = middle;
    }
    spot = with_outer(spot, high, inner_share);
    return true;
}

struct ShapeParameter {
    std::string_view name;
    std::string value;

    std::string text(std::string_view kind, std::string_view key, std::string_view others = "") const {
        return fmt::format("{}:{}={}{}", kind, key, value, others);
    }

    Result<bool> operator()(PointShape&) const { return false; }
    Result<bool> operator()(ProfileShape&) const { return false; }
    Result<bool> operator()(SpotShape& spot) const {
        if (name == "beam") return set_beam(spot, value);
        if (name == "falloff") return take(spot, &SpotShape::falloff, text("spot", "falloff", ",outer=45deg"));
        if (name == "inner") {
            // Bounded by the spot's own outer angle.
            Result<SpotShape> read = parse_as<SpotShape>(text("spot", "inner", ",outer=90deg"));
            if (!read) return pass_on(read);
            return set_angles(spot, read->inner, spot.outer);
        }
        if (name != "outer" && name != "cone") return false;
        Result<SpotShape> read = parse_as<SpotShape>(text("spot", name));
        if (!read) return pass_on(read);
        return set_angles(spot, spot.inner, read->outer);
    }
    Result<bool> operator()(FrustumShape& frustum) const {
        if (name == "h") return take(frustum, &FrustumShape::horizontal, text("frustum", "h", ",v=40deg"));
        if (name == "v") return take(frustum, &FrustumShape::vertical, text("frustum", "v", ",h=40deg"));
        return false;
    }
    Result<bool> operator()(SphereShape& sphere) const {
        if (name == "size") return scale({&sphere.radius});
        return name == "radius" ? take(sphere, &SphereShape::radius, text("sphere", "r")) : false;
    }
    Result<bool> operator()(DiskShape& disk) const {
        if (name == "size") return scale({&disk.radius});
        return name == "radius" ? take(disk, &DiskShape::radius, text("disk", "r")) : false;
    }
    Result<bool> operator()(RectShape& rect) const {
        if (name == "size") return scale({&rect.width, &rect.height});
        if (name == "width") return take(rect, &RectShape::width, text("rect", "w", ",h=1m"));
        return name == "h" ? take(rect, &RectShape::height, text("rect", "h", ",w=1m")) : false;
    }
    Result<bool> operator()(TubeShape& tube) const {
        if (name == "size") return scale({&tube.radius, &tube.length});
        if (name == "radius") return take(tube, &TubeShape::radius, text("tube", "r", ",l=1m"));
        return name == "length" ? take(tube, &TubeShape::length, text("tube", "l", ",r=1cm")) : false;
    }
    Result<bool> operator()(SunShape& sun) const {
        return name == "angle" ? take(sun, &SunShape::diameter, text("sun", "angle")) : false;
    }

private:
    Result<bool> scale(std::initializer_list<Meters*> lengths) const {
        const std::optional<double> factor = parse_number(value);
        if (!factor || !(*factor > 0.0))
            return fail("USE0106", fmt::format("size is a factor greater than 0, not '{}'", value));
        for (Meters* const length : lengths)
            length->value *= *factor;
        return true;
    }

    Result<bool> set_angles(SpotShape& spot, Radians inner, Radians outer) const {
        if (inner.value > outer.value)
            return fail("USE0106",
                        fmt::format("inner of 'spot', {}deg, is more than outer, {}deg", rounded(to_degrees(inner)),
                                    rounded(to_degrees(outer))),
                        "both are half angles from the axis");
        spot.inner = inner;
        spot.outer = outer;
        return true;
    }
};

Result<bool> set_color(LightDescription& light, std::string_view name, std::string_view value,
                       Diagnostics& diagnostics) {
    if (name == "cct") {
        Result<double> kelvin = parse_amount(value.substr(0, value.find('/')), Dimension::temperature, "cct");
        if (!kelvin) return pass_on(kelvin);
    }
    Result<glm::dvec3> color = parse_light_color(value, &diagnostics);
    if (!color) return pass_on(color);
    light.color = *color;
    return true;
}

glm::dvec3 turned(const glm::dvec3& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

Result<bool> set_angle(LightDescription& light, std::string_view name, std::string_view value) {
    Result<double> angle = parse_amount(value, Dimension::angle, name);
    if (!angle) return pass_on(angle);
    if (name == "rotate") {
        light.rotation = Radians(*angle);
    } else {
        light.direction = turned(light.direction, *angle);
        light.up = turned(light.up, *angle);
    }
    return true;
}

Result<bool> set_length(LightDescription& light, std::string_view name, std::string_view value) {
    if (std::holds_alternative<SunShape>(light.shape)) return false;
    Result<double> meters = parse_amount(value, Dimension::length, name);
    if (!meters) return pass_on(meters);
    if (name == "range") {
        if (!(*meters > 0.0)) return fail("USE0106", fmt::format("range must be greater than 0, not {}", value));
        light.range = Meters(*meters);
    } else {
        light.position[name == "x" ? 0 : name == "y" ? 1 : 2] = *meters;
    }
    return true;
}

// How the grammar calls a parameter of a material; empty where it has none of that name. Frostbite and Blinn count
// smoothness, the complement.
struct MaterialText {
    std::string_view kind;
    std::string_view key;
    bool complement = false;
};

struct MaterialParameter {
    std::string_view name;

    MaterialText operator()(const LambertMaterial&) const { return {"lambert", one_of({"albedo"})}; }
    MaterialText operator()(const EonMaterial&) const { return {"eon", one_of({"albedo", "roughness"})}; }
    MaterialText operator()(const GgxMaterial&) const { return {"ggx", one_of({"f0", "alpha", "roughness"})}; }
    MaterialText operator()(const KullaContyMaterial&) const {
        return {"kulla-conty", one_of({"f0", "alpha", "roughness"})};
    }
    MaterialText operator()(const FrostbiteMaterial&) const {
        if (name == "roughness") return {"frostbite", "smoothness", true};
        return {"frostbite", name == "metallic" ? "metal" : one_of({"base", "smoothness", "reflectance"})};
    }
    MaterialText operator()(const Ue4Material&) const {
        return {"ue4", one_of({"base", "roughness", "metallic", "specular", "cavity"})};
    }
    MaterialText operator()(const BlinnMaterial&) const {
        if (name == "roughness") return {"blinn", "smoothness", true};
        return {"blinn", one_of({"albedo", "specular", "smoothness", "wet"})};
    }

private:
    std::string_view one_of(std::initializer_list<std::string_view> keys) const {
        for (const std::string_view key : keys)
            if (key == name) return key;
        return {};
    }
};

// Takes over what the key stands for.
void take_key(LambertMaterial& to, const LambertMaterial& from, std::string_view /*albedo*/) {
    to.albedo = from.albedo;
}
void take_key(EonMaterial& to, const EonMaterial& from, std::string_view key) {
    key == "albedo" ? void(to.albedo = from.albedo) : void(to.roughness = from.roughness);
}
template<class Facets>
void take_facets(Facets& to, const Facets& from, std::string_view key) {
    key == "f0" ? void(to.f0 = from.f0) : void(to.alpha = from.alpha);
}
void take_key(GgxMaterial& to, const GgxMaterial& from, std::string_view key) {
    take_facets(to, from, key);
}
void take_key(KullaContyMaterial& to, const KullaContyMaterial& from, std::string_view key) {
    take_facets(to, from, key);
}
void take_key(FrostbiteMaterial& to, const FrostbiteMaterial& from, std::string_view key) {
    if (key == "base") to.base = from.base;
    if (key == "smoothness") to.smoothness = from.smoothness;
    if (key == "metal") to.metal = from.metal;
    if (key == "reflectance") to.reflectance = from.reflectance;
}
void take_key(Ue4Material& to, const Ue4Material& from, std::string_view key) {
    if (key == "base") to.base = from.base;
    if (key == "roughness") to.roughness = from.roughness;
    if (key == "metallic") to.metallic = from.metallic;
    if (key == "specular") to.specular = from.specular;
    if (key == "cavity") to.cavity = from.cavity;
}
void take_key(BlinnMaterial& to, const BlinnMaterial& from, std::string_view key) {
    if (key == "albedo") to.albedo = from.albedo;
    if (key == "specular") to.specular = from.specular;
    if (key == "smoothness") to.smoothness = from.smoothness;
    if (key == "wet") to.wet = from.wet;
}

} // namespace

std::span<const ParameterName> light_parameters() {
    return of_lights;
}

std::span<const ParameterName> material_parameters() {
    return of_materials;
}

Result<bool> set_parameter(LightDescription& light, std::string_view name, std::string_view value,
                           Diagnostics& diagnostics) {
    if (name == "cct" || name == "color") return set_color(light, name, value, diagnostics);
    if (name == "rotate" || name == "yaw") return set_angle(light, name, value);
    if (name == "x" || name == "y" || name == "height" || name == "range") return set_length(light, name, value);
    if (name == "intensity") {
        Result<PhotometricValue> amount = parse_photometric_value(value);
        if (!amount) return pass_on(amount);
        light.intensity = *amount;
        return true;
    }
    return std::visit(ShapeParameter{name, std::string(value)}, light.shape);
}

Result<bool> set_parameter(Material& material, std::string_view name, std::string_view value) {
    const MaterialText text = std::visit(MaterialParameter{name}, material);
    if (text.key.empty()) return false;
    std::string of_key(value);
    if (text.complement) {
        const std::optional<double> number = parse_number(value);
        if (!number || *number < 0.0 || *number > 1.0)
            return fail("USE0106", fmt::format("{} must be a number in [0, 1], not '{}'", name, value));
        of_key = shortest(1.0 - *number);
    }
    Result<Material> read = parse_material(fmt::format("{}:{}={}", text.kind, text.key, of_key));
    if (!read) return pass_on(read);
    std::visit([&](auto& to) { take_key(to, std::get<std::decay_t<decltype(to)>>(*read), text.key); }, material);
    return true;
}

std::vector<std::string_view> parameters_of(const LightDescription& light) {
    std::vector<std::string_view> names;
    for (const ParameterName& parameter : of_lights) {
        LightDescription scratch = light;
        Diagnostics unheard;
        // A bound of this light that the example misses is one of a parameter that it has.
        const Result<bool> set = set_parameter(scratch, parameter.name, parameter.example, unheard);
        if (!set || *set) names.push_back(parameter.name);
    }
    return names;
}

std::vector<std::string_view> parameters_of(const Material& material) {
    std::vector<std::string_view> names;
    for (const ParameterName& parameter : of_materials)
        if (!std::visit(MaterialParameter{parameter.name}, material).key.empty()) names.push_back(parameter.name);
    return names;
}

} // namespace gonio
