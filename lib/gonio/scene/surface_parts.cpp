#include <gonio/scene/core_material.hpp>
#include <gonio/scene/detail/surface_parts.hpp>

namespace gonio::detail {

SurfaceParts surface_parts(const Material& material) {
    using Vec = shading::vec3<double>;
    return std::visit(
        [](const auto& core) {
            return SurfaceParts{
                [core](Vec n, Vec l, Vec v) { return shading::diffuse_part(core, n, l, v); },
                [core](Vec n, Vec l, Vec v) { return shading::specular_part(core, n, l, v, 0.0); },
                shading::lobe_alpha(core),
            };
        },
        core_material(material));
}

} // namespace gonio::detail
