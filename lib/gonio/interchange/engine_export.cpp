// Lights that a script of engine_script.hpp has listed inside Unreal or Unity, as JSON.
//
// Unreal: centimetres, left-handed, Z up, light along +X. Candela; lumens of a point /4π, of a spot over the solid
// angle of its outer cone (at most 89°), of a rectangle /π; unitless v/625 candela; lux of a sun. A radius changes no
// intensity. The colour multiplies. A profile with its own brightness has its candela times a scale; without it the
// intensity is its peak. Spots fall as the square of a linear function of the cosine.
//
// Unity (HDRP): metres, left-handed, Y up, light along +Z. The stored intensity is in candela, of areas in nits, of a
// sun in lux, whatever unit is displayed. Cone angles are full ones in degrees.
#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::interchange_detail {

namespace {

using detail::Json;
using std::numbers::pi;

class EngineReader {
public:
    EngineReader(const Json& json, const std::string& source, const SceneReadOptions& options)
        : json_(json), source_(source), options_(options) {}

    Result<FoundScene> read() {
        const Json* const schema = json_.find("schema");
        if (schema == nullptr || !schema->is_string() || schema->as_string() != "gonio.engine-lights/1")
            return wrong("SCN0101", "the schema is not gonio.engine-lights/1");
        const Json* const program = json_.find("program");
        const std::string name = program != nullptr && program->is_string() ? program->as_string() : std::string();
        if (name != "unreal" && name != "unity") return wrong("SCN0101", "the program is neither unreal nor unity");
        const bool is_unreal = name == "unreal";
        scene_.generator = is_unreal ? "Unreal" : "Unity";
        scene_.meters_per_unit = options_.unit.value_or(Meters(is_unreal ? 0.01 : 1.0)).value;
        const Json* const lights = json_.find("lights");
        if (lights == nullptr || !lights->is_array()) return wrong("SCN0105", "'lights' must be an array");
        if (lights->size() > limit("scene-lights").value)
            return wrong("SCN0108", fmt::format("more than {}", to_text(limit("scene-lights"))));
        for (std::size_t i = 0; i < lights->size(); ++i) {
            const Json& one = (*lights)[i];
            at_ = fmt::format("lights[{}]", i);
            if (!one.is_object()) return wrong("SCN0105", at_ + " must be an object");
            FoundLight light;
            light.place = at_;
            light.location = {source_, 0, 0};
            Result<void> done = common(light, one, is_unreal);
            if (done) done = is_unreal ? unreal(light, one) : unity(light, one);
            if (!done) return pass_on(done);
            if (const Json* const visible = one.find("visible");
                light.shape && visible != nullptr && visible->is_boolean() && *visible == Json(false)) {
                light.shape.reset();
                remark(light, "SCN0204", "it is switched off");
            }
            scene_.lights.push_back(std::move(light));
        }
        return std::move(scene_);
    }

private:
    Unexpected wrong(SceneCode code, std::string message) {
        return scene_error(code, {source_, 0, 0}, std::move(message));
    }

    Result<double> number(const Json& json, std::string_view key, double otherwise) {
        const Json* const value = json.find(key);
        if (value == nullptr || value->is_null()) return otherwise;
        if (!value->is_number()) return wrong("SCN0105", fmt::format("{}.{} must be a number", at_, key));
        return value->as_double();
    }

    static bool flag(const Json& json, std::string_view key, bool otherwise) {
        const Json* const value = json.find(key);
        return value == nullptr ? otherwise : *value == Json(true);
    }

    static std::string text(const Json& json, std::string_view key) {
        const Json* const value = json.find(key);
        return value != nullptr && value->is_string() ? value->as_string() : std::string();
    }

    template<std::size_t count>
    Result<std::array<double, count>> numbers(const Json& json, std::string_view key,
                                              std::array<double, count> otherwise) {
        const Json* const value = json.find(key);
        if (value == nullptr) return otherwise;
        bool fits = value->is_array() && value->size() == count;
        for (std::size_t i = 0; fits && i < count; ++i) {
            fits = (*value)[i].is_number();
            if (fits) otherwise[i] = (*value)[i].as_double();
        }
        if (!fits) return wrong("SCN0105", fmt::format("{}.{} must be an array of {} numbers", at_, key, count));
        return otherwise;
    }

    // A vector in gonio's axes.
    Result<glm::dvec3> vector(const Json& json, std::string_view key, bool is_unreal) {
        Result<std::array<double, 3>> v = numbers<3>(json, key, {0.0, 0.0, 0.0});
        if (!v) return pass_on(v);
        return is_unreal ? glm::dvec3((*v)[0], -(*v)[1], (*v)[2]) : glm::dvec3((*v)[0], (*v)[2], (*v)[1]);
    }

