#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr std::array kinds{
    ShapeKind{"point", "point[:mask=FILE]", "emits alike in every direction, without size"},
    ShapeKind{"spot", "spot:outer=ANGLE[,inner=ANGLE][,falloff=NAME][,mask=FILE]",
              "a cone; half angles, or cone=ANGLE for the full one"},
    ShapeKind{"frustum", "frustum:h=ANGLE,v=ANGLE[,mask=FILE]", "a pyramid, even inside; full apex angles"},
    ShapeKind{"ies", "ies:FILE", "a measured luminaire: an IES or EULUMDAT profile"},
    ShapeKind{"sphere", "sphere:r=LENGTH[,mask=FILE]", "a Lambertian sphere of radius r"},
    ShapeKind{"disk", "disk:r=LENGTH[,two-sided][,mask=FILE]", "a Lambertian disk of radius r"},
    ShapeKind{"rect", "rect:w=LENGTH,h=LENGTH[,two-sided][,mask=FILE]",
              "a Lambertian rectangle, w along X and h along Y"},
    ShapeKind{"tube", "tube:r=LENGTH,l=LENGTH[,mask=FILE]", "a Lambertian capsule along X, l without its caps"},
    ShapeKind{"sun", "sun:angle=ANGLE", "an even disk of that angular diameter, at infinity"},
};

struct FalloffName {
    std::string_view name;
    Falloff falloff;
};

constexpr std::array falloffs{
    FalloffName{"frostbite", Falloff::frostbite},       FalloffName{"hard", Falloff::hard},
    FalloffName{"linear-cos", Falloff::linear_cos},     FalloffName{"smoothstep-cos", Falloff::smoothstep_cos},
    FalloffName{"linear-angle", Falloff::linear_angle}, FalloffName{"smoothstep-angle", Falloff::smoothstep_angle},
};

// The entry as written; fails when it is not there or bare. `example` is a value that would do.
Result<std::string> needed(const KindText& text, std::string_view key, const char* what, const char* example) {
    if (const std::string* value = text.value(key)) return *value;
    return fail(Failure::usage, fmt::format("'{}' needs {}={}", text.kind, key, what),
                fmt::format("write for example {}:{}={}", text.kind, key, example));
}

Result<Meters> positive_length(const KindText& text, std::string_view key) {
    Result<std::string> value = needed(text, key, "LENGTH", "3cm");
    if (!value) return pass_on(value);
    Result<double> meters = parse_amount(*value, Dimension::length, fmt::format("{} of '{}'", key, text.kind));
    if (!meters) return pass_on(meters);
    if (!(*meters > 0.0))
        return fail(Failure::usage, fmt::format("{} of '{}' must be greater than 0, not {}", key, text.kind, *value));
    return Meters(*meters);
}

// Which angles a key takes: from `least_deg` to `most_deg`, either with or without the bound itself.
struct AngleRange {
    double least_deg = 0.0;
    double most_deg = 0.0;
    bool takes_least = false;
    bool takes_most = true;
};

constexpr AngleRange half_angles{0.0, 90.0, true, true};
constexpr AngleRange full_angles{0.0, 180.0, true, true};
constexpr AngleRange apex_angles{0.0, 180.0, false, false};
constexpr AngleRange diameters{0.0, 180.0, false, true};

// What text in degrees rounds to above the greatest angle is the greatest.
Result<Radians> angle(const KindText& text, std::string_view key, const char* example, const AngleRange& range) {
    Result<std::string> value = needed(text, key, "ANGLE", example);
    if (!value) return pass_on(value);
    Result<double> angle = parse_amount(*value, Dimension::angle, fmt::format("{} of '{}'", key, text.kind));
    if (!angle) return pass_on(angle);
    const double least = range.least_deg / 180.0 * pi;
    const double most = range.most_deg / 180.0 * pi;
    if (*angle > most && *angle < most * (1.0 + 1e-15)) *angle = most;
    const bool fits =
        (range.takes_least ? *angle >= least : *angle > least) && (range.takes_most ? *angle <= most : *angle < most);
    if (!fits)
        return fail(Failure::usage, fmt::format("{} of '{}' must be {} {}deg and {} {}deg, not {}", key, text.kind,
                                                range.takes_least ? "at least" : "greater than", range.least_deg,
                                                range.takes_most ? "at most" : "less than", range.most_deg, *value));
    return Radians(*angle);
}

// A bare key: there or not.
Result<bool> flag(const KindText& text, std::string_view key) {
    const auto entry = std::find_if(text.entries.begin(), text.entries.end(),
                                    [&](const KindText::Entry& candidate) { return candidate.key == key; });
    if (entry == text.entries.end()) return false;
    if (entry->value)
        return fail(Failure::usage, fmt::format("'{}' of '{}' takes no value", key, text.kind),
                    fmt::format("write {} alone", key));
    return true;
}

