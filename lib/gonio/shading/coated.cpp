#include <gonio/shading/coated.hpp>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace gonio::shading {

namespace {

using Vec = vec3<double>;

Coat<double> without_shine(Coat<double> coat) {
    coat.shine = 0.0;
    return coat;
}

} // namespace

Coated coated_material(const AnyMaterial& base, double amount, double smoothness, CoatOrder order) {
    return std::visit([&](const auto& core) { return Coated{base, coat_over(core, amount, smoothness, order)}; }, base);
}

Vec brdf(const Coated& material, Vec n, Vec l, Vec v) {
    return diffuse_part(material, n, l, v) + specular_part(material, n, l, v, 0.0);
}

Vec diffuse_part(const Coated& material, Vec n, Vec l, Vec v) {
    return std::visit([&](const auto& core) { return coated_diffuse_part(material.coat, core, n, l, v); },
                      material.base);
}

Vec specular_part(const Coated& material, Vec n, Vec l, Vec v, double widening) {
    return std::visit([&](const auto& core) { return coated_specular_part(material.coat, core, n, l, v, widening); },
                      material.base);
}

double lobe_alpha(const Coated& material) {
    const double of_base = std::visit([](const auto& core) { return lobe_alpha(core); }, material.base);
    return material.coat.shine > 0.0 ? std::min(of_base, coat_alpha(material.coat)) : of_base;
}

Coated diffuse_alone(const Coated& material) {
    const AnyMaterial base =
        std::visit([](const auto& core) { return AnyMaterial(diffuse_alone(core)); }, material.base);
    return {base, without_shine(material.coat)};
}

BrdfSample<double> sample_brdf(const Coated& material, Vec n, Vec v, Vec u) {
    return std::visit([&](const auto& core) { return coated_sample(material.coat, core, n, v, u); }, material.base);
}

double pdf_brdf(const Coated& material, Vec n, Vec v, Vec l) {
    return std::visit([&](const auto& core) { return coated_pdf(material.coat, core, n, v, l); }, material.base);
}

Vec coat_part(const Coated& material, Vec n, Vec l, Vec v) {
    const double shine = coat_reflected(material.coat, detail::coat_lobe(material.coat, n, l, v, 0.0));
    return {shine, shine, shine};
}

Vec base_specular_part(const Coated& material, Vec n, Vec l, Vec v) {
    return specular_part({material.base, without_shine(material.coat)}, n, l, v, 0.0);
}

MaterialConstants constants_of(const Coated& material) {
    MaterialConstants constants = std::visit([](const auto& core) { return constants_of(core); }, material.base);
    constexpr std::size_t count = CoatConstants::most_numbers;
    static_assert(sizeof(CoatNumbers<double>) == count * sizeof(double));
    double numbers[count];
    const CoatNumbers<double>& coat = material.coat;
    std::memcpy(&numbers[0], &coat, sizeof numbers);
    constants.coat.is_on = true;
    constants.coat.order = material.coat.order;
    for (std::size_t i = 0; i < count; ++i)
        constants.coat.numbers[i] = static_cast<float>(numbers[i]);
    return constants;
}

} // namespace gonio::shading
