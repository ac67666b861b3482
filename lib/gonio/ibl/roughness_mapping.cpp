#include <gonio/base/named.hpp>
#include <gonio/ibl/roughness_mapping.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gonio {

namespace {

constexpr std::array infos{
    RoughnessMappingInfo{"linear", RoughnessMapping::linear, "level = roughness * last"},
    RoughnessMappingInfo{"filament", RoughnessMapping::filament, "level = roughness * (2 - roughness) * last"},
    RoughnessMappingInfo{"frostbite", RoughnessMapping::frostbite, "level = sqrt(roughness) * last"},
    RoughnessMappingInfo{"ue4", RoughnessMapping::ue4, "level = last - 1 - (1 - 1.2 * log2(roughness))"},
};
static_assert(in_enum_order(infos, &RoughnessMappingInfo::mapping, RoughnessMapping::ue4));

} // namespace

std::span<const RoughnessMappingInfo> roughness_mappings() {
    return infos;
}

const RoughnessMappingInfo& info_of(RoughnessMapping mapping) {
    return infos.at(static_cast<std::size_t>(mapping));
}

Result<RoughnessMapping> parse_roughness_mapping(std::string_view text) {
    return find_named("roughness mapping", text, infos).map([](const auto* row) { return row->mapping; });
}

double level_of(RoughnessMapping mapping, double roughness, int last) {
    double level = 0.0;
    switch (mapping) {
    case RoughnessMapping::linear:
        level = roughness * last;
        break;
    case RoughnessMapping::filament:
        level = roughness * (2.0 - roughness) * last;
        break;
    case RoughnessMapping::frostbite:
        level = std::sqrt(roughness) * last;
        break;
    case RoughnessMapping::ue4:
        level = roughness > 0.0 ? last - 2.0 + 1.2 * std::log2(roughness) : 0.0;
        break;
    }
    return std::clamp(level, 0.0, static_cast<double>(last));
}

double roughness_of(RoughnessMapping mapping, double level, int last) {
    const double share = last > 0 ? level / last : 0.0;
    double roughness = 0.0;
    switch (mapping) {
    case RoughnessMapping::linear:
        roughness = share;
        break;
    case RoughnessMapping::filament:
        roughness = 1.0 - std::sqrt(std::max(0.0, 1.0 - share));
        break;
    case RoughnessMapping::frostbite:
        roughness = share * share;
        break;
    case RoughnessMapping::ue4:
        roughness = std::exp2((level - last + 2.0) / 1.2);
        break;
    }
    return std::clamp(roughness, 0.0, 1.0);
}

} // namespace gonio