Result<std::string> mask_file(const KindText& text) {
    const auto entry = std::find_if(text.entries.begin(), text.entries.end(),
                                    [](const KindText::Entry& candidate) { return candidate.key == "mask"; });
    if (entry == text.entries.end()) return std::string();
    if (!entry->value || entry->value->empty())
        return fail(Failure::usage, fmt::format("mask of '{}' needs a file", text.kind), "write mask=lamp.ies");
    return *entry->value;
}

template<std::size_t N>
Result<void> keys(const KindText& text, const std::array<std::string_view, N>& known) {
    return only_keys(text, known);
}

Result<Shape> point(const KindText& text) {
    if (Result<void> known = keys<1>(text, {"mask"}); !known) return pass_on(known);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(PointShape{*mask, nullptr});
}

Result<Falloff> falloff_of(const KindText& text) {
    const auto entry = std::find_if(text.entries.begin(), text.entries.end(),
                                    [](const KindText::Entry& candidate) { return candidate.key == "falloff"; });
    if (entry == text.entries.end()) return Falloff::frostbite;
    const std::string name = entry->value.value_or("");
    return find_named("falloff", name, falloffs).map([](const FalloffName* known) { return known->falloff; });
}

Result<Shape> spot(const KindText& text) {
    if (Result<void> known = keys<5>(text, {"outer", "cone", "inner", "falloff", "mask"}); !known)
        return pass_on(known);
    const bool by_cone = text.value("cone") != nullptr;
    if (by_cone && text.value("outer") != nullptr)
        return fail(Failure::usage, "'spot' takes outer or cone, not both",
                    "outer is the half angle, cone the full one");
    SpotShape made;
    Result<Radians> outer =
        by_cone ? angle(text, "cone", "80deg", full_angles) : angle(text, "outer", "40deg", half_angles);
    if (!outer) return pass_on(outer);
    made.outer = by_cone ? *outer / 2.0 : *outer;
    if (const std::string* inner_text = text.value("inner")) {
        Result<double> inner = parse_amount(*inner_text, Dimension::angle, "inner of 'spot'");
        if (!inner) return pass_on(inner);
        made.inner = Radians(*inner);
        if (!(*inner >= 0.0))
            return fail(Failure::usage, fmt::format("inner of 'spot' must be at least 0deg, not {}", *inner_text));
        if (*inner > made.outer.value)
            return fail(Failure::usage,
                        fmt::format("inner of 'spot' must be at most its outer half angle of {}deg, not {}",
                                    rounded(to_degrees(made.outer)), *inner_text),
                        "inner is a half angle too");
    } else if (Result<bool> bare = flag(text, "inner"); bare && *bare) {
        return fail(Failure::usage, "'spot' needs a value for inner", "write for example inner=25deg");
    }
    Result<Falloff> falloff = falloff_of(text);
    if (!falloff) return pass_on(falloff);
    made.falloff = *falloff;
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    made.mask_file = *mask;
    return Shape(std::move(made));
}

Result<Shape> frustum(const KindText& text) {
    if (Result<void> known = keys<3>(text, {"h", "v", "mask"}); !known) return pass_on(known);
    Result<Radians> h = angle(text, "h", "60deg,v=40deg", apex_angles);
    if (!h) return pass_on(h);
    Result<Radians> v = angle(text, "v", "40deg,h=60deg", apex_angles);
    if (!v) return pass_on(v);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(FrustumShape{*h, *v, *mask, nullptr});
}

Result<Shape> sphere(const KindText& text) {
    if (Result<void> known = keys<2>(text, {"r", "mask"}); !known) return pass_on(known);
    Result<Meters> r = positive_length(text, "r");
    if (!r) return pass_on(r);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(SphereShape{*r, *mask});
}

Result<Shape> disk(const KindText& text) {
    if (Result<void> known = keys<3>(text, {"r", "two-sided", "mask"}); !known) return pass_on(known);
    Result<Meters> r = positive_length(text, "r");
    if (!r) return pass_on(r);
    Result<bool> two_sided = flag(text, "two-sided");
    if (!two_sided) return pass_on(two_sided);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(DiskShape{*r, *two_sided, *mask});
}

Result<Shape> rect(const KindText& text) {
    if (Result<void> known = keys<4>(text, {"w", "h", "two-sided", "mask"}); !known) return pass_on(known);
    Result<Meters> w = positive_length(text, "w");
    if (!w) return pass_on(w);
    Result<Meters> h = positive_length(text, "h");
    if (!h) return pass_on(h);
    Result<bool> two_sided = flag(text, "two-sided");
    if (!two_sided) return pass_on(two_sided);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(RectShape{*w, *h, *two_sided, *mask});
}

