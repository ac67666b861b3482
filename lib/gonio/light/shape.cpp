#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <utility>
#include <vector>

namespace gonio {

namespace {

constexpr std::array kinds{
    ShapeKind{"point", "point", "emits alike in every direction, without size"},
    ShapeKind{"sphere", "sphere:r=LENGTH", "a Lambertian sphere of radius r"},
    ShapeKind{"ies", "ies:FILE", "a measured luminaire: an IES or EULUMDAT profile"},
};

Result<Meters> positive_length(const KindText& text, std::string_view key) {
    const std::string* value = text.value(key);
    if (value == nullptr)
        return fail(Failure::usage, fmt::format("'{}' needs {}=LENGTH", text.kind, key),
                    fmt::format("write for example {}:{}=3cm", text.kind, key));
    const Result<double> meters = parse_amount(*value, Dimension::length, fmt::format("{} of '{}'", key, text.kind));
    if (!meters) return Unexpected(meters.error());
    if (!(*meters > 0.0))
        return fail(Failure::usage, fmt::format("{} of '{}' must be greater than 0, not {}", key, text.kind, *value));
    return Meters(*meters);
}

} // namespace

std::span<const ShapeKind> shape_kinds() {
    return kinds;
}

Result<Shape> parse_shape(std::string_view text) {
    // A file name may hold anything, so it is not cut at commas.
    if (text.starts_with("ies:")) {
        const std::string_view file = text.substr(4);
        if (file.empty()) return fail(Failure::usage, "'ies:' needs a file", "write ies:lamp.ies");
        return Shape(ProfileShape{std::string(file), nullptr});
    }
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    if (parsed->kind == "point") {
        if (Result<void> keys = only_keys(*parsed, {}); !keys) return pass_on(keys);
        return Shape(PointShape{});
    }
    if (parsed->kind == "sphere") {
        constexpr std::array<std::string_view, 1> keys{"r"};
        if (Result<void> known = only_keys(*parsed, keys); !known) return pass_on(known);
        Result<Meters> radius = positive_length(*parsed, "r");
        if (!radius) return pass_on(radius);
        return Shape(SphereShape{*radius});
    }
    if (parsed->kind == "ies") return fail(Failure::usage, "'ies' needs a file", "write ies:lamp.ies");
    std::vector<std::string_view> names;
    for (const ShapeKind& kind : kinds)
        names.push_back(kind.kind);
    return unknown_name("shape", parsed->kind, names);
}

Result<void> load_profile(Shape& shape, Diagnostics& diagnostics) {
    auto* const measured = std::get_if<ProfileShape>(&shape);
    if (measured == nullptr || measured->web) return {};
    Result<Profile> profile = read_profile_file(measured->file);
    if (!profile) return pass_on(profile);
    std::move(profile->diagnostics.begin(), profile->diagnostics.end(), std::back_inserter(diagnostics));
    Result<ResolvedWeb> resolved = resolve_web(*profile);
    if (!resolved) return pass_on(resolved);
    std::move(resolved->diagnostics.begin(), resolved->diagnostics.end(), std::back_inserter(diagnostics));
    measured->web = std::make_shared<const Web>(std::move(resolved->web));
    return {};
}

const char* kind_of(const Shape& shape) {
    struct Name {
        const char* operator()(const PointShape&) const { return "point"; }
        const char* operator()(const SphereShape&) const { return "sphere"; }
        const char* operator()(const ProfileShape&) const { return "ies"; }
    };
    return std::visit(Name{}, shape);
}

} // namespace gonio
