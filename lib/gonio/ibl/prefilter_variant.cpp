#include <gonio/base/named.hpp>
#include <gonio/ibl/prefilter_variant.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

constexpr std::string_view mirrored = "R, the view direction mirrored at the normal N";

constexpr std::array variants{
    PrefilterVariant{"linear", "levels of equal steps of roughness, five down from 256 texels; for any program",
                     RoughnessMapping::linear, SplitSumModel::ggx, MultipleScattering::kulla_conty, 256, 5, mirrored},
    PrefilterVariant{"filament", "Filament: what cmgen writes", RoughnessMapping::filament, SplitSumModel::ggx,
                     MultipleScattering::filament, 256, 5,
                     "lerp(R, N, alpha^2), R the view direction mirrored at the normal N"},
    PrefilterVariant{"frostbite", "Frostbite: square-root steps, and the diffuse part in the table",
                     RoughnessMapping::frostbite, SplitSumModel::frostbite, MultipleScattering::none, 256, 7,
                     "lerp(N, R, s (sqrt(s) + alpha)), s = 1 - alpha, R the view direction mirrored at the normal N"},
    PrefilterVariant{"ue4", "Unreal Engine 4: reflection captures, down to one texel", RoughnessMapping::ue4,
                     SplitSumModel::ue4, MultipleScattering::none, 128, 0, mirrored},
};

} // namespace

std::span<const PrefilterVariant> prefilter_variants() {
    return variants;
}

Result<const PrefilterVariant*> parse_prefilter_variant(std::string_view text) {
    return find_named("prefilter", text, variants).map([](const auto* row) -> const PrefilterVariant* { return row; });
}

int levels_of(const PrefilterVariant& variant, int side, int least) {
    int levels = 1;
    for (; side % 2 == 0 && side / 2 >= least; side /= 2)
        ++levels;
    return variant.levels > 0 ? std::min(variant.levels, levels) : levels;
}

} // namespace gonio
