#include <gonio/scene/core_material.hpp>

namespace gonio {

shading::Coated core_material(const CoatedMaterial& material) {
    const shading::AnyMaterial base =
        std::visit([](const auto& m) { return shading::AnyMaterial(core_material(m)); }, material.base);
    return shading::coated_material(base, material.coat.amount, material.coat.smoothness, material.coat.order);
}

CoreMaterial core_material(const Material& material) {
    return std::visit([](const auto& m) { return CoreMaterial(core_material(m)); }, material);
}

} // namespace gonio