Result<Shape> tube(const KindText& text) {
    if (Result<void> known = keys<3>(text, {"r", "l", "mask"}); !known) return pass_on(known);
    Result<Meters> r = positive_length(text, "r");
    if (!r) return pass_on(r);
    Result<Meters> l = positive_length(text, "l");
    if (!l) return pass_on(l);
    Result<std::string> mask = mask_file(text);
    if (!mask) return pass_on(mask);
    return Shape(TubeShape{*r, *l, *mask});
}

Result<Shape> sun(const KindText& text) {
    if (Result<void> known = keys<1>(text, {"angle"}); !known) return pass_on(known);
    Result<Radians> diameter = angle(text, "angle", "0.53deg", diameters);
    if (!diameter) return pass_on(diameter);
    return Shape(SunShape{*diameter});
}

Result<std::shared_ptr<const Web>> read_web(const std::string& file, Diagnostics& diagnostics) {
    Result<Profile> profile = read_profile_file(file);
    if (!profile) return pass_on(profile);
    std::move(profile->diagnostics.begin(), profile->diagnostics.end(), std::back_inserter(diagnostics));
    Result<ResolvedWeb> resolved = resolve_web(std::move(*profile));
    if (!resolved) return pass_on(resolved);
    std::move(resolved->diagnostics.begin(), resolved->diagnostics.end(), std::back_inserter(diagnostics));
    return std::make_shared<const Web>(std::move(resolved->web));
}

// The file of a shape and where its web goes; nothing for shapes that read none.
struct WebSlot {
    const std::string* file = nullptr;
    std::shared_ptr<const Web>* web = nullptr;
};

WebSlot web_slot(Shape& shape) {
    struct Slot {
        WebSlot operator()(ProfileShape& measured) const { return {&measured.file, &measured.web}; }
        WebSlot operator()(PointShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(SpotShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(FrustumShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(SphereShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(DiskShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(RectShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(TubeShape& masked) const { return {&masked.mask_file, &masked.mask}; }
        WebSlot operator()(SunShape&) const { return {}; }
    };
    return std::visit(Slot{}, shape);
}

} // namespace

const char* to_text(Falloff falloff) {
    for (const FalloffName& name : falloffs)
        if (name.falloff == falloff) return name.name.data();
    return "";
}

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
    if (parsed->kind == "point") return point(*parsed);
    if (parsed->kind == "spot") return spot(*parsed);
    if (parsed->kind == "frustum") return frustum(*parsed);
    if (parsed->kind == "sphere") return sphere(*parsed);
    if (parsed->kind == "disk") return disk(*parsed);
    if (parsed->kind == "rect") return rect(*parsed);
    if (parsed->kind == "tube") return tube(*parsed);
    if (parsed->kind == "sun") return sun(*parsed);
    if (parsed->kind == "ies") return fail(Failure::usage, "'ies' needs a file", "write ies:lamp.ies");
    std::vector<std::string_view> names;
    names.reserve(kinds.size());
    for (const ShapeKind& kind : kinds)
        names.push_back(kind.kind);
    return unknown_name("shape", parsed->kind, names);
}

Result<void> load_profile(Shape& shape, Diagnostics& diagnostics) {
    const WebSlot slot = web_slot(shape);
    if (slot.web == nullptr || slot.file->empty() || *slot.web) return {};
    Result<std::shared_ptr<const Web>> web = read_web(*slot.file, diagnostics);
    if (!web) return pass_on(web);
    *slot.web = std::move(*web);
    return {};
}

Mask mask_of(const Shape& shape) {
    struct Slot {
        Mask operator()(const PointShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const SpotShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const FrustumShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const ProfileShape&) const { return {}; }
        Mask operator()(const SphereShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const DiskShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const RectShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const TubeShape& masked) const { return {&masked.mask_file, masked.mask.get()}; }
        Mask operator()(const SunShape&) const { return {}; }
    };
    Mask mask = std::visit(Slot{}, shape);
    if (mask.file != nullptr && mask.file->empty()) mask.file = nullptr;
    return mask;
}

const char* kind_of(const Shape& shape) {
    struct Name {
        const char* operator()(const PointShape&) const { return "point"; }
        const char* operator()(const SpotShape&) const { return "spot"; }
        const char* operator()(const FrustumShape&) const { return "frustum"; }
        const char* operator()(const ProfileShape&) const { return "ies"; }
        const char* operator()(const SphereShape&) const { return "sphere"; }
        const char* operator()(const DiskShape&) const { return "disk"; }
        const char* operator()(const RectShape&) const { return "rect"; }
        const char* operator()(const TubeShape&) const { return "tube"; }
        const char* operator()(const SunShape&) const { return "sun"; }
    };
    return std::visit(Name{}, shape);
}

} // namespace gonio
