// Raw: only the portable profiles and, for several lights, a table of where each is placed. A sky is its picture, which
// its sidecar describes.
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

namespace gonio::asset_detail {

std::vector<AssetFile> raw_files(const SceneContent& scene) {
    std::vector<AssetFile> files;
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    if (scene.single) return files;
    std::string table = fmt::format("# {}\n"
                                    "# Metres; unit vectors of the aim (gamma 0), of C0 and of C90; colour of "
                                    "luminance 1, linear Rec.709.\n"
                                    "name,profile,flux_lm,peak_cd,x,y,z,aim_x,aim_y,aim_z,c0_x,c0_y,c0_z,c90_x,c90_y,"
                                    "c90_z,red,green,blue\n",
                                    scene.description);
    for (const SceneLight& light : scene.lights) {
        const MeasuredLight& profile = scene.profiles[light.profile];
        table += fmt::format("{},{}.ies,{},{},{},{},{},{},{}\n", light.name, profile.name, profile.flux.value,
                             profile.peak.value, triple(light.frame.origin, ","), triple(-light.frame.z, ","),
                             triple(light.frame.x, ","), triple(light.frame.y, ","), triple(light.color, ","));
    }
    files.push_back({scene.name + ".csv", std::move(table), {}});
    return files;
}

} // namespace gonio::asset_detail
