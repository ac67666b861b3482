#include <gonio/base/unit_text.hpp>
#include <gonio/scene/detail/read_material_key.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/parameter.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <variant>

namespace gonio {

namespace {

// The meaning of a parameter, the same for all materials that have it; their keys determine which materials have it.
struct NamedParameter {
    std::string_view name;
    std::string_view example;
    std::string_view meaning; // empty: the name is enough
};

constexpr std::array parameters{
    NamedParameter{"albedo", "0.5", ""},
    NamedParameter{"base", "0.5", "base colour"},
    NamedParameter{"f0", "0.9", ""},
    NamedParameter{"roughness", "0.4", ""},
    NamedParameter{"smoothness", "0.6", ""},
    NamedParameter{"alpha", "0.3", "the square of roughness"},
    NamedParameter{"metallic", "1", ""},
    NamedParameter{"reflectance", "0.5", ""},
    NamedParameter{"specular", "0.5", ""},
    NamedParameter{"cavity", "0.5", ""},
    NamedParameter{"wet", "0.5", ""},
    NamedParameter{"anisotropy", "0.5", "how much wider the lobe is along the tangent"},
    NamedParameter{"rotation", "30", "of the tangent, in degrees"},
};

template<class M>
constexpr bool all_named() {
    return std::apply(
        [](const auto&... key) {
            const auto is_named = [](std::string_view name) {
                for (const NamedParameter& parameter : parameters)
                    if (parameter.name == name) return true;
                return false;
            };
            return (is_named(key.parameter) && ...);
        },
        MaterialDescription<M>::keys);
}

// How a key matches the name of a parameter.
enum class Answer : std::uint8_t { none, itself, under_another_name, by_its_root, by_its_complement };

template<class Key>
Answer answer(const Key& key, std::string_view name) {
    if (key.parameter == name) return key.parameter == key.name ? Answer::itself : Answer::under_another_name;
    if (name != "roughness") return Answer::none;
    if (key.form == KeyForm::alpha) return Answer::by_its_root;
    return key.form == KeyForm::smoothness ? Answer::by_its_complement : Answer::none;
}

// "ue4; frostbite: metal": which materials have it, what it is, and which ones use another name.
std::string summary(const NamedParameter& parameter) {
    std::vector<std::string_view> own;
    std::map<std::string, std::vector<std::string_view>> others; // by its expression in their keys
    for_each_material([&]<class M>() {
        constexpr std::string_view kind = MaterialDescription<M>::kind;
        static_assert(all_named<M>(), "a parameter of the material lacks a line in `parameters`");
        for_each_key<M>([&](const auto& key) {
            switch (answer(key, parameter.name)) {
            case Answer::none:
                return;
            case Answer::itself:
            case Answer::by_its_root:
                own.push_back(kind);
                return;
            case Answer::under_another_name:
                others[std::string(key.name)].push_back(kind);
                return;
            case Answer::by_its_complement:
                others[fmt::format("1 - {}", key.name)].push_back(kind);
                return;
            }
        });
    });
    std::string text = fmt::format("{}", fmt::join(own, ", "));
    if (!parameter.meaning.empty()) text += fmt::format(": {}", parameter.meaning);
    for (const auto& [is, kinds] : others)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", fmt::join(kinds, " and "), is);
    return text;
}

constexpr std::array coat_parameters{
    ParameterName{"coat", "1", "any material: a clear coat over it"},
    ParameterName{"coat-smoothness", "0.9", "any material with a coat"},
    ParameterName{"coat-order", "ue4", "any material with a coat: what it leaves of the base"},
};
static_assert(coat_parameters.size() == detail::coat_keys.size());

struct Listed {
    std::array<std::string, parameters.size()> summaries;
    std::array<ParameterName, parameters.size() + coat_parameters.size()> names;

    Listed() {
        std::copy(coat_parameters.begin(), coat_parameters.end(), names.begin() + parameters.size());
        for (std::size_t i = 0; i < parameters.size(); ++i) {
            summaries[i] = summary(parameters[i]);
            names[i] = {parameters[i].name, parameters[i].example, summaries[i]};
        }
    }
};

// False if the material has no coat that the name could change.
Result<bool> set_coat(Material& material, std::string_view name, std::string_view value) {
    const auto* const coated = std::get_if<CoatedMaterial>(&material);
    if (coated == nullptr && name != detail::coat_keys.front()) return false;
    std::optional<Coat> coat;
    if (coated != nullptr) coat = coated->coat;
    const BaseMaterial base = base_of(material);
    const std::string_view kind = std::visit([]<class M>(const M&) { return MaterialDescription<M>::kind; }, base);
    const KindText one{std::string(kind), {{std::string(name), std::string(value)}}};
    if (Result<void> read = detail::read_coat(one, coat); !read) return pass_on(read);
    material = CoatedMaterial{base, *coat};
    return true;
}

struct Setting {
    std::string_view name;
    std::string value;

    // Below the coat, if there is one.
    Result<bool> operator()(CoatedMaterial& material) const { return std::visit(*this, material.base); }

    // Sets the material's key that matches; false if none does.
    template<class M>
    Result<bool> operator()(M& material) const {
        Result<bool> done = false;
        for_each_key<M>([&](const auto& key) {
            const Answer how = answer(key, name);
            if (how == Answer::none) return;
            const std::string_view as = how == Answer::by_its_root ? "roughness" : key.name;
            std::string text = value;
            if (how == Answer::by_its_complement) {
                const std::optional<double> number = parse_number(value);
                if (!number || *number < 0.0 || *number > 1.0) {
                    done = fail("USE0106", fmt::format("{} must be a number in [0, 1], not '{}'", name, value));
                    return;
                }
                text = shortest(1.0 - *number);
            }
            const KindText one{std::string(MaterialDescription<M>::kind), {{std::string(as), std::move(text)}}};
            Result<void> read = detail::read_material_key(one, key, material);
            done = true;
            if (!read) done = pass_on(read);
        });
        return done;
    }
};

} // namespace

std::span<const ParameterName> material_parameters() {
    static const Listed listed;
    return listed.names;
}

Result<bool> set_parameter(Material& material, std::string_view name, std::string_view value) {
    if (std::find(detail::coat_keys.begin(), detail::coat_keys.end(), name) != detail::coat_keys.end())
        return set_coat(material, name, value);
    return std::visit(Setting{name, std::string(value)}, material);
}

std::vector<std::string_view> parameters_of(const Material& material) {
    std::vector<std::string_view> names;
    for (const NamedParameter& parameter : parameters)
        std::visit(
            [&]<class M>(const M& /*material*/) {
                for_each_key<M>([&](const auto& key) {
                    if (answer(key, parameter.name) != Answer::none) names.push_back(parameter.name);
                });
            },
            base_of(material));
    for (const std::string_view key : detail::coat_keys)
        if (key == detail::coat_keys.front() || std::holds_alternative<CoatedMaterial>(material)) names.push_back(key);
    return names;
}

} // namespace gonio
