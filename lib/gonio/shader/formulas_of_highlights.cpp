// Every formula runs once here, to be recorded: the core's functions are called, since inlined they are twice as large.
#define GONIO_INLINE_BY_SIZE
#include <gonio/shader/exact_irradiance.hpp>
#include <gonio/shader/formulas.hpp>
#include <gonio/shader/highlights.hpp>
#include <gonio/shader/materials.hpp>
#include <gonio/shader/parameters.hpp>
#include <gonio/shader/sources.hpp>

#include <array>
#include <span>
#include <string_view>

namespace gonio::shader {

namespace {

// The rows of the list. Errors are what the test in tests/unit/shader prints, rounded up.

constexpr Formula ltc_row(std::string_view light, std::string_view method, std::string_view material,
                          std::string_view function, std::string_view title, std::string_view source, ShaderError error,
                          void (*record)(Function&)) {
    return {{"shade", light, method, material, {}},
            function,
            title,
            "luminance of red, green and blue per luminance of the light",
            source,
            error,
            "the result + 0.1 * (angle [rad] that the light subtends)",
            is_flat(light)
                ? "nearer to the light than a tenth of its size, where float decides on which side of its plane one is"
                : "nearer to the light than a tenth of its size",
            record};
}
constexpr Formula roughness_row(std::string_view material, std::string_view function, std::string_view title,
                                std::string_view source, double error, void (*record)(Function&)) {
    return {{"roughness", {}, {}, material, {}},
            function,
            title,
            "the roughness [0, 1.3] of the isotropic lobe that is as wide in the plane of normal and view; above 1 it "
            "counts as 1",
            source,
            {error, error},
            "the result + 0.1",
            {},
            record};
}

constexpr std::string_view by_rows =
    "the lobe summed over rows of points that the transformed cosine of Heitz et al., ACM TOG 35(4), 2016, places. "
    "leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view exact_and_by_rows =
    "the diffuse part by the exact irradiance; the lobe summed over rows of points that the transformed cosine of "
    "Heitz et al., ACM TOG 35(4), 2016, places. leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view mean_and_by_rows =
    "the diffuse part by the exact irradiance and the mean of its factor over points of the light; the lobe summed "
    "over rows of points that the transformed cosine of Heitz et al., ACM TOG 35(4), 2016, places. leaning and "
    "reflected: gonio bake --table ltc-ggx";
constexpr std::string_view by_stretched_rows =
    "the lobe summed over rows of points that a transformed cosine places: that of the isotropic lobe as wide in the "
    "plane of normal and view, stretched and sheared. leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view by_share =
    "Heitz et al., ACM TOG 35(4), 2016; the lobe keeps its sign, the light is clipped once, and points of the light "
    "correct it. leaning and reflected: gonio bake --table ltc-ggx";

constexpr std::array all{
    ltc_row("sphere", "ltc", "ggx", "sphere_shade_ggx_ltc", "A GGX surface under a uniform sphere.", by_rows,
            {3e-4, 3e-4}, highlight_ltc<Sphere>),
    ltc_row("disk", "ltc", "ggx", "disk_shade_ggx_ltc", "A GGX surface under a uniform one-sided disk.", by_rows,
            {5e-3, 5e-2}, highlight_ltc<Disk>),
    ltc_row("rect", "ltc", "ggx", "rect_shade_ggx_ltc", "A GGX surface under a uniform one-sided rectangle.", by_rows,
            {5e-5, 1}, highlight_ltc<Rectangle>),
    ltc_row("tube", "ltc", "ggx", "tube_shade_ggx_ltc", "A GGX surface under a uniform tube.", by_rows, {3e-4, 3e-4},
            highlight_ltc<Tube>),
    ltc_row("sphere", "ltc-share", "ggx", "sphere_shade_ggx_ltc_share", "A GGX surface under a uniform sphere.",
            by_share, {2e-3, 2e-3}, highlight_by_share<Sphere>),
    ltc_row("disk", "ltc-share", "ggx", "disk_shade_ggx_ltc_share", "A GGX surface under a uniform one-sided disk.",
            by_share, {3e-2, 3e-1}, highlight_by_share<Disk>),
    ltc_row("rect", "ltc-share", "ggx", "rect_shade_ggx_ltc_share",
            "A GGX surface under a uniform one-sided rectangle.", by_share, {3e-5, 2}, highlight_by_share<Rectangle>),
    ltc_row("tube", "ltc-share", "ggx", "tube_shade_ggx_ltc_share", "A GGX surface under a uniform tube.", by_share,
            {1e-3, 1e-3}, highlight_by_share<Tube>),
    ltc_row("sphere", "ltc", "ggx-anisotropic", "sphere_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform sphere.", by_stretched_rows, {6e-5, 6e-4},
            highlight_anisotropic<Sphere>),
    ltc_row("disk", "ltc", "ggx-anisotropic", "disk_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform one-sided disk.", by_stretched_rows, {2e-5, 7e-1},
            highlight_anisotropic<Disk>),
    ltc_row("rect", "ltc", "ggx-anisotropic", "rect_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform one-sided rectangle.", by_stretched_rows, {1e-5, 2e-3},
            highlight_anisotropic<Rectangle>),
    ltc_row("tube", "ltc", "ggx-anisotropic", "tube_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform tube.", by_stretched_rows, {7e-3, 2e-2},
            highlight_anisotropic<Tube>),
    ltc_row("sphere", "ltc", "ue4", "sphere_shade_ue4_ltc", "Unreal Engine 4's material under a uniform sphere.",
            exact_and_by_rows, {3e-4, 3e-4}, shade_ltc<Sphere, sphere_stages, ue4>),
    ltc_row("disk", "ltc", "ue4", "disk_shade_ue4_ltc", "Unreal Engine 4's material under a uniform one-sided disk.",
            exact_and_by_rows, {1e-3, 6e-3}, shade_ltc<Disk, disk_stages, ue4>),
    ltc_row("rect", "ltc", "ue4", "rect_shade_ue4_ltc",
            "Unreal Engine 4's material under a uniform one-sided rectangle.", exact_and_by_rows, {5e-5, 2e-3},
            shade_ltc<Rectangle, rectangle_stages, ue4>),
    ltc_row("tube", "ltc", "ue4", "tube_shade_ue4_ltc", "Unreal Engine 4's material under a uniform tube.",
            exact_and_by_rows, {5e-5, 2e-2}, shade_ltc<Tube, tube_stages, ue4>),
    ltc_row("sphere", "ltc", "gltf", "sphere_shade_gltf_ltc", "The material of glTF 2.0 under a uniform sphere.",
            mean_and_by_rows, {2e-4, 4e-4}, shade_ltc<Sphere, sphere_stages, gltf>),
    ltc_row("disk", "ltc", "gltf", "disk_shade_gltf_ltc", "The material of glTF 2.0 under a uniform one-sided disk.",
            mean_and_by_rows, {5e-3, 2e-2}, shade_ltc<Disk, disk_stages, gltf>),
    ltc_row("rect", "ltc", "gltf", "rect_shade_gltf_ltc",
            "The material of glTF 2.0 under a uniform one-sided rectangle.", mean_and_by_rows, {3e-5, 8e-1},
            shade_ltc<Rectangle, rectangle_stages, gltf>),
    ltc_row("tube", "ltc", "gltf", "tube_shade_gltf_ltc", "The material of glTF 2.0 under a uniform tube.",
            mean_and_by_rows, {2e-4, 2e-4}, shade_ltc<Tube, tube_stages, gltf>),
    ltc_row("sphere", "ltc", "frostbite", "sphere_shade_frostbite_ltc", "Frostbite's material under a uniform sphere.",
            mean_and_by_rows, {3e-4, 5e-4}, shade_ltc<Sphere, sphere_stages, frostbite>),
    ltc_row("disk", "ltc", "frostbite", "disk_shade_frostbite_ltc",
            "Frostbite's material under a uniform one-sided disk.", mean_and_by_rows, {1e-3, 2e-2},
            shade_ltc<Disk, disk_stages, frostbite>),
    ltc_row("rect", "ltc", "frostbite", "rect_shade_frostbite_ltc",
            "Frostbite's material under a uniform one-sided rectangle.", mean_and_by_rows, {9e-5, 8e-3},
            shade_ltc<Rectangle, rectangle_stages, frostbite>),
    ltc_row("tube", "ltc", "frostbite", "tube_shade_frostbite_ltc", "Frostbite's material under a uniform tube.",
            mean_and_by_rows, {3e-4, 6e-3}, shade_ltc<Tube, tube_stages, frostbite>),
    roughness_row("ggx-anisotropic", "ggx_anisotropic_roughness",
                  "Where an anisotropic lobe reads the table of isotropic ones.", heitz, 4e-7, anisotropic_roughness),
};

} // namespace

std::span<const Formula> formulas_of_highlights() {
    return all;
}

} // namespace gonio::shader
