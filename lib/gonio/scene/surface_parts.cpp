#include <gonio/scene/detail/surface_parts.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_lambert.hpp>

#include <algorithm>

namespace gonio::detail {

namespace {

using Vec = shading::vec3<double>;

constexpr Vec black{0.0, 0.0, 0.0};

Vec vec(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

template<class CoreMaterial>
SurfaceParts::Reflectance reflectance(const CoreMaterial& material) {
    return [material](Vec n, Vec l, Vec v) { return shading::brdf(material, n, l, v); };
}

SurfaceParts parts_of(const LambertMaterial& m) {
    return {reflectance(shading::Lambert<double>{vec(m.albedo)}), {}, 1.0};
}

SurfaceParts parts_of(const FrostbiteMaterial& m) {
    const auto whole = shading::frostbite_material(vec(m.base), m.smoothness, m.metal, m.reflectance);
    auto diffuse = whole;
    diffuse.f0 = black;
    diffuse.f90 = 0.0;
    auto specular = whole;
    specular.albedo = black;
    SurfaceParts parts{{}, reflectance(specular), std::max(whole.alpha, shading::minimum_alpha)};
    if (m.metal < 1.0) parts.diffuse = reflectance(diffuse);
    return parts;
}

} // namespace

SurfaceParts surface_parts(const Material& material) {
    return std::visit([](const auto& m) { return parts_of(m); }, material);
}

} // namespace gonio::detail
