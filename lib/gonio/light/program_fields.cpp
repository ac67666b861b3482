#include <gonio/base/unit_text.hpp>
#include <gonio/light/program_fields.hpp>
#include <gonio/light/shape_traits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <variant>

namespace gonio {

namespace {

enum class What {
    amount,      // in `unit`
    word,        // `unit` itself
    radius,      // lengths in `unit`
    diameter,    //
    width,       //
    height,      //
    length,      // of a tube's cylinder
    outer_half,  // angles in `unit`
    outer_full,  //
    inner_half,  //
    inner_share, // inner over outer, in per cent
    penumbra,    // 1 − inner over outer
    blend,       // how far the inner cosine is on the way from the outer one to 1
    sun,         // angular diameter
    sun_radius   // half of it
};

struct FieldRow {
    std::string_view name;
    What what;
    std::string_view unit = {};
};

using Rows = std::span<const FieldRow>;

// What a program has for one kind of shape.
struct LightRow {
    std::string_view program; // a policy
    std::string_view kind;    // of shapes
    std::string_view light;
    Rows fields;
};

// Unreal Engine 5: UPointLightComponent, USpotLightComponent, URectLightComponent, UDirectionalLightComponent.
constexpr std::array unreal_point{FieldRow{"Intensity", What::amount, "lm"},
                                  FieldRow{"Intensity Units", What::word, "Lumens"},
                                  FieldRow{"Source Radius", What::radius, "cm"}};
constexpr std::array unreal_tube{
    FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"Intensity Units", What::word, "Lumens"},
    FieldRow{"Source Radius", What::radius, "cm"}, FieldRow{"Source Length", What::length, "cm"}};
constexpr std::array unreal_spot{
    FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"Intensity Units", What::word, "Lumens"},
    FieldRow{"Inner Cone Angle", What::inner_half, "deg"}, FieldRow{"Outer Cone Angle", What::outer_half, "deg"}};
constexpr std::array unreal_rect{
    FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"Intensity Units", What::word, "Lumens"},
    FieldRow{"Source Width", What::width, "cm"}, FieldRow{"Source Height", What::height, "cm"}};
constexpr std::array unreal_sun{FieldRow{"Intensity", What::amount, "lx"}, FieldRow{"Source Angle", What::sun, "deg"}};

// Unity, High Definition Render Pipeline: HDAdditionalLightData.
constexpr std::array unity_point{FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"unit", What::word, "Lumen"},
                                 FieldRow{"Radius", What::radius, "m"}};
constexpr std::array unity_spot{FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"unit", What::word, "Lumen"},
                                FieldRow{"Reflector", What::word, "off"},
                                FieldRow{"Outer Angle", What::outer_full, "deg"},
                                FieldRow{"Inner Angle", What::inner_share, "%"}};
constexpr std::array unity_rect{FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"unit", What::word, "Lumen"},
                                FieldRow{"Size X", What::width, "m"}, FieldRow{"Size Y", What::height, "m"}};
constexpr std::array unity_disk{FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"unit", What::word, "Lumen"},
                                FieldRow{"Radius", What::radius, "m"}};
constexpr std::array unity_tube{FieldRow{"Intensity", What::amount, "lm"}, FieldRow{"unit", What::word, "Lumen"},
                                FieldRow{"Length", What::length, "m"}};
constexpr std::array unity_sun{FieldRow{"Intensity", What::amount, "lx"}, FieldRow{"unit", What::word, "Lux"},
                               FieldRow{"Angular Diameter", What::sun, "deg"}};

// Godot 4 with physical light units: Light3D.
constexpr std::array godot_point{FieldRow{"light_intensity_lumens", What::amount, "lm"},
                                 FieldRow{"light_size", What::radius, "m"}};
constexpr std::array godot_spot{FieldRow{"light_intensity_lumens", What::amount, "lm"},
                                FieldRow{"spot_angle", What::outer_half, "deg"}};
constexpr std::array godot_sun{FieldRow{"light_intensity_lux", What::amount, "lx"},
                               FieldRow{"light_angular_distance", What::sun, "deg"}};

