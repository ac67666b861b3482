// A material of a scene as the shading core takes it, in double.
#pragma once

#include <gonio/scene/material.hpp>
#include <gonio/shading/brdf.hpp>

#include <variant>

namespace gonio {

shading::Lambert<double> core_material(const LambertMaterial& material);
shading::Ggx<double> core_material(const GgxMaterial& material);
shading::KullaConty<double> core_material(const KullaContyMaterial& material);
shading::Frostbite<double> core_material(const FrostbiteMaterial& material);
shading::Ue4<double> core_material(const Ue4Material& material);
shading::Blinn<double> core_material(const BlinnMaterial& material);
shading::Eon<double> core_material(const EonMaterial& material);

using CoreMaterial =
    std::variant<shading::Lambert<double>, shading::Ggx<double>, shading::KullaConty<double>,
                 shading::Frostbite<double>, shading::Ue4<double>, shading::Blinn<double>, shading::Eon<double>>;

CoreMaterial core_material(const Material& material);

} // namespace gonio
