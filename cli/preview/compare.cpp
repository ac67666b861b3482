#include "compare.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/measure/picture_error.hpp>
#include <gonio/media/layers.hpp>
#include <gonio/plot/legend.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/plot/palette.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/glare.hpp>

#include "../json_text.hpp"
#include "../options/output.hpp"
#include "../progress.hpp"
#include "contact_sheet.hpp"
#include "request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr PixelSize usual_size{320, 240};
constexpr int columns = 3; // the first method, another one, their difference
constexpr std::size_t ramp_colors = 129;
constexpr std::size_t most_methods = limit("compared-methods").value;

struct Compared {
    PictureMethod method;
    Image rgb_nt;
    Image nt;
    Image difference_nt; // from the first method; empty for the first
    std::vector<PartialLight> partial_lights;
    measure::PictureError error;
};

struct Comparison {
    std::vector<Compared> methods; // first the one that the others are measured against
    Ev100 exposure;                // of the first method
    ValueScale scale;              // of all differences, symmetric about 0
    ScaleUse use;
};

std::string name_of(const Compared& compared) {
    return std::string(to_text(compared.method));
}

std::string percent(double share) {
    return fmt::format("{} %", rounded(100.0 * share, 3));
}

Image difference(const Image& values, const Image& truth) {
    Image result(values.width, values.height, values.channels);
    std::transform(values.pixels.begin(), values.pixels.end(), truth.pixels.begin(), result.pixels.begin(),
                   [](float value, float true_value) { return value - true_value; });
    return result;
}

// Round limits that contain 98 of 100 differences of all methods, so that one missed highlight does not use up the
// colour range.
void scale_differences(Comparison& comparison) {
    Image sizes;
    sizes.channels = 1;
    for (const Compared& compared : comparison.methods)
        for (const float value : compared.difference_nt.pixels)
            if (value != 0.0F) sizes.pixels.push_back(std::abs(value));
    const auto all = static_cast<double>(sizes.pixels.size());
    const auto kept = sizes.pixels.begin() + static_cast<std::ptrdiff_t>(sizes.pixels.size() * 98 / 100);
    std::nth_element(sizes.pixels.begin(), kept, sizes.pixels.end());
    sizes.pixels.erase(kept, sizes.pixels.end());
    const double end = round_scale(sizes, false).high;
    comparison.scale = {false, -end, end};
    for (const Compared& compared : comparison.methods)
        for (const float value : compared.difference_nt.pixels) {
            const auto nt = static_cast<double>(value);
            comparison.use.greatest = std::fmax(comparison.use.greatest, std::fabs(nt));
            if (nt > end) comparison.use.above_share += 1.0 / all;
            if (nt < -end) comparison.use.below_share += 1.0 / all;
        }
}

Result<Comparison> compare(const PreviewRequest& request, std::span<const Light> lights, const RenderOptions& size,
                           const Console& console, Diagnostics& diagnostics) {
    Comparison comparison;
    std::vector<std::uint8_t> shows_light;
    std::shared_ptr<const Interreflection> known;
    Progress progress(request.compared.size(), console.shows_progress());
    RenderOptions prepared = size;
    if (Result<void> ready = prepare(prepared, request.compared, request.stage, lights, request.probe_at); !ready)
        return pass_on(ready);
    for (const PictureMethod& method : request.compared) {
        progress.show(comparison.methods.size(), to_text(method));
        RenderOptions options = prepared;
        set_method(options, method);
        options.known = known;
        Result<Rendering> rendering = render(request.stage, lights, request.stage.camera, options);
        if (!rendering) return pass_on(rendering);
        if (rendering->stats.not_converged > 0)
            diagnostics.push_back(result_diagnostic(
                "RES0202", fmt::format("the requested error was not reached in {} evaluations of a light",
                                       rendering->stats.not_converged)));
        Compared compared;
        compared.method = method;
        compared.nt = quantity_image(*rendering, PictureQuantity::luminance);
        if (comparison.methods.empty()) {
            comparison.exposure = request.exposure.of(*rendering, request.render.threads);
            shows_light = rendering->shows_light;
        } else {
            const Image& truth = comparison.methods.front().nt;
            compared.difference_nt = difference(compared.nt, truth);
            compared.error = measure::picture_error(compared.nt, truth, shows_light);
        }
        compared.rgb_nt = std::move(rendering->luminance_nt);
        compared.partial_lights = std::move(rendering->partial_lights);
        comparison.methods.push_back(std::move(compared));
        known = std::move(rendering->indirect);
    }
    progress.clear();
    scale_differences(comparison);
    return comparison;
}

// All values as computed, with the first method also as the unnamed layer for programs that do not know layers.
Result<std::string> as_layers(const Comparison& comparison) {
    const Image& first = comparison.methods.front().rgb_nt;
    Result<media::LayeredImage> layered =
        media::LayeredImage::create(first.width, first.height, 3 + 6 * comparison.methods.size() - 3);
    if (!layered) return pass_on(layered);
    layered->add("", first);
    for (const Compared& compared : comparison.methods)
        layered->add(to_text(compared.method), compared.rgb_nt);
    for (const Compared& compared : comparison.methods)
        if (&compared != comparison.methods.data())
            layered->add(
                fmt::format("{}-minus-{}", to_text(compared.method), to_text(comparison.methods.front().method)),
                difference(compared.rgb_nt, first));
    return layered->encode(
        {{"gonio:unit", std::string("cd/m2")},
         {"gonio:exposure_ev100", std::vector<float>{static_cast<float>(comparison.exposure.value)}}});
}

