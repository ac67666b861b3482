#include <gonio/base/kind_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/detail/read_material_key.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/material_description.hpp>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

namespace {

Result<void> all_have_values(const KindText& text) {
    for (const KindText::Entry& entry : text.entries)
        if (!entry.value)
            return fail("USE0104", fmt::format("the key '{}' of '{}' needs a value", entry.key, text.kind));
    return {};
}

constexpr std::array orders{
    CoatOrderName{CoatOrder::physical, "physical", "by what the whole coat reflects: keeps the energy of every base"},
    CoatOrderName{CoatOrder::ue4, "ue4", "(1 - F)^2 of one facet, of Unreal Engine 4: gains energy at grazing angles"},
    CoatOrderName{CoatOrder::filament, "filament", "1 - F of one facet, of Filament: gains energy at grazing angles"},
};

template<class M>
Result<Material> parse(const KindText& text) {
    std::vector<std::string_view> names;
    for_each_key<M>([&](const auto& key) {
        names.push_back(key.name);
        if (key.form == KeyForm::alpha) names.emplace_back("roughness");
    });
    names.insert(names.end(), detail::coat_keys.begin(), detail::coat_keys.end());
    Result<void> read = only_keys(text, names);
    M material;
    for_each_key<M>([&](const auto& key) {
        if (read) read = detail::read_material_key(text, key, material);
    });
    std::optional<Coat> coat;
    if (read) read = detail::read_coat(text, coat);
    if (!read) return pass_on(read);
    if (coat) return Material(CoatedMaterial{material, *coat});
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

BaseMaterial base_of(const Material& material) {
    return std::visit(
        []<class M>(const M& m) {
            if constexpr (std::is_same_v<M, CoatedMaterial>)
                return m.base;
            else
                return BaseMaterial(m);
        },
        material);
}

bool are_same(const Material& a, const Material& b) {
    const auto same_keys = []<class M>(const M& x, const M& y) {
        return std::apply([&](const auto&... key) { return (... && (x.*key.member == y.*key.member)); },
                          MaterialDescription<M>::keys);
    };
    const auto same_bases = [&](const auto& x, const auto& y) {
        return std::visit(
            [&]<class X, class Y>(const X& of_x, const Y& of_y) {
                if constexpr (std::is_same_v<X, Y>) {
                    return same_keys(of_x, of_y);
                } else {
                    return false;
                }
            },
            x, y);
    };
    const auto* const coated = std::get_if<CoatedMaterial>(&a);
    if (a.index() != b.index()) return false;
    if (coated != nullptr && coated->coat != std::get<CoatedMaterial>(b).coat) return false;
    return same_bases(base_of(a), base_of(b));
}

std::span<const CoatOrderName> coat_orders() {
    return orders;
}

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
