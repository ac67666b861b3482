// The albedo of each material, by roughness and view: the tables of lib/gonio/shading/MEASURED.md.
//
//   gonio-furnace-table
//
// Base colour and albedo are 1, f0 of dielectrics 0.04; the columns are n·v. The last table is the error of the glossy
// Fresnel of Remember Me.
#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coated.hpp>
#include <gonio/shading/furnace.hpp>
#include <gonio/shading/ggx_albedo.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace gonio;
using Vec = shading::vec3<double>;

constexpr Vec white{1.0, 1.0, 1.0};
constexpr std::array cosines{1e-4, 0.01, 0.05, 0.1, 0.3, 0.6, 1.0};
constexpr std::array roughnesses{0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0};

template<class Make>
void table(const char* title, const char* parameter, const Make& make) {
    (void)std::printf("%s\n\n| %s |", title, parameter);
    for (const double mu : cosines)
        (void)std::printf(" %g |", mu);
    (void)std::printf("\n|---|---|---|---|---|---|---|---|\n");
    double least = HUGE_VAL;
    double most = 0.0;
    for (const double roughness : roughnesses) {
        const auto material = make(roughness);
        (void)std::printf("| %g |", roughness);
        for (const double mu : cosines) {
            const double albedo = shading::directional_albedo(material, mu, lobe_alpha(material), 800, 400).x;
            least = std::fmin(least, albedo);
            most = std::fmax(most, albedo);
            (void)std::printf(" %.4f |", albedo);
        }
        (void)std::printf("\n");
    }
    (void)std::printf("\nleast %.4f, most %.4f\n\n", least, most);
}

// By the roughness of the coat.
void coats(const char* title, const shading::AnyMaterial& base, shading::CoatOrder order) {
    table(title, "coat, 1 − smoothness", [&](double r) { return shading::coated_material(base, 1.0, 1.0 - r, order); });
}

// F0 = 0.04: the published formula less the mean over the GGX lobe.
void glossy_fresnel_errors() {
    (void)std::printf("Glossy Fresnel of Remember Me, error\n\n| √α |");
    for (const double mu : cosines)
        (void)std::printf(" %g |", mu);
    (void)std::printf("\n|---|---|---|---|---|---|---|---|\n");
    for (const double roughness : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        const auto albedo = shading::ggx_albedo(roughness * roughness);
        (void)std::printf("| %g |", roughness);
        for (const double mu : cosines)
            (void)std::printf(" %+.3f |", shading::glossy_fresnel_remember_me(0.04, roughness, mu) -
                                              shading::glossy_fresnel(albedo, 0.04, mu));
        (void)std::printf("\n");
    }
}

} // namespace

int main() {
    table("Frostbite", "1 − smoothness",
          [](double r) { return shading::frostbite_material(white, 1.0 - r, 0.0, 0.5); });
    table("Frostbite, diffuse part alone", "1 − smoothness", [](double r) {
        auto material = shading::frostbite_material(white, 1.0 - r, 0.0, 0.5);
        material.f0 = {0.0, 0.0, 0.0};
        material.f90 = 0.0;
        material.alpha = 1.0; // avoids a narrow lobe that the quadrature would have to find
        return material;
    });
    table("UE4", "roughness", [](double r) { return shading::ue4_material(white, 0.0, r, 0.5, 1.0); });
    table("glTF", "roughness", [](double r) { return shading::gltf_material(white, 0.0, r); });
    table("Blinn", "1 − smoothness", [](double r) {
        return shading::blinn_material(white, Vec{0.04, 0.04, 0.04}, 1.0 - r, 0.0);
    });
    table("Blinn, black with f0 = 1", "1 − smoothness", [](double r) {
        return shading::blinn_material(Vec{0.0, 0.0, 0.0}, white, 1.0 - r, 0.0);
    });
    table("GGX, f0 = 1, scattered once", "√α", [](double r) { return shading::Ggx<double>{white, r * r}; });
    table("Kulla and Conty, f0 = 1", "√α", [](double r) { return shading::kulla_conty_material(white, r * r); });
    table("EON", "roughness", [](double r) { return shading::Eon<double>{white, r}; });
    using Order = shading::CoatOrder;
    coats("Lambert below a coat, physical", shading::Lambert<double>{white}, Order::physical);
    coats("Lambert below a coat, ue4", shading::Lambert<double>{white}, Order::ue4);
    coats("Lambert below a coat, filament", shading::Lambert<double>{white}, Order::filament);
    coats("EON of roughness 1 below a coat", shading::Eon<double>{white, 1.0}, Order::physical);
    coats("Kulla and Conty, f0 = 1, α = 0.25, below a coat", shading::kulla_conty_material(white, 0.25),
          Order::physical);
    coats("glTF of roughness 0.5 below a coat", shading::gltf_material(white, 0.0, 0.5), Order::physical);
    glossy_fresnel_errors();
    return 0;
}