std::vector<std::array<float, 3>> ramp() {
    std::vector<std::array<float, 3>> colors;
    for (std::size_t i = 0; i < ramp_colors; ++i)
        colors.push_back(diverging_palette().at(static_cast<double>(i) / (ramp_colors - 1)));
    return colors;
}

// A tile with its picture exposed, but not yet developed.
SheetTile tile_of(const Compared& compared, double mean_nt, const PreviewRequest& request,
                  std::span<const Light> lights, Ev100 exposure) {
    SheetTile tile;
    tile.name = name_of(compared);
    tile.facts = {fmt::format("mean {} cd/m²", rounded(mean_nt, 4))};
    tile.picture = compared.rgb_nt;
    if (request.exposure.glare) show_points(tile.picture, request.stage, lights, request.stage.camera);
    expose(tile.picture, exposure);
    return tile;
}

Result<std::string> as_sheet(const Comparison& comparison, const SheetOptions& options, const PreviewRequest& request,
                             std::span<const Light> shining, const Console& console) {
    const Compared& first = comparison.methods.front();
    std::vector<SheetTile> pictures;
    std::vector<TileScene> scenes;
    for (const Compared& compared : comparison.methods) {
        scenes.push_back({compared.partial_lights, request.stage.camera});
        expose(scenes.back().lights, comparison.exposure);
        const measure::PictureError& error = comparison.methods[std::max<std::size_t>(1, pictures.size())].error;
        pictures.push_back(tile_of(compared, pictures.empty() ? error.mean : error.mean + error.bias, request, shining,
                                   comparison.exposure));
    }
    if (Result<void> shown = develop_tiles(pictures, std::move(scenes), request, console); !shown)
        return pass_on(shown);
    std::vector<SheetTile> tiles;
    for (std::size_t i = 1; i < comparison.methods.size(); ++i) {
        const Compared& compared = comparison.methods[i];
        const measure::PictureError& error = compared.error;
        SheetTile off;
        off.name = fmt::format("{} − {}", name_of(compared), name_of(first));
        off.facts = {fmt::format("relative: median {}, 95 % {}", percent(error.of_pixels.relative.median),
                                 percent(error.of_pixels.relative.p95))};
        off.picture = false_color(compared.difference_nt, comparison.scale, diverging_palette());
        tiles.push_back(pictures.front());
        tiles.push_back(pictures[i]);
        tiles.push_back(std::move(off));
    }
    const Image together = sheet(tiles, options);
    if (!request.look.legend) return encode_for_display(together, *request.format, false);
    RampLegend legend;
    legend.scale = comparison.scale;
    legend.unit.symbol = "cd/m²";
    legend.ramp = ramp();
    legend.use = comparison.use;
    return encode_for_display(with_legend(together, legend), *request.format, false);
}

std::string error_text(const Compared& compared, const Compared& first) {
    const measure::PictureError& error = compared.error;
    if (error.pixels == 0) return fmt::format("{}: the picture shows only lights\n", name_of(compared));
    std::string text = fmt::format("{} against {}: luminance of {} pixels, mean {} cd/m2\n", name_of(compared),
                                   name_of(first), error.pixels, rounded(error.mean, 5));
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<18}{}\n", what, value);
    };
    if (!error.psnr_db) {
        line("no difference", "");
        text.erase(text.find_last_not_of(" \n") + 1);
        return text + "\n";
    }
    const auto of_mean = [&](double nt) {
        return error.mean > 0.0 ? fmt::format("{} cd/m2, {} of the mean", rounded(nt, 4), percent(nt / error.mean))
                                : fmt::format("{} cd/m2", rounded(nt, 4));
    };
    line("mean difference", of_mean(error.bias));
    line("mean |difference|", of_mean(error.mean_absolute));
    line("RMS", of_mean(error.rms));
    line("relative", fmt::format("mean {}, median {}, 95 % up to {}, max {}", percent(error.mean_relative),
                                 percent(error.of_pixels.relative.median), percent(error.of_pixels.relative.p95),
                                 percent(error.of_pixels.relative.max)));
    if (std::isfinite(*error.psnr_db)) line("PSNR", fmt::format("{:.1f} dB", *error.psnr_db));
    line("largest", fmt::format("{} cd/m2 at pixel {},{}: {} for {}", rounded(error.worst.value - error.worst.truth, 4),
                                error.worst.column, error.worst.row, rounded(error.worst.value, 4),
                                rounded(error.worst.truth, 4)));
    return text;
}

