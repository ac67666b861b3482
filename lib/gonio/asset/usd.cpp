// OpenUSD: UsdLux of 24.08. A sphere of 1 m² of projected area treated as a point, so that an intensity of 1 nt shines
// with 1 cd, which the profile scales. angleScale is never authored: its formulas differ between renderers.
#include <gonio/asset/detail/target_files.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gonio::asset_detail {

namespace {

// A prim's name: letters, digits and '_', no digit first.
std::string identifier(std::string_view name) {
    std::string prim;
    for (const char c : name)
        prim += c == '-' ? '_' : c;
    return prim[0] >= '0' && prim[0] <= '9' ? "_" + prim : prim;
}

} // namespace

std::vector<AssetFile> usd_files(const MeasuredLight& light) {
    const std::string ies = light.name + ".ies";
    const std::string prim = identifier(light.name);
    std::string text = fmt::format("#usda 1.0\n"
                                   "(\n"
                                   "    defaultPrim = \"{0}\"\n"
                                   "    doc = {1}\n"
                                   "    metersPerUnit = 1\n"
                                   "    upAxis = \"Z\"\n"
                                   ")\n"
                                   "\n"
                                   "def SphereLight \"{0}\" (\n"
                                   "    prepend apiSchemas = [\"ShapingAPI\"]\n"
                                   "    customData = {{\n"
                                   "        double flux_lm = {2}\n"
                                   "        double peak_cd = {3}\n"
                                   "    }}\n"
                                   ")\n"
                                   "{{\n"
                                   "    color3f inputs:color = ({4}, {5}, {6})\n"
                                   "    float inputs:intensity = 1\n"
                                   "    bool inputs:normalize = 0\n"
                                   "    float inputs:radius = {7}\n"
                                   "    asset inputs:shaping:ies:file = @./{8}@\n"
                                   "    bool inputs:shaping:ies:normalize = 0\n"
                                   "    bool treatAsPoint = 1\n"
                                   "}}\n",
                                   prim, quoted(describe(light)), light.flux.value, light.peak.value, light.color.x,
                                   light.color.y, light.color.z, std::sqrt(std::numbers::inv_pi), ies);
    return {{light.name + ".usda", std::move(text), {}}, {ies, light.portable_ies, {}}};
}

std::vector<AssetFile> raw_files(const MeasuredLight& light) {
    return {{light.name + ".ies", light.portable_ies, {}}};
}

} // namespace gonio::asset_detail
