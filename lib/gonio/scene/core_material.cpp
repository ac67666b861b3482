#include <gonio/scene/core_material.hpp>

#include <type_traits>

namespace gonio {

namespace {

// Of a material without a coat.
template<class Cores, class M>
Cores core_of(const M& material) {
    if constexpr (HasSimpleForm<M>)
        if (MaterialDescription<M>::is_simple(material))
            return detail::from_values(material,
                                       [](const auto&... values) { return MaterialDescription<M>::simple(values...); });
    return core_material(material);
}

} // namespace

shading::AnyMaterial core_material(const BaseMaterial& material) {
    return std::visit([](const auto& m) { return core_of<shading::AnyMaterial>(m); }, material);
}

shading::Coated core_material(const CoatedMaterial& material) {
    const Coat& coat = material.coat;
    return shading::coated_material(core_material(material.base), coat.amount, coat.smoothness, coat.order);
}

bool is_anisotropic(const CoreMaterial& material) {
    return std::visit(
        []<class Core>(const Core& core) {
            if constexpr (std::is_same_v<Core, shading::Coated>)
                return std::holds_alternative<shading::Anisotropic<double>>(core.base);
            else
                return std::is_same_v<Core, shading::Anisotropic<double>>;
        },
        material);
}

CoreMaterial core_material(const Material& material) {
    return std::visit(
        []<class M>(const M& m) -> CoreMaterial {
            if constexpr (std::is_same_v<M, CoatedMaterial>)
                return core_material(m);
            else
                return core_of<CoreMaterial>(m);
        },
        material);
}

} // namespace gonio
