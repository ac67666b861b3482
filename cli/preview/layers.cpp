#include "layers.hpp"

#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/media/layers.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/preview/picture_parts.hpp>

#include "../json_text.hpp"
#include "../options/output.hpp"
#include "../progress.hpp"
#include "contact_sheet.hpp"
#include "picture.hpp"
#include "request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 8> own_names{"emission", "diffuse", "specular",        "direct",
                                                    "indirect", "sky",     "illuminance-sky", "illuminance"};

struct LayerChoice {
    bool lights = false;
    bool parts = false;
    bool direct = false;
    bool indirect = false;
    bool illuminance = false;

    // A sky counts as a light.
    std::size_t channels(std::size_t light_count) const {
        const std::size_t each = lights ? (illuminance ? 4U : 3U) : 0U;
        return 3U + (parts ? 9U : 0U) + (direct ? 3U : 0U) + (indirect ? 3U : 0U) + (illuminance ? 1U : 0U) +
               each * light_count;
    }
};

Result<LayerChoice> read_choice(std::string_view text) {
    LayerChoice choice;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        const std::string_view name = text.substr(0, comma);
        if (name == "lights") {
            choice.lights = true;
        } else if (name == "parts") {
            choice.parts = true;
        } else if (name == "direct") {
            choice.direct = true;
        } else if (name == "indirect") {
            choice.indirect = true;
        } else if (name == "illuminance") {
            choice.illuminance = true;
        } else {
            return unknown_name("layers", name, names_of(layer_kinds));
        }
        more = comma != std::string_view::npos;
        if (more) text.remove_prefix(comma + 1);
    }
    return choice;
}

Result<void> fits_layers(const Arguments& arguments, const PreviewRequest& request) {
    std::vector<std::string_view> others(several_pictures.begin(), several_pictures.end());
    others.insert(others.end(), {"--ticks", "--stats"});
    for (const std::string_view option : others)
        if (option != "--aov" && arguments.has(option))
            return fail("USE0107", fmt::format("--aov and {} are both given", option), "make a picture of each");
    if (request.format->name != "exr")
        return fail("USE0107", fmt::format("{} cannot hold layers", request.format->title),
                    "write .exr, or leave --aov out");
    if (request.look.look != Look::beauty)
        return fail("USE0107", "layers need the display mode beauty",
                    "leave --look out; --aov illuminance has the lux");
    if (request.exposure.tone_map != ToneMap::none)
        return fail("USE0107", "layers add up as light, before any tone map", "leave --tone-map out");
    return no_sheet_options(arguments);
}

// Space for all layers, before anything is rendered; the error names how many lights fit at this size.
Result<media::LayeredImage> room_for(const LayerChoice& choice, const PreviewRequest& request, std::size_t lights) {
    const RenderOptions& size = request.render;
    Result<media::LayeredImage> layered = media::LayeredImage::create(size.width, size.height, choice.channels(lights));
    if (layered || !choice.lights) return layered;
    const std::size_t channels =
        media::max_layered_values / (static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    const std::size_t others = choice.channels(0);
    const std::size_t most = channels > others ? (channels - others) / (choice.channels(1) - others) : 0;
    return fail(
        Failure::unsupported,
        fmt::format("{} lights have too many layers at {}x{} pixels: {} fit", lights, size.width, size.height, most),
        "use a smaller -s, or a rig with fewer lights");
}

double mean_of(const Image& image) {
    return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0) / static_cast<double>(image.pixels.size());
}

class LayerMaker {
public:
    LayerMaker(const PreviewRequest& request, std::span<const Light> lights, const LayerChoice& choice,
               const Console& console)
        : request_(request), lights_(lights), choice_(choice), console_(console) {}

    Result<std::string> make(Diagnostics& diagnostics) {
        RenderOptions options = request_.render;
        options.illuminance = choice_.illuminance;
        if (Result<void> begun = begin(options); !begun) return pass_on(begun);
        Result<Rendering> all = render(request_.stage, lights_, request_.stage.camera, options);
        if (!all) return pass_on(all);
        warn_of_ceiling(all->luminance_nt, diagnostics);
        exposure_ = request_.exposure.of(*all, options.threads);
        layered_.add("", all->luminance_nt);
        if (choice_.illuminance) add_lux("illuminance", all->illuminance_lx, "");
        options.known = all->indirect;
        if (Result<void> added = add_parts(all->luminance_nt, options); !added) return pass_on(added);
        if (Result<void> added = add_bounces(all->luminance_nt, options); !added) return pass_on(added);
        *all = {};
        if (Result<void> added = add_lights(options, diagnostics); !added) return pass_on(added);
        return layered_.encode({{"gonio:unit", std::string("cd/m2")},
                                {"gonio:exposure_ev100", std::vector<float>{static_cast<float>(exposure_.value)}}},
                               options.threads);
    }

    Ev100 exposure() const { return exposure_; }
    const Json& layers_json() const { return layers_; }

private:
    // First renders what belongs to no light, because the number of layers depends on it.
    Result<void> begin(const RenderOptions& options) {
        if (choice_.lights) {
            Result<Rendering> unlit = render_unlit(request_.stage, lights_, request_.stage.camera, options);
            if (!unlit) return pass_on(unlit);
            unlit_ = std::move(*unlit);
        }
        const std::vector<float>& nt = unlit_.luminance_nt.pixels;
        has_sky_ = std::any_of(nt.begin(), nt.end(), [](float value) { return value > 0.0F; });
        Result<media::LayeredImage> layered = room_for(choice_, request_, lights_.size() + (has_sky_ ? 1 : 0));
        if (!layered) return pass_on(layered);
        layered_ = std::move(*layered);
        return {};
    }

