#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/detail/read_material_key.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/material_description.hpp>

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

namespace {

Result<void> all_have_values(const KindText& text) {
    for (const KindText::Entry& entry : text.entries)
        if (!entry.value)
            return fail("USE0104", fmt::format("the key '{}' of '{}' needs a value", entry.key, text.kind));
    return {};
}

template<class M>
Result<Material> parse(const KindText& text) {
    std::vector<std::string_view> names;
    for_each_key<M>([&](const auto& key) {
        names.push_back(key.name);
        if (key.form == KeyForm::alpha) names.emplace_back("roughness");
    });
    Result<void> read = only_keys(text, names);
    M material;
    for_each_key<M>([&](const auto& key) {
        if (read) read = detail::read_material_key(text, key, material);
    });
    if (!read) return pass_on(read);
    return Material(material);
}

std::string number_text(double number) {
    return shortest(number);
}
std::string number_text(const glm::dvec3& grey) {
    return shortest(grey.x);
}

// "ue4:base=0.5,roughness=0.4": the grammar with the defaults.
template<class M>
std::string grammar() {
    std::string text;
    for_each_key<M>([&](const auto& key) {
        text += fmt::format("{}{}={}", text.empty() ? ':' : ',', key.name, number_text(M().*key.member));
    });
    return std::string(MaterialDescription<M>::kind) + text;
}

struct Kinds {
    std::vector<std::string> grammars;
    std::vector<MaterialKind> kinds;

    Kinds() {
        for_each_material([&]<class M>() { grammars.push_back(grammar<M>()); });
        for_each_material([&]<class M>() {
            kinds.push_back({MaterialDescription<M>::kind, grammars[kinds.size()], MaterialDescription<M>::summary});
        });
    }
};

} // namespace

std::span<const MaterialKind> material_kinds() {
    static const Kinds all;
    return all.kinds;
}

Result<Material> parse_material(std::string_view text) {
    Result<KindText> parsed = parse_kind_text(text);
    if (!parsed) return pass_on(parsed);
    if (Result<void> whole = all_have_values(*parsed); !whole) return pass_on(whole);
    std::optional<Result<Material>> material;
    std::vector<std::string_view> names;
    for_each_material([&]<class M>() {
        names.push_back(MaterialDescription<M>::kind);
        if (parsed->kind == names.back()) material = parse<M>(*parsed);
    });
    if (material) return *std::move(material);
    return unknown_name("material", parsed->kind, names);
}

} // namespace gonio
