#include <gonio/bake/bake_choice.hpp>
#include <gonio/bake/engine.hpp>
#include <gonio/base/named.hpp>

#include <array>

namespace gonio {

namespace {

constexpr std::array texel_types{Named{"float32", TexelType::float32}, Named{"half", TexelType::half},
                                 Named{"uint16", TexelType::uint16}, Named{"uint8", TexelType::uint8}};

Result<BakeOptions> usual_options(const BakeChoice& choice) {
    if (choice.engine) {
        if (choice.layout) return fail("USE0107", "layout and engine are both given", "an engine sets the layout");
        return find_engine(*choice.engine).map([](const Engine* engine) { return engine->bake; });
    }
    const Result<Layout> layout = parse_layout(choice.layout.value_or("latlong"));
    if (!layout) return Unexpected(layout.error());
    const TextureSize usual = usual_size(*layout);
    BakeOptions options;
    options.layout = *layout;
    options.width = usual.width;
    options.height = usual.height;
    return options;
}

} // namespace

Result<BakeOptions> bake_options(const BakeChoice& choice) {
    Result<BakeOptions> options = usual_options(choice);
    if (!options) return options;
    options->width = choice.width.value_or(options->width);
    options->height = choice.height.value_or(options->height);
    if (choice.normalization) {
        const Result<Normalization> normalization = parse_normalization(*choice.normalization);
        if (!normalization) return Unexpected(normalization.error());
        options->normalization = *normalization;
    }
    if (options->transfer == Transfer::srgb && options->normalization != Normalization::peak)
        return fail("USE0107", "this engine's texture holds values from 0 to 1 only", "leave normalization out");
    if (choice.texel_type) {
        const Result<TexelType> type = find_value("texel type", *choice.texel_type, texel_types);
        if (!type) return Unexpected(type.error());
        options->texel_type = *type;
    }
    if (choice.cone_deg) options->chart.cone = degrees(*choice.cone_deg);
    if (choice.border) {
        if (*choice.border > 0 && options->layout != Layout::gnomonic)
            return fail("USE0107", "border is only for the layout gnomonic");
        options->chart.border = *choice.border;
    }
    return options;
}

} // namespace gonio