// Blender, Cycles: the radiant power that its IES loader takes for a lumen.
constexpr std::string_view blender_watts = "W@cycles-ies-177.83";
constexpr std::array blender_point{FieldRow{"Power", What::amount, blender_watts},
                                   FieldRow{"Radius", What::radius, "m"}};
constexpr std::array blender_spot{FieldRow{"Power", What::amount, blender_watts},
                                  FieldRow{"Spot Size", What::outer_full, "deg"}, FieldRow{"Blend", What::blend}};
constexpr std::array blender_disk{FieldRow{"Power", What::amount, blender_watts}, FieldRow{"Shape", What::word, "Disk"},
                                  FieldRow{"Size", What::diameter, "m"}};
constexpr std::array blender_ellipse{FieldRow{"Power", What::amount, blender_watts},
                                     FieldRow{"Shape", What::word, "Ellipse"}, FieldRow{"Size X", What::width, "m"},
                                     FieldRow{"Size Y", What::height, "m"}};
constexpr std::array blender_rect{FieldRow{"Power", What::amount, blender_watts},
                                  FieldRow{"Shape", What::word, "Rectangle"}, FieldRow{"Size X", What::width, "m"},
                                  FieldRow{"Size Y", What::height, "m"}};

// three.js: PointLight, SpotLight, RectAreaLight, DirectionalLight.
constexpr std::array three_point{FieldRow{"intensity", What::amount, "cd"}};
constexpr std::array three_spot{FieldRow{"intensity", What::amount, "cd"}, FieldRow{"angle", What::outer_half, "rad"},
                                FieldRow{"penumbra", What::penumbra}};
constexpr std::array three_rect{FieldRow{"intensity", What::amount, "nt"}, FieldRow{"width", What::width, "m"},
                                FieldRow{"height", What::height, "m"}};
constexpr std::array three_sun{FieldRow{"intensity", What::amount, "lx"}};

// Filament: LightManager::Builder.
constexpr std::array filament_point{FieldRow{"intensity", What::amount, "lm"}};
constexpr std::array filament_spot{FieldRow{"intensity", What::amount, "lm"},
                                   FieldRow{"spotLightCone inner", What::inner_half, "rad"},
                                   FieldRow{"spotLightCone outer", What::outer_half, "rad"}};
constexpr std::array filament_sun{FieldRow{"intensity", What::amount, "lx"},
                                  FieldRow{"sunAngularRadius", What::sun_radius, "deg"}};

// Khronos, KHR_lights_punctual.
constexpr std::array gltf_point{FieldRow{"intensity", What::amount, "cd"}};
constexpr std::array gltf_spot{FieldRow{"intensity", What::amount, "cd"},
                               FieldRow{"innerConeAngle", What::inner_half, "rad"},
                               FieldRow{"outerConeAngle", What::outer_half, "rad"}};
constexpr std::array gltf_sun{FieldRow{"intensity", What::amount, "lx"}};

// UsdLux.
constexpr std::array usd_sphere{FieldRow{"inputs:intensity", What::amount, "nt"},
                                FieldRow{"inputs:radius", What::radius, "m"}};
constexpr std::array usd_rect{FieldRow{"inputs:intensity", What::amount, "nt"},
                              FieldRow{"inputs:width", What::width, "m"}, FieldRow{"inputs:height", What::height, "m"}};
constexpr std::array usd_tube{FieldRow{"inputs:intensity", What::amount, "nt"},
                              FieldRow{"inputs:radius", What::radius, "m"},
                              FieldRow{"inputs:length", What::length, "m"}};
constexpr std::array usd_sun{FieldRow{"inputs:intensity", What::amount, "lx"},
                             FieldRow{"inputs:normalize", What::word, "true"},
                             FieldRow{"inputs:angle", What::sun, "deg"}};

