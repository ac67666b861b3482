// Pictures one after another while one moves lights and camera: what `gonio preview` makes of the same words, as
// pixels. What a change leaves as it was is not computed again.
#include <gonio/light/kept_profiles.hpp>
#include <gonio/light/light_change.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/media/dither.hpp>
#include <gonio/plot/picture_contours.hpp>
#include <gonio/preview/relit.hpp>
#include <gonio/preview/render.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/rig_input.hpp"
#include "../preview/picture.hpp"
#include "../preview/request.hpp"
#include "to_js.hpp"
#include "words.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>
#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

using emscripten::val;
using wasm::value_of;

// Opaque pixels with four channels of 8 bits, which a canvas shows.
std::vector<std::uint8_t> rgba_of(const Image& image, bool dithers) {
    const std::size_t count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<std::uint8_t> rgba(4 * count, 255);
    const std::vector<float> pixels = dithers ? media::dithered(image, 255) : image.pixels;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float value = pixels[3 * i + channel];
            rgba[4 * i + channel] =
                static_cast<std::uint8_t>((value > 0.0F ? std::min(value, 1.0F) : 0.0F) * 255.0F + 0.5F);
        }
    return rgba;
}

// [{value, rgb}] of lines of equal light, the lowest first, in lux or cd/m².
val lines_of(const ShownPicture& shown, const PreviewRequest& request) {
    val lines = val::array();
    if (shown.levels.empty()) return lines;
    const std::vector<Ink> inks = contour_inks(shown.levels.size(), *request.look.palette);
    for (std::size_t i = 0; i < inks.size(); ++i) {
        val line = val::object();
        line.set("value", shown.levels[i]);
        val rgb = val::array();
        for (const std::uint8_t channel : {inks[i].r, inks[i].g, inks[i].b})
            rgb.call<void>("push", static_cast<int>(channel));
        line.set("rgb", rgb);
        lines.call<void>("push", line);
    }
    return lines;
}

class LivePreview {
public:
    // `list`: the words after `gonio preview`. `has_same_lights`: the rig and all words about lights are those of the
    // last picture. `has_same_scene`: but for lights and display, so are the rig and all words. Throws an Error of
    // JavaScript.
    val render(const val& list, bool has_same_lights, bool has_same_scene) {
        Words words(list);
        Arguments arguments = value_of(Arguments::parse(*find_command("preview"), words.pointers()));
        const detail::KeepingProfiles keeping(profiles_);
        PreviewRequest request = value_of(parse_preview(arguments));
        Diagnostics diagnostics = request.diagnostics;
        // What bounces is known to be the same where these are the same objects.
        if (!has_same_lights || lights_.empty())
            lights_ = value_of(resolve_input(request.lights, diagnostics, request.render.threads));
        const std::vector<Light>& lights = lights_;
        std::optional<Rendering> followed;
        if (has_same_scene) followed = from_the_last(lights, has_same_lights, request.render);
        const bool is_rendered = !followed;
        Rendering rendering = followed ? *std::move(followed) : rendered(request, lights);
        luminance_nt_ = rendering.luminance_nt;
        illuminance_lx_ = rendering.illuminance_lx;
        Console console;
        console.set_quiet(true);
        const ShownPicture shown = value_of(show_picture(std::move(rendering), request, lights, console));

        const std::vector<std::uint8_t> rgba = rgba_of(shown.image, is_dithered(request.look.look));
        val picture = val::object();
        picture.set("width", shown.image.width);
        picture.set("height", shown.image.height);
        picture.set("rgba",
                    val::global("Uint8ClampedArray").new_(emscripten::typed_memory_view(rgba.size(), rgba.data())));
        picture.set("ev100", shown.exposure.value);
        picture.set("rendered", is_rendered);
        picture.set("scale", val::null());
        if (shown.scale) {
            val scale = val::object();
            scale.set("low", shown.scale->low);
            scale.set("high", shown.scale->high);
            scale.set("logarithmic", shown.scale->logarithmic);
            picture.set("scale", scale);
        }
        picture.set("lines", lines_of(shown, request));
        picture.set("diagnostics", wasm::to_js(diagnostics));
        return picture;
    }

    // The files are no longer what they were.
    void forget() {
        profiles_.clear();
        lights_.clear();
        last_.reset();
    }

    // {illuminance_lx, luminance_nt} of a pixel of the last picture; null outside of it.
    val at(int column, int row) const {
        if (column < 0 || row < 0 || column >= luminance_nt_.width || row >= luminance_nt_.height) return val::null();
        const float* const rgb = luminance_nt_.at(column, row);
        const glm::dvec3 nt(rgb[0], rgb[1], rgb[2]);
        val values = val::object();
        values.set("illuminance_lx", static_cast<double>(*illuminance_lx_.at(column, row)));
        values.set("luminance_nt", glm::dot(nt, rec709_luminance));
        return values;
    }

private:
    // A picture as it was rendered, and its lights.
    struct Last {
        std::vector<Light> lights;
        Rendering rendering;
    };

    // What follows from the last picture that was rendered, where nothing but amounts and colours of lights is another.
    std::optional<Rendering> from_the_last(std::span<const Light> lights, bool are_same,
                                           const RenderOptions& options) const {
        if (!last_) return std::nullopt;
        if (!options.sky.is_dark()) return are_same ? std::optional(last_->rendering) : std::nullopt;
        if (!differ_in_amount_alone(last_->lights, lights)) return std::nullopt;
        return relit(last_->rendering, last_->lights, lights);
    }

    Rendering rendered(PreviewRequest& request, const std::vector<Light>& lights) {
        RenderOptions& options = request.render;
        options.illuminance = true;
        options.known = known_;
        const PictureMethod method = method_of(options);
        if (Result<void> ready = prepare(options, {&method, 1}, request.stage, lights, request.probe_at); !ready)
            wasm::throw_js(ready.error());
        Rendering rendering = value_of(gonio::render(request.stage, lights, request.stage.camera, options));
        if (rendering.indirect) known_ = rendering.indirect;
        last_ = Last{lights, rendering};
        return rendering;
    }

    detail::KeptProfiles profiles_;
    std::vector<Light> lights_;
    std::optional<Last> last_;
    std::shared_ptr<const Interreflection> known_;
    Image luminance_nt_;
    Image illuminance_lx_;
};

} // namespace

EMSCRIPTEN_BINDINGS(gonio_live_preview) {
    emscripten::class_<LivePreview>("LivePreview")
        .constructor<>()
        .function("render", &LivePreview::render)
        .function("at", &LivePreview::at)
        .function("forget", &LivePreview::forget);
}

} // namespace gonio::cli
