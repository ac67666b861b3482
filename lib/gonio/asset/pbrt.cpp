// pbrt-v4: a goniometric light with an equal-area image (P. Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere
// using SIMD", 2008, turned for octahedral maps).
//
// pbrt looks a square image of one channel Y up at EqualAreaSphereToSquare of the light's direction with y and z
// swapped: the image's middle is +Y, its right edge +X, its lower edge +Z. Baked with the nadir in the middle, C0 to
// the right and C90 below, it is turned by −90° about X. pbrt scales it to `power`, which it counts in lumens; texels
// of equal solid angle make that exact.
#include <gonio/asset/detail/target_files.hpp>
#include <gonio/bake/engine.hpp>

#include <fmt/format.h>

namespace gonio::asset_detail {

std::vector<AssetFile> pbrt_files(const MeasuredLight& light) {
    AssetTexture texture{(*find_engine("pbrt-v4"))->bake};
    texture.bake.threads = 1;
    const std::string image = light.name + ".exr";
    std::string text =
        fmt::format("# {}\n"
                    "# The beam goes along -Z, C0 along +X, C90 along +Y.\n"
                    "AttributeBegin\n"
                    "  Rotate -90 1 0 0\n"
                    "  LightSource \"goniometric\"\n"
                    "    \"string filename\" \"{}\"\n"
                    "    \"rgb I\" [ {} {} {} ]\n"
                    "    \"float power\" [ {} ]\n"
                    "AttributeEnd\n",
                    describe(light), image, light.color.x, light.color.y, light.color.z, light.flux.value);
    return {{light.name + ".pbrt", std::move(text), {}}, {image, {}, texture}};
}

} // namespace gonio::asset_detail
