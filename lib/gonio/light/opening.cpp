#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/shape_keys.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

namespace {

// A size of an opening: a key of the grammar and its factor, 2 for a radius.
struct SizeKey {
    std::string_view key; // empty: the opening does not extend along this axis
    double factor = 1.0;
};

struct OpeningKind {
    std::string_view name;
    OpeningShape shape;
    std::array<SizeKey, 3> sizes; // along X, Y, Z
};

constexpr SizeKey radius{"r", 2.0};

constexpr std::array kinds{
    OpeningKind{"rect", OpeningShape::rectangle, {{{"w"}, {"h"}, {}}}},
    OpeningKind{"box", OpeningShape::box, {{{"w"}, {"h"}, {"d"}}}},
    OpeningKind{"disk", OpeningShape::disk, {{radius, radius, {}}}},
    OpeningKind{"ellipse", OpeningShape::ellipse, {{{"w"}, {"h"}, {}}}},
    OpeningKind{"cylinder", OpeningShape::vertical_cylinder, {{radius, radius, {"l"}}}},
    OpeningKind{"tube", OpeningShape::horizontal_cylinder, {{{"l"}, radius, radius}}},
    OpeningKind{"sphere", OpeningShape::sphere, {{radius, radius, radius}}},
    OpeningKind{"point", OpeningShape::point, {}},
};

} // namespace

double Opening::largest_m() const {
    return std::max({size_m.x, size_m.y, size_m.z});
}

Opening opening_of(const Profile& profile) {
    const LuminousOpening declared = luminous_opening(profile);
    Opening opening;
    opening.shape = declared.shape;
    const auto* const ldt = std::get_if<LdtFile>(&profile.file);
    opening.size_m = ldt != nullptr ? glm::dvec3(declared.width_m, declared.length_m, declared.height_m)
                                    : glm::dvec3(declared.length_m, declared.width_m, declared.height_m);
    if (opening.shape == OpeningShape::rectangle) opening.size_m.z = 0.0;
    opening.side_heights_m.fill(opening.size_m.z);
    if (ldt != nullptr)
        opening.side_heights_m = {1e-3 * ldt->luminous_height_c0_mm, 1e-3 * ldt->luminous_height_c90_mm,
                                  1e-3 * ldt->luminous_height_c180_mm, 1e-3 * ldt->luminous_height_c270_mm};
    for (double& height_m : opening.side_heights_m)
        height_m = std::max(height_m, 0.0);
    if (!(opening.largest_m() > 0.0)) opening.shape = OpeningShape::point;
    if (opening.shape == OpeningShape::point) opening = {};
    return opening;
}

Result<Opening> parse_opening(std::string_view text) {
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    Result<const OpeningKind*> found = find_named("opening", parsed->kind, kinds);
    if (!found) return pass_on(found);
    const OpeningKind& kind = **found;
    std::vector<std::string_view> keys;
    for (const SizeKey& size : kind.sizes) {
        if (size.key.empty() || std::find(keys.begin(), keys.end(), size.key) != keys.end()) continue;
        keys.push_back(size.key);
        take_spellings(*parsed, size.key, size.key == "r" ? "radius" : size.key == "l" ? "length" : std::string_view());
    }
    if (Result<void> only = only_keys(*parsed, keys); !only) return pass_on(only);
    Opening opening;
    opening.shape = kind.shape;
    for (int axis = 0; axis < 3; ++axis) {
        const SizeKey& size = kind.sizes[static_cast<std::size_t>(axis)];
        if (size.key.empty()) continue;
        const Result<Meters> length = read_length(*parsed, size.key);
        if (!length) return Unexpected(length.error());
        opening.size_m[axis] = size.factor * length->value;
    }
    opening.side_heights_m.fill(opening.size_m.z);
    return opening;
}

std::string opening_kinds() {
    std::string names;
    for (const OpeningKind& kind : kinds)
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

std::string to_text(const Opening& opening) {
    std::string text = to_text(opening.shape);
    const char* before = ", ";
    for (int axis = 0; axis < 3; ++axis)
        if (opening.size_m[axis] > 0.0)
            text += fmt::format("{}{:.4g}", std::exchange(before, " × "), opening.size_m[axis]);
    return opening.shape == OpeningShape::point ? text : text + " m";
}

} // namespace gonio