    void add_light(const std::string& layer, const Rendering& rendering, const std::string& light) {
        layered_.add(layer, rendering.luminance_nt);
        Json entry{{"layer", layer}};
        if (!light.empty()) entry["light"] = light;
        entry["mean_nt"] = mean_of(quantity_image(rendering, PictureQuantity::luminance));
        layers_.push_back(std::move(entry));
    }

    void add_lux(const std::string& layer, const Image& lux, const std::string& light) {
        layered_.add(layer, lux);
        Json entry{{"layer", layer}};
        if (!light.empty()) entry["light"] = light;
        entry["mean_lx"] = mean_of(lux);
        layers_.push_back(std::move(entry));
    }

    Result<void> add_parts(const Image& picture, const RenderOptions& options) {
        if (!choice_.parts) return {};
        Result<PictureParts> parts = picture_parts(picture, request_.stage, lights_, request_.stage.camera, options);
        if (!parts) return pass_on(parts);
        const std::array<const Image*, 3> images{&parts->emission_nt, &parts->diffuse_nt, &parts->specular_nt};
        for (std::size_t i = 0; i < images.size(); ++i)
            add_own(own_names.at(i), *images.at(i));
        return {};
    }

    void add_own(std::string_view name, const Image& nt) {
        Rendering part;
        part.luminance_nt = nt;
        layered_.add(std::string(name), nt);
        layers_.push_back({{"layer", name}, {"mean_nt", mean_of(quantity_image(part, PictureQuantity::luminance))}});
    }

    Result<void> add_bounces(const Image& picture, const RenderOptions& options) {
        if (!choice_.direct && !choice_.indirect) return {};
        RenderOptions without = options;
        without.bounces = 0;
        without.illuminance = false;
        Result<Rendering> direct = render(request_.stage, lights_, request_.stage.camera, without);
        if (!direct) return pass_on(direct);
        if (choice_.direct) add_own("direct", direct->luminance_nt);
        if (!choice_.indirect) return {};
        Image indirect = picture;
        for (std::size_t i = 0; i < indirect.pixels.size(); ++i)
            indirect.pixels[i] -= direct->luminance_nt.pixels[i];
        add_own("indirect", indirect);
        return {};
    }

    Result<void> add_lights(const RenderOptions& options, Diagnostics& diagnostics) {
        if (!choice_.lights) return {};
        std::vector<std::string> wanted;
        for (const Light& light : lights_)
            wanted.push_back(light.name);
        const std::vector<std::string> names = media::layer_names(wanted, own_names, diagnostics);
        std::vector<std::string> lux_names;
        if (choice_.illuminance) {
            wanted.clear();
            for (const std::string& name : names)
                wanted.push_back("illuminance-" + name);
            std::vector<std::string_view> taken(names.begin(), names.end());
            taken.insert(taken.end(), own_names.begin(), own_names.end());
            Diagnostics obvious; // the same as for the light's own layer
            lux_names = media::layer_names(wanted, taken, obvious);
        }
        if (has_sky_) {
            add_light("sky", unlit_, "");
            if (choice_.illuminance) add_lux("illuminance-sky", unlit_.illuminance_lx, "");
        }
        Progress progress(lights_.size(), console_.shows_progress());
        Result<void> added = render_each_light(request_.stage, lights_, request_.stage.camera, options, unlit_,
                                               [&](std::size_t i, const Rendering& share) {
                                                   progress.show(i, names[i]);
                                                   add_light(names[i], share, lights_[i].name);
                                                   if (choice_.illuminance)
                                                       add_lux(lux_names[i], share.illuminance_lx, lights_[i].name);
                                                   return Result<void>();
                                               });
        progress.clear();
        return added;
    }

    const PreviewRequest& request_;
    std::span<const Light> lights_;
    LayerChoice choice_;
    media::LayeredImage layered_;
    const Console& console_;
    Rendering unlit_;
    bool has_sky_ = false;
    Ev100 exposure_;
    Json layers_ = Json::array();
};

} // namespace

Result<int> preview_layers(const Arguments& arguments, Console& console) {
    Result<LayerChoice> choice = read_choice(*arguments.value("--aov"));
    if (!choice) return pass_on(choice);
    Result<PreviewRequest> request = parse_preview(arguments);
    if (!request) return pass_on(request);
    Result<void> fine = fits_layers(arguments, *request);
    if (!fine) return Unexpected(fine.error());
    if (Result<media::LayeredImage> room = room_for(*choice, *request, request->lights.rig.lights.size()); !room)
        return pass_on(room);
    Diagnostics diagnostics = request->diagnostics;
    Result<std::vector<Light>> lights = resolve_input(request->lights, diagnostics, request->render.threads);
    if (!lights) return pass_on(lights);
    console.say(diagnostics);
    if (arguments.has("--dry-run")) {
        console.print(fmt::format("{}\n", request->output));
        return 0;
    }
    Diagnostics renamed;
    LayerMaker maker(*request, *lights, *choice, console);
    Result<std::string> bytes = maker.make(renamed);
    if (!bytes) return pass_on(bytes);
    console.say(renamed);
    diagnostics.insert(diagnostics.end(), renamed.begin(), renamed.end());
    fine = write_output(request->output, *bytes);
    if (!fine) return Unexpected(fine.error());
    if (!arguments.has("--json") && !arguments.has("--jsonl")) return 0;
    Json report{{"schema", "gonio.preview/1"},
                {"output", request->output},
                {"width", request->render.width},
                {"height", request->render.height},
                {"stage", request->stage.name},
                {"exposure_ev100", maker.exposure().value},
                {"method", to_text(method_of(request->render))},
                {"layers", maker.layers_json()},
                {"lights", lights->size()},
                {"diagnostics", diagnostics_json(diagnostics)}};
    console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    return 0;
}

} // namespace gonio::cli