constexpr std::array lights{
    LightRow{"unreal", "point", "Point Light", Rows(unreal_point).first(2)},
    LightRow{"unreal", "sphere", "Point Light", unreal_point},
    LightRow{"unreal", "tube", "Point Light", unreal_tube},
    LightRow{"unreal", "spot", "Spot Light", unreal_spot},
    LightRow{"unreal", "rect", "Rect Light", unreal_rect},
    LightRow{"unreal", "sun", "Directional Light", unreal_sun},
    LightRow{"unity-hdrp", "point", "Point", Rows(unity_point).first(2)},
    LightRow{"unity-hdrp", "sphere", "Point", unity_point},
    LightRow{"unity-hdrp", "spot", "Spot, Cone", unity_spot},
    LightRow{"unity-hdrp", "rect", "Area, Rectangle", unity_rect},
    LightRow{"unity-hdrp", "disk", "Area, Disc", unity_disk},
    LightRow{"unity-hdrp", "tube", "Area, Tube", unity_tube},
    LightRow{"unity-hdrp", "sun", "Directional", unity_sun},
    LightRow{"filament", "point", "POINT", filament_point},
    LightRow{"filament", "spot", "SPOT", filament_spot},
    LightRow{"filament", "sun", "SUN", filament_sun},
    LightRow{"godot", "point", "OmniLight3D", Rows(godot_point).first(1)},
    LightRow{"godot", "sphere", "OmniLight3D", godot_point},
    LightRow{"godot", "spot", "SpotLight3D", godot_spot},
    LightRow{"godot", "sun", "DirectionalLight3D", godot_sun},
    LightRow{"threejs", "point", "PointLight", three_point},
    LightRow{"threejs", "spot", "SpotLight", three_spot},
    LightRow{"threejs", "rect", "RectAreaLight", three_rect},
    LightRow{"threejs", "sun", "DirectionalLight", three_sun},
    LightRow{"gltf", "point", "point", gltf_point},
    LightRow{"gltf", "spot", "spot", gltf_spot},
    LightRow{"gltf", "sun", "directional", gltf_sun},
    LightRow{"usd", "sphere", "SphereLight", usd_sphere},
    LightRow{"usd", "disk", "DiskLight", usd_sphere},
    LightRow{"usd", "rect", "RectLight", usd_rect},
    LightRow{"usd", "tube", "CylinderLight", usd_tube},
    LightRow{"usd", "cylinder", "CylinderLight", usd_tube},
    LightRow{"usd", "sun", "DistantLight", usd_sun},
    LightRow{"blender", "point", "Point", Rows(blender_point).first(1)},
    LightRow{"blender", "sphere", "Point", blender_point},
    LightRow{"blender", "spot", "Spot", blender_spot},
    LightRow{"blender", "disk", "Area", blender_disk},
    LightRow{"blender", "ellipse", "Area", blender_ellipse},
    LightRow{"blender", "rect", "Area", blender_rect},
};

const LightRow* find_light(std::string_view program, std::string_view kind) {
    const auto* const found = std::find_if(
        lights.begin(), lights.end(), [&](const LightRow& row) { return row.program == program && row.kind == kind; });
    return found == lights.end() ? nullptr : found;
}

// The numbers of a shape, by what fields ask for; nothing where the shape has none.
struct Sizes {
    std::optional<Meters> radius, width, height, length;
    std::optional<Radians> outer, inner, sun;
};

Sizes sizes_of(const Shape& shape) {
    Sizes sizes;
    std::visit(
        [&]<class Kind>(const Kind& kind) {
            if constexpr (requires { kind.radius; }) sizes.radius = kind.radius;
            if constexpr (requires { kind.width; }) sizes.width = kind.width;
            if constexpr (requires { kind.height; }) sizes.height = kind.height;
            if constexpr (requires { kind.length; }) sizes.length = kind.length;
            if constexpr (requires { kind.outer; }) sizes.outer = kind.outer;
            if constexpr (requires { kind.inner; }) sizes.inner = kind.inner;
            if constexpr (requires { kind.diameter; }) sizes.sun = kind.diameter;
        },
        shape);
    return sizes;
}

std::string in(std::string_view unit, double base) {
    return rounded(base / find_unit(unit)->base_per_unit);
}

