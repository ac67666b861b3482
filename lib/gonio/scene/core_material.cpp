#include <gonio/scene/core_material.hpp>

namespace gonio {

namespace {

shading::vec3<double> vec(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

shading::Lambert<double> core_material(const LambertMaterial& material) {
    return {vec(material.albedo)};
}

shading::Ggx<double> core_material(const GgxMaterial& material) {
    return {vec(material.f0), material.alpha};
}

shading::KullaConty<double> core_material(const KullaContyMaterial& material) {
    return shading::kulla_conty_material(vec(material.f0), material.alpha);
}

shading::Frostbite<double> core_material(const FrostbiteMaterial& material) {
    return shading::frostbite_material(vec(material.base), material.smoothness, material.metal, material.reflectance);
}

shading::Ue4<double> core_material(const Ue4Material& material) {
    return shading::ue4_material(vec(material.base), material.metallic, material.roughness, material.specular,
                                 material.cavity);
}

shading::Blinn<double> core_material(const BlinnMaterial& material) {
    return shading::blinn_material(vec(material.albedo), vec(material.specular), material.smoothness, material.wet);
}

shading::Eon<double> core_material(const EonMaterial& material) {
    return {vec(material.albedo), material.roughness};
}

CoreMaterial core_material(const Material& material) {
    return std::visit([](const auto& m) { return CoreMaterial(core_material(m)); }, material);
}

} // namespace gonio
