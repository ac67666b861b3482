// One key of a material's text.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/scene/material_description.hpp>

namespace gonio::detail {

// Reads into `target`, which does not change if the key is not given. Fail (usage) on a value that is not a number or
// colour in [0, 1].
Result<void> read_share(const KindText& text, std::string_view key, double& target);
Result<void> read_color(const KindText& text, std::string_view key, glm::dvec3& target);
// Reads `alpha`, or roughness, its root.
Result<void> read_alpha(const KindText& text, std::string_view key, double& target);

template<class M>
Result<void> read_material_key(const KindText& text, const ColorKey<M>& key, M& material) {
    return read_color(text, key.name, material.*key.member);
}
template<class M>
Result<void> read_material_key(const KindText& text, const NumberKey<M>& key, M& material) {
    double& target = material.*key.member;
    return key.form == KeyForm::alpha ? read_alpha(text, key.name, target) : read_share(text, key.name, target);
}

} // namespace gonio::detail