std::string value_of(const FieldRow& row, const Sizes& sizes) {
    const double outer = sizes.outer.value_or(Radians()).value;
    const double inner = sizes.inner.value_or(Radians()).value;
    const double share = outer > 0.0 ? inner / outer : 0.0;
    switch (row.what) {
    case What::radius:
        return in(row.unit, sizes.radius.value_or(Meters()).value);
    case What::diameter:
        return in(row.unit, 2.0 * sizes.radius.value_or(Meters()).value);
    case What::width:
        return in(row.unit, sizes.width.value_or(Meters()).value);
    case What::height:
        return in(row.unit, sizes.height.value_or(Meters()).value);
    case What::length:
        return in(row.unit, sizes.length.value_or(Meters()).value);
    case What::outer_half:
        return in(row.unit, outer);
    case What::outer_full:
        return in(row.unit, 2.0 * outer);
    case What::inner_half:
        return in(row.unit, inner);
    case What::inner_share:
        return rounded(100.0 * share);
    case What::penumbra:
        return rounded(1.0 - share);
    case What::blend: {
        const double rim = std::cos(outer);
        return rounded(rim < 1.0 ? (std::cos(inner) - rim) / (1.0 - rim) : 0.0);
    }
    case What::sun:
        return in(row.unit, sizes.sun.value_or(Radians()).value);
    case What::sun_radius:
        return in(row.unit, 0.5 * sizes.sun.value_or(Radians()).value);
    case What::word:
        return std::string(row.unit);
    case What::amount:
        break;
    }
    return {};
}

// The number to type for what the light emits.
Result<ProgramField> amount_field(const FieldRow& row, const Policy& program, const Shape& shape,
                                  const Emission& emission, std::string& note) {
    Result<PhotometricUnit> unit = parse_photometric_unit(row.unit);
    if (!unit) return pass_on(unit);
    Result<double> number = express(shape, emission, *unit);
    if (!number) return pass_on(number);
    Result<PolicyMeaning> meaning = policy_meaning(program, shape, unit->unit->dimension);
    if (!meaning) return pass_on(meaning);
    note = meaning->note;
    return ProgramField{std::string(row.name), rounded(policy_number(*meaning, *unit, *number)),
                        std::string(unit->unit->symbol)};
}

} // namespace

std::vector<const Policy*> programs_with_fields() {
    std::vector<const Policy*> programs;
    for (const Policy& policy : policies())
        if (std::any_of(lights.begin(), lights.end(), [&](const LightRow& row) { return row.program == policy.name; }))
            programs.push_back(&policy);
    return programs;
}

Result<ProgramLight> program_light(const Policy& program, const Shape& shape, const Emission& emission) {
    const LightRow* row = find_light(program.name, kind_of(shape));
    const bool sphere = std::holds_alternative<SphereShape>(shape) && mask_of(shape).file == nullptr;
    if (row == nullptr && sphere) row = find_light(program.name, "point");
    if (row == nullptr || mask_of(shape).file != nullptr)
        return fail(Failure::unsupported, fmt::format("{} does not have {}{} lights", program.name,
                                                      mask_of(shape).file != nullptr ? "masked " : "", kind_of(shape)));
    ProgramLight light;
    light.light = row->light;
    // A sphere has the intensity of a point in every direction, and programs treat it as one with a radius.
    Shape shown = shape;
    if (sphere && !policy_meaning(program, shape, Dimension::luminous_flux)) shown = PointShape{};
    if (sphere && row->kind == "point") light.note = "a point of the same flux";
    const Sizes sizes = sizes_of(shape);
    for (const FieldRow& field : row->fields) {
        if (field.what != What::amount) {
            const std::string unit(field.what == What::word ? std::string_view() : field.unit);
            light.fields.push_back({std::string(field.name), value_of(field, sizes), unit});
            continue;
        }
        std::string note;
        Result<ProgramField> amount = amount_field(field, program, shown, emission, note);
        if (!amount) return pass_on(amount);
        light.fields.push_back(std::move(*amount));
        if (!note.empty()) light.note += (light.note.empty() ? "" : "; ") + note;
    }
    return light;
}

} // namespace gonio
