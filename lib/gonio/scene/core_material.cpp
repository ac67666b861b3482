#include <gonio/scene/core_material.hpp>

namespace gonio {

CoreMaterial core_material(const Material& material) {
    return std::visit([](const auto& m) { return CoreMaterial(core_material(m)); }, material);
}

} // namespace gonio
