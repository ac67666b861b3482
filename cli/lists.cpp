#include "lists.hpp"

#include <gonio/bake/texture.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/simd/dispatch.hpp>

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

using Entries = std::vector<ListEntry>;

Entries layouts() {
    return {{"latlong", "columns C from 0° to 360°, rows gamma from 0° (nadir) to 180°"}};
}

Entries shapes() {
    Entries entries;
    for (const ShapeKind& kind : shape_kinds())
        entries.push_back({std::string(kind.grammar), std::string(kind.summary)});
    return entries;
}

Entries units() {
    Entries entries;
    for (const Unit& unit : all_units())
        entries.push_back(
            {std::string(unit.symbol), fmt::format("{} ({})", unit.name, dimension_name(unit.dimension))});
    return entries;
}

Entries stages() {
    Entries entries;
    for (const StageKind& kind : stage_kinds())
        entries.push_back({std::string(kind.name), std::string(kind.summary)});
    return entries;
}

Entries materials() {
    Entries entries;
    for (const MaterialKind& kind : material_kinds())
        entries.push_back({std::string(kind.grammar), std::string(kind.summary)});
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

Entries policies() {
    return {{"physical", "numbers mean the flux that is emitted"}};
}

Entries spaces() {
    return {{"rec709", "linear, D65 white: the working space"}};
}

Entries formats() {
    return {{"ies", "ANSI/IES LM-63, 1986 to 2019"}, {"ldt", "EULUMDAT"}};
}

Entries images() {
    Entries entries;
    for (const media::ImageFormat& format : media::image_formats())
        entries.push_back({std::string(format.name), std::string(format.title)});
    return entries;
}

Entries instruction_sets() {
    Entries entries;
    for (const simd::InstructionSet set : simd::available_sets())
        entries.push_back({simd::to_text(set), "runs on this machine"});
    return entries;
}

constexpr std::array lists{
    NamedList{"formats", "profile formats that are read", formats},
    NamedList{"images", "picture formats that are written", images},
    NamedList{"layouts", "texture layouts of bake", layouts},
    NamedList{"materials", "materials of preview", materials},
    NamedList{"methods", "ways to compute the illuminance of a light", methods},
    NamedList{"normalizations", "what a texel of 1 means", normalizations},
    NamedList{"policies", "whose meaning of photometric numbers", policies},
    NamedList{"shapes", "shapes of lights", shapes},
    NamedList{"simd", "instruction sets", instruction_sets},
    NamedList{"spaces", "colour spaces", spaces},
    NamedList{"stages", "stages of preview", stages},
    NamedList{"units", "units of values", units},
};

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