Json error_json(const Compared& compared) {
    const measure::PictureError& error = compared.error;
    Json json{{"method", to_text(compared.method)},
              {"pixels", error.pixels},
              {"identical", !error.psnr_db},
              {"mean_nt", error.mean + error.bias},
              {"mean_difference_nt", error.bias},
              {"mean_absolute_difference_nt", error.mean_absolute},
              {"rms_difference_nt", error.rms},
              {"relative",
               {{"mean", error.mean_relative},
                {"median", error.of_pixels.relative.median},
                {"p95", error.of_pixels.relative.p95},
                {"max", error.of_pixels.relative.max},
                {"pixels", error.of_pixels.relative.count}}}};
    if (error.psnr_db && std::isfinite(*error.psnr_db)) json["psnr_db"] = *error.psnr_db;
    json["largest"] = {{"difference_nt", error.worst.value - error.worst.truth},
                       {"column", error.worst.column},
                       {"row", error.worst.row},
                       {"value_nt", error.worst.value},
                       {"truth_nt", error.worst.truth}};
    return json;
}

Json comparison_json(const Comparison& comparison, const PreviewRequest& request, const RenderOptions& size,
                     std::size_t lights, const Diagnostics& diagnostics) {
    const Compared& first = comparison.methods.front();
    Json report{{"schema", "gonio.preview/1"},
                {"output", request.output},
                {"width", size.width},
                {"height", size.height},
                {"stage", request.stage.name},
                {"exposure_ev100", comparison.exposure.value},
                {"method", to_text(first.method)},
                {"mean_nt", comparison.methods[1].error.mean}};
    report["compared"] = Json::array();
    for (std::size_t i = 1; i < comparison.methods.size(); ++i)
        report["compared"].push_back(error_json(comparison.methods[i]));
    report["lights"] = lights;
    report["diagnostics"] = diagnostics_json(diagnostics);
    return report;
}

Result<void> fits_comparison(const Arguments& arguments, const PreviewRequest& request) {
    if (request.look.look != Look::beauty)
        return fail("USE0107", "a comparison uses the display mode beauty and shows differences in colour",
                    "leave --look out");
    for (const std::string_view option : {"--columns", "--ticks", "--stats"})
        if (arguments.has(option))
            return fail("USE0107", fmt::format("{} does not apply to a comparison", option), "leave it out");
    if (request.exposure.tone_map == ToneMap::ue3_inverse)
        return fail("USE0107", "--tone-map ue3-inverse does not apply to a comparison", "leave it out");
    if (request.compared.size() > most_methods)
        return fail("USE0106", fmt::format("{} methods are more than {}", request.compared.size(),
                                           to_text(limit("compared-methods"))));
    return {};
}

} // namespace

Result<int> preview_compare(const Arguments& arguments, Console& console) {
    Result<PreviewRequest> request = parse_preview(arguments);
    if (!request) return pass_on(request);
    Result<void> fine = fits_comparison(arguments, *request);
    if (!fine) return Unexpected(fine.error());
    const bool layers = request->format->name == "exr";
    RenderOptions size = request->render;
    SheetOptions options;
    if (!layers) {
        fine = holds_sheets(*request->format, "write .png or .jpg, or .exr for layers");
        if (!fine) return Unexpected(fine.error());
        Result<SheetOptions> read = read_sheet_options(arguments, *request, usual_size);
        if (!read) return pass_on(read);
        options = std::move(*read);
        options.columns = columns;
        options.polar = false;
        fine = fits_sheet(columns * (request->compared.size() - 1), options, "pictures");
        if (!fine) return Unexpected(fine.error());
        size.width = options.picture_width_px;
        size.height = options.picture_height_px;
    } else if (arguments.has("--title")) {
        return fail("USE0107", "layers have no title", "write .png, or leave --title out");
    }
    Diagnostics diagnostics = request->diagnostics;
    Result<std::vector<Light>> lights = resolve_input(request->lights, diagnostics, size.threads);
    if (!lights) return pass_on(lights);
    console.say(diagnostics);
    if (arguments.has("--dry-run")) {
        console.print(fmt::format("{}\n", request->output));
        return 0;
    }
    Diagnostics judged;
    Result<Comparison> comparison = compare(*request, *lights, size, console, judged);
    if (!comparison) return pass_on(comparison);
    console.say(judged);
    diagnostics.insert(diagnostics.end(), judged.begin(), judged.end());
    Result<std::string> bytes =
        layers ? as_layers(*comparison) : as_sheet(*comparison, options, *request, *lights, console);
    if (!bytes) return pass_on(bytes);
    fine = write_output(request->output, *bytes);
    if (!fine) return Unexpected(fine.error());
    if (arguments.has("--json") || arguments.has("--jsonl")) {
        console.print(dump(comparison_json(*comparison, *request, size, lights->size(), diagnostics),
                           arguments.has("--jsonl") ? -1 : 2));
        return 0;
    }
    std::string text;
    for (std::size_t i = 1; i < comparison->methods.size(); ++i)
        text += error_text(comparison->methods[i], comparison->methods.front());
    // If the picture goes to stdout, the figures go to stderr.
    if (request->output == "-")
        console.note(text);
    else
        console.print(text);
    return 0;
}

} // namespace gonio::cli
