#include "lists.hpp"

#include <gonio/asset/target.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/bake/layout.hpp>
#include <gonio/bake/texture.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/named_methods.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/figures/road_plan.hpp>
#include <gonio/figures/road_surface.hpp>
#include <gonio/figures/tasks.hpp>
#include <gonio/ibl/prefilter_variant.hpp>
#include <gonio/interchange/scene_format.hpp>
#include <gonio/light/efficacy.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/light/presets.hpp>
#include <gonio/light/program_fields.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/preview/tone_map.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/parameter.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/spatial_illuminance.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/shader/shader.hpp>
#include <gonio/simd/dispatch.hpp>
#include <gonio/sky/sky_description.hpp>
#include <gonio/table/shading_table.hpp>

#include "bake/table_format.hpp"
#include "preview/layers.hpp"
#include "preview/picture_method.hpp"
#include "preview/sweep_axis.hpp"
#include "shader/request.hpp"

#ifndef GONIO_NO_BENCH
#include <gonio/measure/scaling.hpp>
#include <gonio/measure/suite.hpp>
#endif

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gonio::cli {

namespace {

using Entries = std::vector<ListEntry>;

Entries engines() {
    Entries entries;
    for (const Engine& engine : gonio::engines())
        entries.push_back({std::string(engine.name), std::string(engine.summary)});
    return entries;
}

Entries images() {
    Entries entries;
    for (const media::ImageFormat& format : media::image_formats())
        entries.push_back({std::string(format.name), std::string(format.title)});
    return entries;
}

Entries layouts() {
    Entries entries;
    for (const LayoutInfo& layout : gonio::layouts())
        entries.push_back({std::string(layout.name), std::string(layout.summary)});
    return entries;
}

Entries materials() {
    Entries entries;
    for (const MaterialKind& kind : material_kinds())
        entries.push_back({std::string(kind.grammar), std::string(kind.summary)});
    entries.push_back({"MATERIAL,coat=1,coat-smoothness=0.9,coat-order=physical",
                       "any of these below a clear coat; see: gonio list coats"});
    return entries;
}

Entries policies() {
    Entries entries;
    for (const Policy& policy : gonio::policies())
        entries.push_back({std::string(policy.name), fmt::format("{} ({})", policy.summary, policy.source)});
    return entries;
}

Entries shapes() {
    Entries entries;
    for (const ShapeKind& kind : shape_kinds())
        entries.push_back({std::string(kind.grammar), std::string(kind.summary)});
    return entries;
}

Entries skies() {
    Entries entries;
    for (const SkyKindInfo& kind : sky_kinds())
        entries.push_back({std::string(kind.grammar), std::string(kind.summary)});
    return entries;
}

Entries targets() {
    Entries entries;
    for (const Target& target : gonio::targets())
        entries.push_back({std::string(target.name), std::string(target.summary)});
    return entries;
}

// With GONIO_PAGE_COMMANDS, where nobody can ask for another, these are all.
constexpr NamedList engines_list{"engines", "targets of bake --engine", engines};
constexpr NamedList images_list{"images", "picture formats that gonio writes", images};
constexpr NamedList layouts_list{"layouts", "texture layouts of bake", layouts};
constexpr NamedList materials_list{"materials", "materials of preview and probe", materials};
constexpr NamedList policies_list{"policies", "how other programs read photometric numbers", policies};
constexpr NamedList shapes_list{"shapes", "shapes of lights", shapes};
constexpr NamedList skies_list{"skies", "skies of sky", skies};
constexpr NamedList targets_list{"targets", "programs that import writes for", targets};

#ifdef GONIO_PAGE_COMMANDS
constexpr std::array lists{engines_list,  images_list, layouts_list, materials_list,
                           policies_list, shapes_list, skies_list,   targets_list};
#else
Entries limits() {
    Entries entries;
    for (const Limit& limit : gonio::limits)
        entries.push_back({std::string(limit.name), fmt::format("{}: {}", amount_of(limit), limit.says)});
    return entries;
}

Entries falloffs() {
    Entries entries;
    for (const FalloffName& falloff : gonio::falloffs())
        entries.push_back({std::string(falloff.name), std::string(falloff.summary)});
    return entries;
}

Entries units() {
    Entries entries;
    for (const Unit& unit : all_units())
        entries.push_back(
            {std::string(unit.symbol), fmt::format("{} ({})", unit.name, dimension_name(unit.dimension))});
    return entries;
}

Entries sky_layouts() {
    Entries entries;
    for (const EnvironmentLayoutInfo& layout : environment_layouts())
        entries.push_back({std::string(layout.name), std::string(layout.summary)});
    return entries;
}

Entries cie_skies() {
    Entries entries;
    for (const CieSkyType& type : cie_sky_types())
        entries.push_back({std::string(type.name), std::string(type.summary)});
    return entries;
}

Entries weathers() {
    Entries entries;
    for (const WeatherRow& row : gonio::weathers())
        entries.push_back({std::string(row.name), std::string(row.summary)});
    return entries;
}

Entries stages() {
    Entries entries;
    for (const StageKind& kind : stage_kinds())
        entries.push_back({std::string(kind.name), std::string(kind.summary)});
    return entries;
}

Entries coats() {
    Entries entries;
    for (const CoatOrderName& order : coat_orders())
        entries.push_back({std::string(order.name), std::string(order.summary)});
    return entries;
}

Entries normalizations() {
    Entries entries;
    constexpr std::array says{"a texel of 1 is 1 cd", "a texel of 1 is the peak intensity",
                              "a texel of 1 is the mean intensity over the sphere", "candela per lumen"};
    for (std::size_t i = 0; i < normalization_names().size(); ++i)
        entries.push_back({std::string(normalization_names()[i]), says[i]});
    return entries;
}

Entries methods() {
    Entries entries;
    for (const IrradianceMethodName& method : irradiance_methods())
        entries.push_back({std::string(method.name), std::string(method.summary)});
    return entries;
}

Entries quantities() {
    Entries entries;
    for (const IlluminanceKindName& kind : illuminance_kinds())
        entries.push_back({std::string(kind.name), std::string(kind.summary)});
    return entries;
}

Entries road_arrangement_names() {
    Entries entries;
    for (const RoadArrangementName& known : road_arrangements())
        entries.push_back({std::string(known.name), std::string(known.summary)});
    return entries;
}

Entries road_surfaces() {
    Entries entries;
    for (const RoadSurface& surface : known_road_surfaces())
        entries.push_back(
            {surface.name, fmt::format("{} ({}), Q0 {}, S1 {}", surface.title, surface.rule,
                                       rounded(surface.average.value_or(0.0)), rounded(surface.specular_factor(), 3))});
    return entries;
}

Entries tasks() {
    Entries entries;
    for (const Task& task : known_tasks()) {
        std::string requirements;
        for (const Verdict& verdict : verdicts(task, {}))
            requirements += fmt::format(", {}{} {}{}{}", verdict.what, verdict.is_limit ? " at most" : "",
                                        rounded(verdict.required), verdict.unit.empty() ? "" : " ", verdict.unit);
        entries.push_back({task.name, fmt::format("{} ({}){}", task.title, task.rule, requirements)});
    }
    return entries;
}

Entries picture_method_names() {
    Entries entries;
    for (const PictureMethodInfo& method : cli::picture_methods())
        entries.push_back({std::string(method.name), method.summary});
    return entries;
}

Entries programs() {
    Entries entries;
    for (const Policy* const program : programs_with_fields())
        entries.push_back({std::string(program->name), std::string(program->source)});
    return entries;
}

Entries efficacies() {
    Entries entries;
    for (const NamedEfficacy& known : named_efficacies())
        entries.push_back({std::string(known.name), fmt::format("{} lm/W, {}", known.lm_per_w, known.says)});
    return entries;
}

Entries prefilters() {
    Entries entries;
    for (const PrefilterVariant& variant : prefilter_variants())
        entries.push_back({std::string(variant.name), std::string(variant.summary)});
    return entries;
}

Entries presets() {
    Entries entries;
    for (const LightPreset& preset : light_presets())
        entries.push_back({std::string(preset.name),
                           fmt::format("{} {}, {} ({})", preset.value, preset.shape, preset.says, preset.source)});
    return entries;
}

Entries spaces() {
    Entries entries;
    for (const RgbSpaceName& space : rgb_spaces())
        entries.push_back({std::string(space.name), space.alias.empty()
                                                        ? std::string(space.says)
                                                        : fmt::format("{} (also {})", space.says, space.alias)});
    return entries;
}

Entries illuminants() {
    Entries entries;
    for (const std::string_view name : illuminant_names()) {
        const std::optional<Spectrum> spectrum = find_illuminant(name);
        const Result<SpectrumColor> color = color_of(*spectrum);
        const Xy xy = to_xy(color->uv);
        entries.push_back({std::string(name), fmt::format("xy {:.4f} {:.4f}", xy.x, xy.y)});
    }
    return entries;
}

Entries loci() {
    Entries entries;
    for (const LocusName& locus : locus_names())
        entries.push_back({std::string(locus.name), std::string(locus.says)});
    return entries;
}

Entries tints() {
    Entries entries;
    for (const TintConvention& convention : tint_conventions())
        entries.push_back({std::string(convention.name), std::string(convention.says)});
    return entries;
}

Entries color_method_names() {
    Entries entries;
    for (const ColorMethod& method : color_methods())
        entries.push_back({std::string(method.name), std::string(method.source)});
    return entries;
}

Entries formats() {
    return {{"ies", "ANSI/IES LM-63, 1986 to 2019"},
            {"ldt", "EULUMDAT"},
            {"tm33", "ANSI/IES TM-33, ATLA S001: XML"},
            {"gldf", "GLDF: a luminaire with such profiles in it; written by convert"}};
}

Entries scenes() {
    Entries entries;
    for (const SceneFormat& format : scene_formats())
        entries.push_back({std::string(format.name), fmt::format("{} ({})", format.summary, format.endings)});
    return entries;
}

Entries dialects() {
    return {{"lm-63-1995", "IES as of 1995"},
            {"lm-63-2002", "IES as of 2002"},
            {"lm-63-2019", "IES as of 2019"},
            {"portable", "IES that every engine and renderer reads the same way"}};
}

Entries instruction_sets() {
    Entries entries;
    for (const simd::InstructionSet set : simd::available_sets())
        entries.push_back({simd::to_text(set), "runs on this machine"});
    return entries;
}

Entries diagrams() {
    Entries entries;
    for (const DiagramKind& kind : diagram_kinds())
        entries.push_back({std::string(kind.name), std::string(kind.summary)});
    return entries;
}

Entries looks() {
    Entries entries;
    for (const LookName& look : gonio::looks())
        entries.push_back({std::string(look.name), std::string(look.summary)});
    return entries;
}

Entries palettes() {
    Entries entries;
    for (const Palette& palette : gonio::palettes())
        entries.push_back({std::string(palette.name), std::string(palette.summary)});
    return entries;
}

Entries layers() {
    Entries entries;
    for (const LayerKind& kind : layer_kinds)
        entries.push_back({std::string(kind.name), std::string(kind.summary)});
    return entries;
}

Entries sweeps() {
    Entries entries;
    for (const ParameterName& parameter : light_parameters())
        entries.push_back({std::string(parameter.name), std::string(parameter.summary)});
    for (const ParameterName& parameter : material_parameters())
        entries.push_back({std::string(parameter.name), std::string(parameter.summary)});
    for (const ViewParameter& parameter : view_parameters)
        entries.push_back({std::string(parameter.name), std::string(parameter.summary)});
    return entries;
}

Entries tone_maps() {
    Entries entries;
    for (const ToneMapName& map : gonio::tone_maps())
        entries.push_back({std::string(map.name), std::string(map.summary)});
    return entries;
}

#ifndef GONIO_NO_BENCH
Entries scalings() {
    Entries entries;
    for (const measure::Scaling& scaling : measure::scalings())
        entries.push_back({std::string(scaling.name), std::string(scaling.summary)});
    return entries;
}

Entries suites() {
    Entries entries;
    for (const measure::Suite& suite : measure::suites())
        entries.push_back({std::string(suite.name), std::string(suite.summary)});
    return entries;
}
#endif

Entries shader_langs() {
    Entries entries;
    for (const ShaderLanguageName& language : shader_languages())
        entries.push_back({std::string(language.name), std::string(language.help)});
    return entries;
}

Entries shaders() {
    Entries entries;
    for (std::size_t i = 0; i < shader_formula_count(); ++i) {
        const ShaderFormulaInfo info = shader_formula(i);
        entries.push_back({shader_options_of(info.formula), fmt::format("{}: {}", info.function, info.title)});
    }
    return entries;
}

// Each value of one part of the formulas, with those of another part that go with it.
Entries shader_parts(std::string_view ShaderFormula::*part, std::string_view ShaderFormula::*with) {
    Entries entries;
    for (const std::string_view value : shader_values(part)) {
        std::vector<std::string_view> others;
        for (std::size_t i = 0; i < shader_formula_count(); ++i) {
            const ShaderFormula formula = shader_formula(i).formula;
            const std::string_view other = formula.*with;
            if (formula.*part == value && !other.empty() &&
                std::find(others.begin(), others.end(), other) == others.end())
                others.push_back(other);
        }
        entries.push_back({std::string(value), fmt::format("{}", fmt::join(others, ", "))});
    }
    return entries;
}

Entries shader_lights() {
    return shader_parts(&ShaderFormula::light, &ShaderFormula::method);
}
Entries shader_methods() {
    return shader_parts(&ShaderFormula::method, &ShaderFormula::light);
}
Entries shader_materials() {
    return shader_parts(&ShaderFormula::material, &ShaderFormula::what);
}

// Those of textures, and then those that only tables have.
Entries bake_formats() {
    Entries entries = images();
    for (const TableFormat& format : table_formats) {
        const auto is_same = [&](const ListEntry& entry) { return entry.name == format.name; };
        const auto same = std::find_if(entries.begin(), entries.end(), is_same);
        if (same != entries.end())
            same->says += ", also of tables";
        else
            entries.push_back({std::string(format.name), fmt::format("of tables: {}", format.title)});
    }
    return entries;
}

Entries table_axes() {
    return {{std::string(to_text(TableAxes::linear)), "u = n.v, v = roughness, texels in the middle of equal parts"},
            {std::string(to_text(TableAxes::root)), "u by the square root of n.v, the first and last texel on 0 and 1"},
            {std::string(to_text(TableAxes::heitz)),
             "u = roughness, v by the square root of 1 - n.v, the first and last texel on 0 and 1"}};
}

Entries table_forms() {
    return {{std::string(to_text(TableForm::bilinear)), "texels"},
            {std::string(to_text(TableForm::chebyshev)), "the coefficients of a polynomial"}};
}

Entries tables() {
    Entries entries;
    for (const TableInfo& table : table_infos()) {
        std::string axes;
        for (const TableAxes each : table.axes)
            axes += fmt::format("{}{}", axes.empty() ? "" : ", ", to_text(each));
        entries.push_back({std::string(table.name), fmt::format("{} (axes {})", table.summary, axes)});
    }
    return entries;
}

constexpr std::array lists{
    NamedList{"arrangements", "where the luminaires of road are", road_arrangement_names},
    NamedList{"bake-formats", "formats of textures and tables that bake writes", bake_formats},
    NamedList{"cie-skies", "general skies of the CIE", cie_skies},
    NamedList{"coats", "what a clear coat leaves of the material below", coats},
    NamedList{"color-methods", "formulas for the colour of a temperature", color_method_names},
    NamedList{"diagrams", "diagrams of plot", diagrams},
    NamedList{"dialects", "IES dialects that convert writes", dialects},
    NamedList{"efficacies", "conventions for lumens per watt", efficacies},
    engines_list,
    NamedList{"falloffs", "how spots fall off between inner and outer", falloffs},
    NamedList{"formats", "profile formats", formats},
    NamedList{"illuminants", "CIE illuminants", illuminants},
    images_list,
    NamedList{"layers", "what preview --aov writes", layers},
    layouts_list,
    NamedList{"limits", "greatest sizes, counts and depths", limits},
    NamedList{"loci", "curves of colour against temperature", loci},
    NamedList{"looks", "display modes of preview", looks},
    materials_list,
    NamedList{"methods", "how the light of a shape is computed", methods},
    NamedList{"normalizations", "meanings of a texel of 1", normalizations},
    NamedList{"palettes", "colours of false-colour pictures", palettes},
    NamedList{"picture-methods", "methods of preview: for shapes, and for sky and reflections", picture_method_names},
    policies_list,
    NamedList{"prefilters", "programs of sky prefilter --for", prefilters},
    NamedList{"presets", "everyday sources", presets},
    NamedList{"programs", "programs of units --for", programs},
    NamedList{"quantities", "illuminances of probe", quantities},
    NamedList{"road-surfaces", "r-tables of road surfaces", road_surfaces},
#ifndef GONIO_NO_BENCH
    NamedList{"scalings", "what bench --scaling measures", scalings},
#endif
    NamedList{"scene-formats", "scenes of other programs that lights reads", scenes},
    NamedList{"shader-langs", "languages of shader", shader_langs},
    NamedList{"shader-lights", "lights of shader, with their methods", shader_lights},
    NamedList{"shader-materials", "materials of shader, with what is computed", shader_materials},
    NamedList{"shader-methods", "methods of shader, with their lights", shader_methods},
    NamedList{"shaders", "functions that shader prints", shaders},
    shapes_list,
    NamedList{"simd", "instruction sets", instruction_sets},
    skies_list,
    NamedList{"sky-layouts", "layouts of environment images", sky_layouts},
    NamedList{"spaces", "linear colour spaces", spaces},
    NamedList{"stages", "stages of preview", stages},
#ifndef GONIO_NO_BENCH
    NamedList{"suites", "what bench measures", suites},
#endif
    NamedList{"sweeps", "parameters that preview --sweep changes", sweeps},
    NamedList{"table-axes", "where bake --table puts its texels", table_axes},
    NamedList{"table-forms", "how bake --table stores its numbers", table_forms},
    NamedList{"tables", "tables of bake --table", tables},
    targets_list,
    NamedList{"tasks", "what standards require of light", tasks},
    NamedList{"tints", "tint conventions of other programs", tints},
    NamedList{"tone-maps", "curves that replace the view of a display", tone_maps},
    NamedList{"units", "units of values", units},
    NamedList{"weathers", "weather of the sky daylight", weathers},
};
#endif

} // namespace

std::span<const NamedList> named_lists() {
    return lists;
}

const NamedList* find_list(std::string_view name) {
    for (const NamedList& list : lists)
        if (list.name == name) return &list;
    return nullptr;
}

} // namespace gonio::cli
