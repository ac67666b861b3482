// Babylon.js: a module that makes a SpotLight with a profile texture, looked up at u = γ/180° alone. Babylon's own
// loader of .ies takes the first plane, and loses the candela; ours gives the mean over C, and the peak as intensity.
#include <gonio/asset/detail/target_files.hpp>

#include <fmt/format.h>

#include <span>

namespace gonio::asset_detail {

namespace {

// Eight numbers a line.
std::string number_lines(std::span<const float> numbers) {
    std::string lines;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        lines += fmt::format("{}{},{}", i % 8 == 0 ? "    " : " ", numbers[i], i % 8 == 7 ? "\n" : "");
    if (numbers.size() % 8 != 0) lines += '\n';
    return lines;
}

constexpr const char* module_text = R"js(// {description}
// The mean over C: {loss:.3g} cd of {peak:.6g} cd off at worst.
import {{ Color3 }} from '@babylonjs/core/Maths/math.color.js';
import {{ Vector3 }} from '@babylonjs/core/Maths/math.vector.js';
import {{ Constants }} from '@babylonjs/core/Engines/constants.js';
import {{ Light }} from '@babylonjs/core/Lights/light.js';
import {{ SpotLight }} from '@babylonjs/core/Lights/spotLight.js';
import {{ RawTexture }} from '@babylonjs/core/Materials/Textures/rawTexture.js';

export const fluxLumens = {flux};
export const peakCandela = {peak};
// Texel i: the mean over C and from i to i + 1 degrees, over the peak.
const profile = [
{texels}];

// A light for PBR materials, with inverse-square falloff, at the origin and shining along -Y until it is moved.
export function makeLight(scene) {{
    const light = new SpotLight({name}, Vector3.Zero(), Vector3.Down(), Math.PI, 0, scene);
    light.iesProfileTexture = new RawTexture(
        Float32Array.from(profile), profile.length, 1, Constants.TEXTUREFORMAT_R, scene, false, false,
        Constants.TEXTURE_BILINEAR_SAMPLINGMODE, Constants.TEXTURETYPE_FLOAT);
    light.intensityMode = Light.INTENSITYMODE_LUMINOUSINTENSITY;
    light.falloffType = Light.FALLOFF_PHYSICAL;
    light.intensity = peakCandela;
    light.diffuse = light.specular = new Color3({red}, {green}, {blue});
    return light;
}}
)js";

} // namespace

std::vector<AssetFile> babylon_files(const MeasuredLight& light) {
    using namespace fmt::literals;
    // Of a layout and a size that every web has: it does not fail.
    BakeOptions rings;
    rings.layout = Layout::v180;
    rings.width = 180;
    rings.height = 1;
    rings.normalization = Normalization::peak;
    rings.threads = 1;
    const Result<Texture> baked = bake_texture(light.web, rings);
    if (!baked) return {};
    const Texture& ring_means = *baked;
    std::string text =
        fmt::format(module_text, "description"_a = describe(light), "loss"_a = ring_means.max_error.value,
                    "flux"_a = light.flux.value, "peak"_a = light.peak.value, "name"_a = quoted(light.name),
                    "texels"_a = number_lines(ring_means.image.pixels), "red"_a = light.color.x,
                    "green"_a = light.color.y, "blue"_a = light.color.z);
    return {{light.name + ".js", std::move(text), {}}};
}

} // namespace gonio::asset_detail
