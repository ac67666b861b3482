#include <gonio/asset/sidecar.hpp>
#include <gonio/base/version.hpp>

#include <nlohmann/json.hpp>

namespace gonio {

std::string texture_sidecar(const Texture& texture, const TextureSource& source, std::string_view pixel) {
    const nlohmann::ordered_json sidecar{
        {"schema", "gonio.texture/1"},
        {"layout", texture.layout},
        {"width", texture.image.width},
        {"height", texture.image.height},
        {"channels", texture.image.channels},
        {"pixel", pixel},
        {"texel_convention", texture.texel_convention},
        {"frame", {{"aim", "-Z"}, {"c0", "+X"}, {"handedness", "right"}}},
        {"normalization", to_text(texture.normalization)},
        {"cd_per_unit", texture.cd_per_unit},
        {"peak_cd", texture.peak.value},
        {"flux_lm", texture.flux.value},
        {"texture_flux_lm", texture.texture_flux.value},
        {"solid_angle_sr", texture.solid_angle.value},
        {"max_error_cd", texture.max_error.value},
        {"quantization_error_cd", texture.quantization_error.value},
        {"source", {{"file", source.file}, {"sha256", source.sha256}}},
        {"tool", std::string("gonio ") + version},
    };
    // A file name need not be UTF-8: what is not becomes a replacement character instead of a failure.
    return sidecar.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace gonio
