// three.js: a module that makes an IESSpotLight, which WebGPURenderer draws.
//
// Since r187 its texture is looked up at γ from the middle of the first column to that of the last, and at the azimuth
// from −180° at the middle of the first row on, wrapping; seen along the light, azimuth 0 is to the right and 90° up,
// as in the frame of a profile. So texel (i, j) holds the intensity at γ = i°, C = j° − 180°, over the peak. Before
// r187 the renderer took the first row for every azimuth.
#include <gonio/asset/detail/target_files.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio::asset_detail {

namespace {

constexpr int columns = 181;
constexpr int rows = 360; // 1 of an axial light

// Texels from 0 to 1 as unsigned 16-bit numbers in base64, the lower byte first.
std::string base64(const std::vector<double>& texels) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    for (const double texel : texels) {
        const auto value = static_cast<unsigned>(std::lround(65535.0 * std::clamp(texel, 0.0, 1.0)));
        bytes += static_cast<char>(value & 0xffU);
        bytes += static_cast<char>(value >> 8);
    }
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63U];
    }
    return text;
}

constexpr const char* module_text = R"js(// {description}
import {{
    Color, DataTexture, DataUtils, HalfFloatType, IESSpotLight, LinearFilter, RedFormat, RepeatWrapping
}} from 'three/webgpu';

export const fluxLumens = {flux};
export const peakCandela = {peak};

// Column i: gamma = i degrees. Row j: C = j - 180 degrees. 65535 is the peak.
const width = {columns};
const height = {rows};
const profile =
    '{texels}';

function makeTexture() {{
    const bytes = Uint8Array.from(atob(profile), (c) => c.charCodeAt(0));
    const texels = new Uint16Array(width * height);
    for (let i = 0; i < texels.length; i++)
        texels[i] = DataUtils.toHalfFloat((bytes[2 * i] + 256 * bytes[2 * i + 1]) / 65535);
    const texture = new DataTexture(texels, width, height, RedFormat, HalfFloatType);
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.wrapT = RepeatWrapping;
    texture.needsUpdate = true;
    return texture;
}}

// A light for WebGPURenderer, which shines from light.position to light.target.position. Pointed straight down, C0 is
// +X and C90 is -Z.
export function makeLight() {{
    const light = new IESSpotLight(new Color({red}, {green}, {blue}), peakCandela);
    light.angle = Math.PI / 2;
    light.iesMap = makeTexture();
    return light;
}}
)js";

} // namespace

std::vector<AssetFile> threejs_files(const MeasuredLight& light) {
    using namespace fmt::literals;
    const int height = light.web.stored_symmetry() == Symmetry::axial ? 1 : rows;
    std::vector<double> texels;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < columns; ++i)
            texels.push_back(light.web.candela(j - 180.0, i) / light.peak.value);
    std::string text =
        fmt::format(module_text, "description"_a = describe(light), "flux"_a = light.flux.value,
                    "peak"_a = light.peak.value, "columns"_a = columns, "rows"_a = height, "texels"_a = base64(texels),
                    "red"_a = light.color.x, "green"_a = light.color.y, "blue"_a = light.color.z);
    return {{light.name + ".js", std::move(text), {}}};
}

} // namespace gonio::asset_detail