    // Name, place, colour and amount.
    Result<void> common(FoundLight& light, const Json& json, bool is_unreal) {
        light.name = text(json, "name").substr(0, 200);
        light.kind = text(json, "kind").substr(0, 40);
        Result<double> intensity = number(json, "intensity", 0.0);
        if (!intensity) return pass_on(intensity);
        light.stated_amount = *intensity;
        unit_ = to_lower(text(json, is_unreal ? "intensity_units" : "unit")).substr(0, 40);
        light.stated = fmt::format("intensity {}{}{}", rounded(*intensity), unit_.empty() ? "" : " ", unit_);
        Result<std::array<double, 3>> written = numbers<3>(json, "color", {1.0, 1.0, 1.0});
        if (!written) return pass_on(written);
        glm::dvec3 rgb((*written)[0], (*written)[1], (*written)[2]);
        if (rgb != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(rgb));
        const bool is_tinted = rgb.x != rgb.y || rgb.y != rgb.z;
        if (flag(json, "use_temperature", false)) {
            Result<double> kelvin = number(json, "temperature", 6500.0);
            if (!kelvin) return pass_on(kelvin);
            rgb *= blackbody_color(light, *kelvin);
            light.temperature = Kelvin(*kelvin);
            light.stated += fmt::format(", {} K", rounded(*kelvin));
            if (!is_unreal) remark(light, "SCN0201", "its colour temperature is taken at luminance 1");
        }
        shining_ = *intensity * take_color(light, rgb);
        light.stated_color_max = 1.0;
        light.is_tinted = is_tinted;
        Result<glm::dvec3> position = vector(json, "position", is_unreal);
        if (!position) return pass_on(position);
        Result<glm::dvec3> forward = vector(json, "forward", is_unreal);
        if (!forward) return pass_on(forward);
        Result<glm::dvec3> up = vector(json, "up", is_unreal);
        if (!up) return pass_on(up);
        frame_ = glm::dmat4(glm::dvec4(glm::cross(*up, -*forward), 0.0), glm::dvec4(*up, 0.0),
                            glm::dvec4(-*forward, 0.0), glm::dvec4(*position, 1.0));
        return {};
    }

    void place(FoundLight& light) const {
        place_light(light, frame_, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, 'z', scene_.meters_per_unit);
    }

    // A spot of half angles in degrees, if they are possible.
    static bool take_spot(FoundLight& light, double inner_deg, double outer_deg) {
        light.stated_inner = inner_deg;
        light.stated_outer = outer_deg;
        if (!(outer_deg > 0.0 && outer_deg <= 90.0) || !(inner_deg >= 0.0)) {
            only_list(light, fmt::format("its cone is outside what a rig holds: half angles of {}° and {}°",
                                         rounded(inner_deg), rounded(outer_deg)));
            return false;
        }
        light.shape =
            SpotShape{degrees(outer_deg), degrees(std::min(inner_deg, outer_deg)), Falloff::frostbite, {}, {}};
        return true;
    }

    Result<void> unreal(FoundLight& light, const Json& json) {
        const double unit = scene_.meters_per_unit;
        Result<double> radius = number(json, "source_radius", 0.0);
        if (!radius) return pass_on(radius);
        Result<double> length = number(json, "source_length", 0.0);
        if (!length) return pass_on(length);
        Result<double> range = number(json, "attenuation_radius", 0.0);
        if (!range) return pass_on(range);
        Result<double> inner = number(json, "inner_cone_angle", 0.0);
        if (!inner) return pass_on(inner);
        Result<double> outer = number(json, "outer_cone_angle", 44.0);
        if (!outer) return pass_on(outer);
        if (light.kind == "DirectionalLight") {
            Result<double> angle = number(json, "light_source_angle", 0.5357);
            if (!angle) return pass_on(angle);
            if (!(*angle > 0.0 && *angle <= 180.0)) {
                *angle = 0.53;
                remark(light, "SCN0201", "its angle is 0: a diameter of 0.53° is assumed");
            }
            light.shape = SunShape{degrees(*angle)};
            light.intensity = amount(shining_, "lx");
            place(light);
            return {};
        }
        if (light.kind != "PointLight" && light.kind != "SpotLight" && light.kind != "RectLight") {
            only_list(light, light.kind == "SkyLight" ? std::string("light from all around is the sky of a rig")
                                                      : fmt::format("gonio does not read a '{}'", light.kind));
            return {};
        }
        if (!flag(json, "use_inverse_squared_falloff", true)) {
            remark(light, "SCN0308", "it does not fall with the square of the distance");
            only_list(light, "its amount is not a photometric one");
            return {};
        }
        const bool is_spot = light.kind == "SpotLight";
        const bool is_rect = light.kind == "RectLight";
        if (*range > 0.0) light.range = Meters(*range * unit);
        double candela = shining_;
        if (unit_ == "lumens") {
            constexpr double widest = 89.0;
            candela /= is_rect   ? pi
                       : is_spot ? 2.0 * pi * (1.0 - std::cos(degrees(std::min(*outer, widest)).value))
                                 : 4.0 * pi;
        } else if (unit_ == "unitless") {
            candela /= 625.0;
        } else if (unit_ != "candelas") {
            only_list(light, fmt::format("gonio does not read the unit '{}'", unit_));
            return {};
        }
        light.intensity = amount(candela, "cd");
        if (const std::string file = text(json, "ies"); !file.empty()) {
            ProfileShape profile;
            profile.file = file;
            light.shape = profile;
            if (flag(json, "use_ies_brightness", false)) {
                Result<double> scale = number(json, "ies_brightness_scale", 1.0);
                if (!scale) return pass_on(scale);
                light.profile_scale = shining_ != 0.0 ? *scale * candela_color(light) : 0.0;
                light.intensity.reset();
            }
            if (is_spot || is_rect)
                remark(light, "SCN0202", "a profile with a cone or a size: the profile alone is taken");
        } else if (is_rect) {
            Result<double> width = number(json, "source_width", 64.0);
            if (!width) return pass_on(width);
            Result<double> height = number(json, "source_height", 64.0);
            if (!height) return pass_on(height);
            if (!(*width > 0.0) || !(*height > 0.0)) {
                only_list(light, "its size is not above 0");
                return {};
            }
            light.shape = RectShape{Meters(*width * unit), Meters(*height * unit)};
        } else if (is_spot) {
            if (!take_spot(light, *inner, *outer)) return {};
            if (*radius > 0.0) remark(light, "SCN0202", "the radius of a spot is left out");
        } else if (*radius > 0.0 && !(*length > 0.0)) {
            light.shape = SphereShape{Meters(*radius * unit)};
        } else {
            light.shape = PointShape{};
            if (*length > 0.0) remark(light, "SCN0202", "a point with a source length: the length is left out");
        }
        place(light);
        return {};
    }

