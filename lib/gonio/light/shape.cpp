#include <gonio/base/named.hpp>
#include <gonio/light/kept_profiles.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/light/shape_keys.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/resolve.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>

namespace gonio {

namespace {

constexpr std::array falloff_names{
    FalloffName{"frostbite", Falloff::frostbite, "the square of linear-cos: Frostbite, glTF, Filament, Unity, Unreal"},
    FalloffName{"hard", Falloff::hard, "1 up to the outer angle"},
    FalloffName{"linear-cos", Falloff::linear_cos, "linear in the cosine: Godot with an attenuation of 1"},
    FalloffName{"smoothstep-cos", Falloff::smoothstep_cos, "smoothstep of the cosine: pbrt, three.js"},
    FalloffName{"linear-angle", Falloff::linear_angle, "linear in the angle: Mitsuba"},
    FalloffName{"smoothstep-angle", Falloff::smoothstep_angle, "smoothstep of the angle: UsdLux"},
};

// A key as `gonio list shapes` shows it: "r=LENGTH", "[,two-sided]".
template<class Kind>
std::string grammar_of(const LengthKey<Kind>& key) {
    return fmt::format("{}=LENGTH", key.key);
}
template<class Kind>
std::string grammar_of(const AngleKey<Kind>& key) {
    return fmt::format("{}=ANGLE", key.key);
}
template<class Kind>
std::string grammar_of(const FlagKey<Kind>& key) {
    return fmt::format("[,{}]", key.key);
}

template<class Kind>
std::string grammar_of(ShapeTraits<Kind> traits) {
    using Traits = ShapeTraits<Kind>;
    if constexpr (requires { Traits::grammar; }) {
        return std::string(Traits::grammar);
    } else {
        std::string text(Traits::kind);
        char before = ':';
        for_each_key(traits, [&](const auto& key) {
            const std::string of_key = grammar_of(key);
            if (of_key.front() != '[') text += std::exchange(before, ',');
            text += of_key;
        });
        if (MaskedShape<Kind>) text += before == ':' ? "[:mask=FILE]" : "[,mask=FILE]";
        return text;
    }
}

// "sphere:3cm" does not say whether that is the radius.
Result<void> no_bare_length(const KindText& text) {
    for (const KindText::Entry& entry : text.entries)
        if (!entry.value && entry.key.find_first_of("0123456789.") == 0 &&
            parse_amount(entry.key, Dimension::length, "length"))
            return fail("USE0104", fmt::format("'{}:{}' does not say which length this is", text.kind, entry.key),
                        "write r=LENGTH for a radius, d=LENGTH for a diameter, w= and h=, or l=");
    return {};
}

template<class Kind>
Result<Shape> parse_as(ShapeTraits<Kind> traits, KindText& text) {
    using Traits = ShapeTraits<Kind>;
    if constexpr (requires { Traits::parse(text); }) {
        Result<Kind> made = Traits::parse(text);
        if (!made) return pass_on(made);
        return Shape(std::move(*made));
    } else {
        static constexpr auto known = std::apply(
            [](const auto&... key) {
                if constexpr (MaskedShape<Kind>)
                    return std::array{key.key..., std::string_view("mask")};
                else
                    return std::array{key.key...};
            },
            Traits::keys);
        for_each_key(traits, [&](const auto& key) {
            if constexpr (std::is_same_v<std::decay_t<decltype(key)>, LengthKey<Kind>>)
                take_spellings(text, key.key, key.parameter);
        });
        if constexpr (std::is_same_v<Kind, RectShape>) take_diagonal(text);
        if (Result<void> clear = no_bare_length(text); !clear) return pass_on(clear);
        Result<void> read = only_keys(text, known);
        Kind made;
        for_each_key(traits, [&](const auto& key) {
            if (read) read = read_key(text, key, made);
        });
        if constexpr (MaskedShape<Kind>)
            if (read) read = read_mask(text, made.mask_file);
        if (!read) return pass_on(read);
        return Shape(std::move(made));
    }
}

// A file name may hold anything, so it is not cut at other commas than that before the opening.
Result<Shape> parse_profile_shape(std::string_view text) {
    constexpr std::string_view key = ",opening";
    ProfileShape shape;
    const std::size_t comma = text.rfind(key);
    const std::string_view rest =
        comma == std::string_view::npos ? std::string_view() : text.substr(comma + key.size());
    if (comma != std::string_view::npos && (rest.empty() || rest.front() == '=')) {
        text = text.substr(0, comma);
        shape.size = ProfileSize::opening;
        if (!rest.empty()) {
            const std::string_view value = rest.substr(1);
            if (value == "off") {
                shape.size = ProfileSize::point;
            } else if (value != "on") {
                Result<Opening> opening = parse_opening(value);
                if (!opening) return pass_on(opening);
                shape.given = std::make_shared<const Opening>(*opening);
                if (opening->shape == OpeningShape::point) shape.size = ProfileSize::point;
            }
        }
    }
    if (text.empty()) return fail("USE0104", "'ies:' needs a file", "write ies:lamp.ies");
    shape.file = text;
    return Shape(std::move(shape));
}

Result<detail::LoadedWeb> read_web(const std::string& file) {
    Result<Profile> profile = read_profile_file(file);
    if (!profile) return pass_on(profile);
    Result<void> photometric = require_candela(
        *profile, "if its numbers are meant as candela, make a profile of that: gonio edit FILE --as-candela -o NEW");
    if (!photometric) return pass_on(photometric);
    Diagnostics diagnostics = std::move(profile->diagnostics);
    auto opening = std::make_shared<const Opening>(opening_of(*profile));
    Result<ResolvedWeb> resolved = resolve_web(std::move(*profile));
    if (!resolved) return pass_on(resolved);
    std::move(resolved->diagnostics.begin(), resolved->diagnostics.end(), std::back_inserter(diagnostics));
    return detail::LoadedWeb{std::make_shared<const Web>(std::move(resolved->web)), std::move(opening),
                             std::move(diagnostics)};
}

thread_local detail::KeptProfiles* kept_profiles = nullptr;

Result<detail::LoadedWeb> kept_or_read(const std::string& file) {
    if (kept_profiles == nullptr) return read_web(file);
    if (const auto known = kept_profiles->find(file); known != kept_profiles->end()) return known->second;
    Result<detail::LoadedWeb> read = read_web(file);
    if (read) kept_profiles->emplace(file, *read);
    return read;
}

// The file of a shape and where its web is stored; empty for shapes that read no file.
struct WebSlot {
    const std::string* file = nullptr;
    std::shared_ptr<const Web>* web = nullptr;
};

WebSlot web_slot(Shape& shape) {
    return std::visit(
        [](auto& kind) -> WebSlot {
            if constexpr (requires { kind.mask_file; })
                return {&kind.mask_file, &kind.mask};
            else if constexpr (requires { kind.web; })
                return {&kind.file, &kind.web};
            else
                return {};
        },
        shape);
}

// A plane before a light of 90° and more would be infinite, before one of 0° a point.
Result<void> check_projection(const SpotShape& spot) {
    const double outer_deg = to_degrees(spot.outer);
    constexpr double widest_deg = 89.0;
    if (outer_deg > 0.0 && outer_deg <= widest_deg) return {};
    return fail("USE0107",
                fmt::format("a spot with an outer angle of {:.4g}deg cannot project an image: it must be greater than "
                            "0deg and at most {}deg",
                            outer_deg, widest_deg));
}
template<class Kind>
Result<void> check_projection(const Kind& /*takes any image*/) {
    return {};
}

// Not a part of the template below: clang 14 does not compile all that a shared pointer made there needs.
Result<std::shared_ptr<const LightImage>> shared_image(const std::string& file, Diagnostics& diagnostics) {
    Result<LightImage> image = read_light_image(file, diagnostics);
    if (!image) return pass_on(image);
    return std::make_shared<const LightImage>(std::move(*image));
}

Result<void> load_image(Shape& shape, Diagnostics& diagnostics) {
    return with_traits(shape, [&]<class Kind>(Kind& kind, ShapeTraits<Kind>) -> Result<void> {
        if constexpr (requires { kind.image; }) {
            if (Result<void> checked = check_projection(kind); !checked) return checked;
            if (kind.image != nullptr) return {};
            Result<std::shared_ptr<const LightImage>> image = shared_image(kind.mask_file, diagnostics);
            if (!image) return pass_on(image);
            kind.image = std::move(*image);
            return {};
        } else {
            return fail("USE0107", fmt::format("a {} does not take an image as a mask", ShapeTraits<Kind>::kind),
                        "spot and frustum project an image, rect shows one; others take a profile, mask=lamp.ies");
        }
    });
}

} // namespace

std::span<const FalloffName> falloffs() {
    return falloff_names;
}

const char* to_text(Falloff falloff) {
    for (const FalloffName& name : falloff_names)
        if (name.falloff == falloff) return name.name.data();
    return "";
}

Result<Falloff> parse_falloff(std::string_view name) {
    return find_named("falloff", name, falloff_names).map([](const FalloffName* known) { return known->falloff; });
}

std::span<const ShapeKind> shape_kinds() {
    static const auto grammars = [] {
        std::array<std::string, std::variant_size_v<Shape>> texts;
        std::size_t i = 0;
        for_each_kind([&](auto kind) { texts[i++] = grammar_of(kind); });
        return texts;
    }();
    static const auto kinds = [] {
        std::array<ShapeKind, std::variant_size_v<Shape>> made;
        std::size_t i = 0;
        for_each_kind([&](auto kind) {
            made[i] = {decltype(kind)::kind, grammars[i], decltype(kind)::summary};
            ++i;
        });
        return made;
    }();
    return kinds;
}

Result<Shape> parse_shape(std::string_view text) {
    if (text.starts_with("ies:")) return parse_profile_shape(text.substr(4));
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    std::optional<Result<Shape>> made;
    for_each_kind([&](auto traits) {
        if (parsed->kind == decltype(traits)::kind) made = parse_as(traits, *parsed);
    });
    if (made) return *std::move(made);
    std::vector<std::string_view> names;
    for_each_kind([&](auto traits) { names.push_back(decltype(traits)::kind); });
    return unknown_name("shape", parsed->kind, names);
}

Result<void> load_profile(Shape& shape, Diagnostics& diagnostics) {
    const WebSlot slot = web_slot(shape);
    if (slot.web == nullptr || slot.file->empty() || *slot.web) return {};
    if (!std::holds_alternative<ProfileShape>(shape) && names_image(*slot.file)) return load_image(shape, diagnostics);
    Result<detail::LoadedWeb> read = kept_or_read(*slot.file);
    if (!read) return pass_on(read);
    std::move(read->diagnostics.begin(), read->diagnostics.end(), std::back_inserter(diagnostics));
    *slot.web = std::move(read->web);
    if (auto* const profile = std::get_if<ProfileShape>(&shape)) profile->declared = std::move(read->opening);
    return {};
}

detail::KeepingProfiles::KeepingProfiles(KeptProfiles& kept) : before_(std::exchange(kept_profiles, &kept)) {}

detail::KeepingProfiles::~KeepingProfiles() {
    kept_profiles = before_;
}

Mask mask_of(const Shape& shape) {
    return std::visit(
        [](const auto& kind) -> Mask {
            Mask mask;
            if constexpr (requires { kind.mask_file; })
                mask = {kind.mask_file.empty() ? nullptr : &kind.mask_file, kind.mask.get()};
            if constexpr (requires { kind.image; }) mask.image = kind.image.get();
            return mask;
        },
        shape);
}

const void* pattern_of(const Shape& shape) {
    if (const auto* const profile = std::get_if<ProfileShape>(&shape)) return profile->web.get();
    const Mask mask = mask_of(shape);
    return mask.image != nullptr ? static_cast<const void*>(mask.image) : mask.web;
}

const std::string* file_of(const Shape& shape) {
    const auto* const profile = std::get_if<ProfileShape>(&shape);
    return profile != nullptr ? &profile->file : mask_of(shape).file;
}

const char* kind_of(const Shape& shape) {
    return with_traits(shape, [](const auto&, auto traits) { return decltype(traits)::kind.data(); });
}

ShapeClass class_of(const Shape& shape) {
    return with_traits(shape, [](const auto&, auto traits) { return decltype(traits)::shape_class; });
}

bool is_flat(const Shape& shape) {
    return std::visit(
        [](const auto& kind) {
            return requires {
                kind.two_sided;
            };
        },
        shape);
}

std::vector<ShapeValue> values_of(const Shape& shape) {
    std::vector<ShapeValue> values;
    with_traits(shape, [&](const auto& kind, auto traits) {
        for_each_key(traits, [&](const auto& key) { values.push_back({key.key, kind.*key.member}); });
    });
    return values;
}

Result<bool> set_shape_parameter(Shape& shape, std::string_view name, const std::string& value) {
    return with_traits(shape, [&]<class Kind>(Kind& kind, auto traits) -> Result<bool> {
        using Traits = decltype(traits);
        if constexpr (requires { Traits::set_parameter(kind, name, value); }) {
            return Traits::set_parameter(kind, name, value);
        } else {
            if (name == "size") return scale_lengths(kind, value);
            Result<bool> set = false;
            for_each_key(traits, [&](const auto& key) {
                if (!set || *set || !is_parameter(key, name)) return;
                Result<void> read = read_key({std::string(Traits::kind), {{std::string(key.key), value}}}, key, kind);
                set = read ? Result<bool>(true) : pass_on(read);
            });
            return set;
        }
    });
}

std::string kinds_with_parameter(std::string_view name) {
    std::string text;
    for_each_kind([&](auto traits) {
        bool has = false;
        for_each_key(traits, [&](const auto& key) { has |= is_parameter(key, name); });
        if (has) text += fmt::format("{}{}", text.empty() ? "" : ", ", decltype(traits)::kind);
    });
    return text;
}

} // namespace gonio
