// pbrt-v4: a goniometric light with an equal-area image (P. Clarberg, "Fast Equal-Area Mapping of the (Hemi)Sphere
// using SIMD", 2008, turned for octahedral maps).
//
// pbrt looks a square image of one channel Y up at EqualAreaSphereToSquare of the light's direction with y and z
// swapped: the image's middle is +Y, its right edge +X, its lower edge +Z. Ours has the nadir in the middle, C0 to the
// right and C90 above, so its rows are turned over and the light's frame by −90° about X. pbrt scales the image to
// `power`, which it counts in lumens; texels of equal solid angle make that exact.
#include <gonio/asset/detail/target_files.hpp>

#include <fmt/format.h>

namespace gonio::asset_detail {

namespace {

constexpr int image_size = 512; // pbrt does not filter

} // namespace

std::vector<AssetFile> pbrt_files(const MeasuredLight& light) {
    AssetTexture texture;
    texture.bake.layout = Layout::octahedral_equal_area;
    texture.bake.width = image_size;
    texture.bake.height = image_size;
    texture.bake.threads = 1;
    texture.flip_rows = true;
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