    // What the colour multiplies a profile by.
    double candela_color(const FoundLight& light) const {
        return light.stated_amount != 0.0 ? shining_ / light.stated_amount : 0.0;
    }

    Result<void> unity(FoundLight& light, const Json& json) {
        const double unit = scene_.meters_per_unit;
        Result<double> outer = number(json, "spot_angle", 30.0);
        if (!outer) return pass_on(outer);
        Result<double> inner = number(json, "inner_spot_angle", 0.0);
        if (!inner) return pass_on(inner);
        Result<double> radius = number(json, "radius", 0.0);
        if (!radius) return pass_on(radius);
        Result<double> range = number(json, "range", 0.0);
        if (!range) return pass_on(range);
        Result<std::array<double, 2>> size = numbers<2>(json, "area_size", {0.0, 0.0});
        if (!size) return pass_on(size);
        if (light.kind == "Directional") {
            light.shape = SunShape{degrees(0.53)};
            light.intensity = amount(shining_, "lx");
            remark(light, "SCN0201", "the list states no angular diameter: 0.53° is assumed");
            place(light);
            return {};
        }
        if (*range > 0.0) light.range = Meters(*range * unit);
        if (flag(json, "has_cookie", false)) remark(light, "SCN0202", "its cookie is left out");
        if (light.kind == "Point") {
            light.intensity = amount(shining_, "cd");
            if (*radius > 0.0)
                light.shape = SphereShape{Meters(*radius * unit)};
            else
                light.shape = PointShape{};
        } else if (light.kind == "Spot") {
            light.intensity = amount(shining_, "cd");
            if (!take_spot(light, 0.5 * *inner, 0.5 * *outer)) return {};
            if (*radius > 0.0) remark(light, "SCN0202", "the radius of a spot is left out");
        } else if (light.kind == "Rectangle" || light.kind == "Disc") {
            light.intensity = amount(shining_, "nt");
            const bool is_rect = light.kind == "Rectangle";
            if (!((*size)[0] > 0.0) || (is_rect && !((*size)[1] > 0.0))) {
                only_list(light, "its size is not above 0");
                return {};
            }
            if (is_rect)
                light.shape = RectShape{Meters((*size)[0] * unit), Meters((*size)[1] * unit)};
            else
                light.shape = DiskShape{Meters((*size)[0] * unit)};
        } else {
            only_list(light, light.kind == "Tube" ? std::string("HDRP's tube is a line without a luminance")
                                                  : fmt::format("gonio does not read a '{}'", light.kind));
            return {};
        }
        place(light);
        return {};
    }

    const Json& json_;
    const std::string& source_;
    const SceneReadOptions& options_;
    FoundScene scene_;
    std::string at_;
    std::string unit_;
    double shining_ = 0.0; // the intensity times the luminance of the colour
    glm::dmat4 frame_{1.0};
};

} // namespace

bool is_engine_export(std::string_view bytes) {
    constexpr std::size_t looked_at = 4096;
    const std::string_view text = trimmed(bytes.substr(0, looked_at));
    return text.starts_with('{') && text.find("gonio.engine-lights/") != std::string_view::npos;
}

Result<FoundScene> read_engine_export(std::string_view bytes, const std::string& source,
                                      const SceneReadOptions& options) {
    Result<Json> json = detail::parse_json(bytes, source);
    if (!json) {
        const SceneCode code = "SCN0102";
        json.error().diagnostics.back().code = code->code;
        return pass_on(json);
    }
    return EngineReader(*json, source, options).read();
}

} // namespace gonio::interchange_detail
