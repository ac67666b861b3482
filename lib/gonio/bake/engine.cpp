#include <gonio/bake/engine.hpp>
#include <gonio/base/named.hpp>

#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

BakeOptions options(Layout layout, int width, int height, TexelType type, Normalization normalization) {
    BakeOptions bake;
    bake.layout = layout;
    bake.width = width;
    bake.height = height;
    bake.texel_type = type;
    bake.normalization = normalization;
    return bake;
}

BakeOptions row(int width, TexelType type, Sampling sampling) {
    BakeOptions bake = options(Layout::v180, width, 1, type, Normalization::peak);
    bake.sampling = sampling;
    return bake;
}

// The light space of Unity and of spots: C0 is up and C90 left where the layout has +Y up and +X right.
const glm::dmat3 c0_up{0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0};

BakeOptions cookie(int size, int border, Sampling sampling) {
    BakeOptions bake = options(Layout::gnomonic, size, size, TexelType::uint8, Normalization::peak);
    bake.chart.border = border;
    bake.chart.turned = c0_up;
    bake.sampling = sampling;
    return bake;
}

BakeOptions panorama(int width, int height, TexelType type) {
    return options(Layout::panorama, width, height, type, Normalization::peak);
}

std::vector<Engine> make_engines() {
    BakeOptions unity_point = panorama(512, 256, TexelType::half);
    unity_point.chart.turned = c0_up;
    BakeOptions godot_omni = panorama(512, 256, TexelType::uint8);
    godot_omni.transfer = Transfer::srgb;
    godot_omni.chart.turned = glm::dmat3(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0); // half a turn about +X
    BakeOptions godot_spot = cookie(256, 0, Sampling::mean);
    godot_spot.transfer = Transfer::srgb;
    // The middle of the first row is C = −180°: turned by half a row more than the layout.
    BakeOptions three = options(Layout::v180, 181, 360, TexelType::half, Normalization::peak);
    three.sampling = Sampling::edge_columns;
    const double first_row = -180.5 * std::numbers::pi / 180.0;
    three.chart.turned = glm::dmat3(std::cos(first_row), std::sin(first_row), 0.0, -std::sin(first_row),
                                    std::cos(first_row), 0.0, 0.0, 0.0, 1.0);
    // The rows of pbrt's image run down where Clarberg's run up.
    BakeOptions pbrt = options(Layout::octahedral_equal_area, 512, 512, TexelType::float32, Normalization::none);
    pbrt.chart.turned = glm::dmat3(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0);
    BakeOptions nabla = options(Layout::octahedral, 257, 257, TexelType::uint16, Normalization::peak);
    nabla.sampling = Sampling::corners;
    return {
        {"babylon", "Babylon.js 9: 180x1 float over gamma, texel centres, mean over C",
         "u = gamma/180 deg, linear; the light's intensity is the peak in candela",
         row(180, TexelType::float32, Sampling::mean), 1, "exr", "-Z", "+X", "right"},
        {"falcor", "Falcor: 256x1 half over gamma, texel centres", "u = acos(dot(-posToLight, lightDir))/pi",
         row(256, TexelType::half, Sampling::mean), 1, "exr", "-Z", "+X", "right"},
        {"filament", "Filament and shaders alike: 256x1 half over gamma, texel centres",
         "u = acos(dot(-posToLight, lightDir))/pi", row(256, TexelType::half, Sampling::mean), 1, "exr", "-Z", "+X",
         "right"},
        {"godot-omni", "Godot 4: panorama for an omni light's projector, 8 bits, sRGB, upside down",
         "longitude and latitude about the light's -Y, which is the first row, +Z in the middle, +X right of it: the "
         "engine's omni projectors stand on their head; the orientation follows its shaders and has not been tried",
         godot_omni, 1, "png", "-Z", "+X", "right"},
        {"godot-spot", "Godot 4: a spot light's projector over its cone, 8 bits, sRGB",
         "a plane across the aim; tan(cone/2) lies on the edge", godot_spot, 1, "png", "-Z", "+Y", "right"},
        {"luxcore", "LuxCore: latlong 512x256, texel centres",
         "x = phi/2pi, y = theta/pi; LuxCore divides by the mean, so only the shape counts",
         options(Layout::latlong, 512, 256, TexelType::float32, Normalization::none), 1, "exr", "+Z", "+X", "right"},
        {"nabla", "Nabla: octahedral 257x257, 16 bits, samples from corner to corner",
         "texel (i, j) stands at i/(width-1), j/(height-1)", nabla, 1, "png", "-Z", "+X", "right"},
        {"pbrt-v4", "pbrt-v4: equal-area octahedral 512x512 of candela, read by the nearest texel",
         "goniometric light: centre +Y, right edge +X, bottom edge +Z, corners -Y", pbrt, 1, "exr", "+Y", "+X",
         "right"},
        {"quake2rtx", "Q2RTX: 256x1 over gamma, 16-bit PNG", "the angle from the aim on x, 0 to 180 deg",
         row(256, TexelType::uint16, Sampling::mean), 1, "png", "-Z", "+X", "right"},
        {"three", "three.js since r187: 181x360 half, gamma across and C down, for an IESSpotLight",
         "column i at gamma = i deg, row j at C = j - 180 deg, wrapping; behind the light the shader looks up C + 180 "
         "deg; "
         "light.intensity is the peak in candela",
         three, 1, "exr", "-Z", "+X", "right"},
        {"three-r186", "three.js before r187: 180x1 half, samples at left edges, mean over C",
         "u = acos(c)/pi, sample i at i*180/width deg; light.intensity is the peak in candela",
         row(180, TexelType::half, Sampling::left_edge), 1, "exr", "-Z", "+X", "right"},
        {"unity-point", "Unity HDRP: source of a point light's cube cookie, mapping Cylindrical",
         "the aim in the middle, C0 up, C90 left, the opposite of the aim at the edges", unity_point, 1, "exr", "+Z",
         "+Y", "left"},
        {"unity-spot", "Unity HDRP: a spot light's cookie, from edge to edge inside a black border",
         "pixels 1 to N-2 run from -tan(cone/2) to tan(cone/2), C0 up, C90 left", cookie(128, 1, Sampling::corners), 1,
         "png", "+Z", "+Y", "left"},
        {"unreal", "Unreal: 256x1 half RGBA, samples at left edges, mean over C",
         "u = asin(dot(toLight, lightDir))/pi + 0.5 = gamma/180 deg; column x at 180*x/256 deg; clamp, no mips",
         row(256, TexelType::half, Sampling::left_edge), 4, "exr", "+X", "-Y", "left"},
        {"unreal-2d", "Unreal: 256x256 half RGBA, gamma across and C down",
         "u = gamma/180 deg, v = C/360 deg (0 deg along -Y); clamp, no mips",
         options(Layout::v180, 256, 256, TexelType::half, Normalization::peak), 4, "exr", "+X", "-Y", "left"},
    };
}

} // namespace

std::span<const Engine> engines() {
    static const std::vector<Engine> all = make_engines();
    return all;
}

Result<const Engine*> find_engine(std::string_view name) {
    return find_named("engine", name, engines());
}

} // namespace gonio
