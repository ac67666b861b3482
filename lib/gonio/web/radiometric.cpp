#include <gonio/base/text.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/radiometric.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr std::string_view unit_keyword = "_INTENSITYUNITS";
constexpr std::string_view kind_keyword = "_RADIATIONTYPE";

bool is_candela(std::string_view unit) {
    constexpr std::array<std::string_view, 4> names{"cd", "candela", "candelas", "lm/sr"};
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return equals_any_case(unit, name); });
}

bool is_visible(std::string_view kind) {
    constexpr std::array<std::string_view, 3> names{"visible", "light", "white"};
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return equals_any_case(kind, name); });
}

} // namespace

std::string radiometric_unit(const Profile& profile) {
    const auto* const file = std::get_if<IesFile>(&profile.file);
    if (file == nullptr) return {};
    std::string unit;
    bool is_radiant = false;
    for (const IesKeyword& keyword : file->keywords) {
        const std::string_view text = trimmed(keyword.text);
        if (text.empty()) continue;
        if (same_keyword(keyword.name, unit_keyword)) {
            if (is_candela(text)) return {};
            if (unit.empty()) unit = text;
        } else if (same_keyword(keyword.name, kind_keyword)) {
            is_radiant = is_radiant || !is_visible(text);
        }
    }
    return unit.empty() && is_radiant ? "radiometric units" : unit;
}

Result<void> require_candela(const Profile& profile, std::string hint) {
    const std::string unit = radiometric_unit(profile);
    if (unit.empty()) return {};
    return fail("UNS0104", fmt::format("the intensities of this profile are in {}, not in candela", unit),
                std::move(hint), profile.source);
}

bool states_radiometric_unit(const IesKeyword& keyword) {
    return same_keyword(keyword.name, unit_keyword) || same_keyword(keyword.name, kind_keyword);
}

} // namespace gonio
