// Reading the keys of a shape's grammar (gonio/light/shapes/description.hpp) from text.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/shapes/description.hpp>

#include <string>
#include <string_view>

namespace gonio {

// Lengths as people write them: the whole name of a key ("radius", "width", "height", "length"), and "d" or "diameter"
// where the key is the radius. Writes them as the key.
void take_spellings(KindText& text, std::string_view key, std::string_view name);

// A display's diagonal, alone ("rect:55in"): width and height at 16:9.
void take_diagonal(KindText& text);

Result<Meters> read_length(const KindText& text, std::string_view key);
Result<Radians> read_angle(const KindText& text, std::string_view key, std::string_view example,
                           const AngleRange& range);
// A key without a value: present or absent.
Result<bool> read_flag(const KindText& text, std::string_view key);
Result<Falloff> read_falloff(const KindText& text, std::string_view key);
Result<void> read_mask(const KindText& text, std::string& file);
Result<double> read_factor(std::string_view value); // of "size"

template<class Kind>
Result<void> read_key(const KindText& text, const LengthKey<Kind>& key, Kind& to) {
    return read_length(text, key.key).map([&](Meters length) { to.*key.member = length; });
}
template<class Kind>
Result<void> read_key(const KindText& text, const AngleKey<Kind>& key, Kind& to) {
    return read_angle(text, key.key, key.example, key.range).map([&](Radians angle) { to.*key.member = angle; });
}
template<class Kind>
Result<void> read_key(const KindText& text, const FlagKey<Kind>& key, Kind& to) {
    return read_flag(text, key.key).map([&](bool there) { to.*key.member = there; });
}
template<class Kind>
Result<void> read_key(const KindText& text, const FalloffKey<Kind>& key, Kind& to) {
    return read_falloff(text, key.key).map([&](Falloff falloff) { to.*key.member = falloff; });
}

template<class Key>
inline constexpr bool is_length = false;
template<class Kind>
inline constexpr bool is_length<LengthKey<Kind>> = true;

// Whether a sweep knows the key by that name; "size" means all lengths.
template<class Key>
bool is_parameter(const Key& key, std::string_view name) {
    if (is_length<Key> && name == "size") return true;
    if constexpr (requires { key.parameter; }) return key.parameter == name;
    return false;
}

// Multiplies all lengths by a factor; false for shapes without lengths.
template<class Kind>
Result<bool> scale_lengths(Kind& kind, std::string_view value) {
    return std::apply(
        [&](const auto&... key) -> Result<bool> {
            if constexpr ((is_length<std::decay_t<decltype(key)>> || ...)) {
                const Result<double> factor = read_factor(value);
                if (!factor) return Unexpected(factor.error());
                const auto scale = [&](const auto& of) {
                    if constexpr (is_length<std::decay_t<decltype(of)>>) (kind.*of.member).value *= *factor;
                };
                (scale(key), ...);
                return true;
            }
            return false;
        },
        ShapeTraits<Kind>::keys);
}

} // namespace gonio
