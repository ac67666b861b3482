// One key of a material's text.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/scene/material_description.hpp>

#include <array>
#include <optional>
#include <string_view>

namespace gonio::detail {

// The keys of a coat; the others need the first.
inline constexpr std::array<std::string_view, 3> coat_keys{"coat", "coat-smoothness", "coat-order"};

// Reads the keys of a coat that are given; `coat` remains empty without any. Fails (usage) also if the coat to which a
// key belongs is neither given nor in `coat`.
Result<void> read_coat(const KindText& text, std::optional<Coat>& coat);

// Reads into `target`, which does not change if the key is not given. Fail (usage) on a value that is not a number or
// colour in [0, 1].
Result<void> read_share(const KindText& text, std::string_view key, double& target);
Result<void> read_color(const KindText& text, std::string_view key, glm::dvec3& target);
// An angle in degrees, or with its unit; a whole turn at most, either way.
Result<void> read_degrees(const KindText& text, std::string_view key, double& target);
// Reads `alpha`, or roughness, its root.
Result<void> read_alpha(const KindText& text, std::string_view key, double& target);

template<class M>
Result<void> read_material_key(const KindText& text, const ColorKey<M>& key, M& material) {
    return read_color(text, key.name, material.*key.member);
}
template<class M>
Result<void> read_material_key(const KindText& text, const NumberKey<M>& key, M& material) {
    double& target = material.*key.member;
    if (key.form == KeyForm::degrees) return read_degrees(text, key.name, target);
    return key.form == KeyForm::alpha ? read_alpha(text, key.name, target) : read_share(text, key.name, target);
}

} // namespace gonio::detail
