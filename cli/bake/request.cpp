#include "request.hpp"

#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace gonio::cli {

namespace {

Result<int> parse_texels(const std::string& text, const char* option) {
    const std::optional<double> number = parse_number(text);
    if (!number || *number != std::floor(*number) || *number < 0.0 || *number > max_texture_size)
        return fail("USE0105", fmt::format("{} takes a number of texels, not '{}'", option, text));
    return static_cast<int>(*number);
}

// The options of the gnomonic layout; the other layouts refuse them.
Result<void> parse_plane(const Arguments& arguments, BakeOptions& bake) {
    for (const char* option : {"--cone", "--border"})
        if (arguments.value(option) && bake.layout != Layout::gnomonic)
            return fail("USE0107", fmt::format("{} is only for the layout gnomonic", option), "add --layout gnomonic");
    if (const auto text = arguments.value("--cone")) {
        Result<double> cone = parse_amount(*text, Dimension::angle, "--cone");
        if (!cone) return pass_on(cone);
        bake.chart.cone = Radians(*cone);
    }
    if (const auto text = arguments.value("--border")) {
        Result<int> border = parse_texels(*text, "--border");
        if (!border) return pass_on(border);
        bake.chart.border = *border;
    }
    return {};
}

Result<ErrorLimit> parse_limit(const std::string& text) {
    if (text.ends_with('%')) {
        const std::optional<double> percent = parse_number(text.substr(0, text.size() - 1));
        if (percent && *percent > 0.0) return ErrorLimit{*percent / 100.0, true};
    } else if (const Result<double> candela = parse_amount(text, Dimension::luminous_intensity, "--max-error");
               candela && *candela > 0.0) {
        return ErrorLimit{*candela, false};
    }
    return fail("USE0105", fmt::format("--max-error takes an intensity or a share of the peak, not '{}'", text),
                "for example 5cd or 1%");
}

Result<void> parse_extent(const Arguments& arguments, BakeRequest& request) {
    BakeOptions& bake = request.bake;
    const std::optional<std::string> text = arguments.value("--size");
    const std::optional<std::string> limit = arguments.value("--max-error");
    const bool automatic = text && *text == "auto";
    if (automatic != limit.has_value())
        return automatic ? fail("USE0104", "-s auto needs an error limit", "add --max-error 1% or --max-error 5cd")
                         : fail("USE0107", "--max-error is only for -s auto", "add -s auto");
    if (automatic) {
        if (bake.sampling != Sampling::mean)
            return fail("USE0107", "-s auto is only for textures of means, but this engine reads samples");
        Result<ErrorLimit> parsed = parse_limit(*limit);
        if (!parsed) return pass_on(parsed);
        request.max_error = *parsed;
    } else if (text) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        bake.width = size->width;
        bake.height = size->height;
        if (bake.layout == Layout::cube) {
            if (size->width != size->height)
                return fail("USE0105", fmt::format("a face of a cube is square, not {}", *text),
                            "for example -s 128x128");
            bake.width = size->width <= max_texture_size ? 6 * size->width : size->width;
        }
    }
    return {};
}

Result<void> parse_storage(const Arguments& arguments, BakeRequest& request) {
    if (const auto text = arguments.value("--normalize")) {
        Result<Normalization> normalization = parse_normalization(*text);
        if (!normalization) return pass_on(normalization);
        request.bake.normalization = *normalization;
    }
    if (const auto text = arguments.value("--pixel")) {
        const auto named = [](media::Pixel pixel) { return Named<media::Pixel>{media::to_text(pixel), pixel}; };
        const std::array pixels{named(media::Pixel::float32), named(media::Pixel::half), named(media::Pixel::uint16),
                                named(media::Pixel::uint8)};
        Result<media::Pixel> pixel = find_value("pixel", *text, pixels);
        if (!pixel) return pass_on(pixel);
        request.pixel = *pixel;
    } else if (request.engine != nullptr) {
        constexpr std::array pixels{media::Pixel::float32, media::Pixel::half, media::Pixel::uint16,
                                    media::Pixel::uint8};
        request.pixel = pixels[static_cast<std::size_t>(request.bake.texel_type)];
    }
    if (request.bake.transfer == Transfer::srgb && request.bake.normalization != Normalization::peak)
        return fail("USE0107", "this engine's texture holds values from 0 to 1 only", "leave --normalize out");
    return {};
}

// The engines of --engine; a null pointer without it.
Result<std::vector<const Engine*>> parse_engines(const Arguments& arguments) {
    const auto names = arguments.value("--engine");
    if (!names) return std::vector<const Engine*>{nullptr};
    if (arguments.value("--layout"))
        return fail("USE0107", "--layout and --engine are both given",
                    "an engine sets the layout; leave one of them out");
    Result<std::vector<const Engine*>> chosen = find_all_named("engine", *names, engines(), "all");
    if (!chosen || chosen->size() == 1) return chosen;
    for (const auto& [option, written] :
         {std::pair{"--output", "-o"}, {"--sidecar", "--sidecar"}, {"--manifest", "--manifest"}})
        if (arguments.value(option))
            return fail("USE0107", fmt::format("{} names one file, but there are {} engines", written, chosen->size()),
                        "use -O DIR, where each engine gets a folder; or name one engine");
    return chosen;
}

Result<BakeRequest> parse_bake(const Arguments& arguments, const Engine* engine) {
    BakeRequest request;
    request.engine = engine;
    if (engine != nullptr) {
        request.bake = engine->bake;
    } else {
        Result<Layout> layout = parse_layout(arguments.value("--layout").value_or("latlong"));
        if (!layout) return pass_on(layout);
        request.bake.layout = *layout;
        const TextureSize usual = usual_size(*layout);
        request.bake.width = usual.width;
        request.bake.height = usual.height;
    }
    if (Result<void> plane = parse_plane(arguments, request.bake); !plane) return pass_on(plane);
    if (Result<void> extent = parse_extent(arguments, request); !extent) return pass_on(extent);
    if (Result<void> storage = parse_storage(arguments, request); !storage) return pass_on(storage);
    Result<Catalogue> catalogue = catalogue_of(arguments);
    if (!catalogue) return pass_on(catalogue);
    request.catalogue = std::move(*catalogue);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.bake.threads = *threads;
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    input->photometric = true;
    request.input = *input;
    request.sidecar = arguments.value("--sidecar");
    request.no_sidecar = arguments.has("--no-sidecar");
    request.stats = arguments.has("--stats");
    request.update = arguments.has("--update");
    request.bake.skip = !arguments.has("--no-skip");
    return request;
}

} // namespace

Result<std::vector<BakeRequest>> parse_bake(const Arguments& arguments) {
    const Result<std::vector<const Engine*>> chosen = parse_engines(arguments);
    if (!chosen) return Unexpected(chosen.error());
    std::vector<BakeRequest> requests;
    for (const Engine* engine : *chosen) {
        Result<BakeRequest> request = parse_bake(arguments, engine);
        if (!request) {
            if (chosen->size() > 1)
                error_hint(request.error(), fmt::format("this is about the engine {}", engine->name));
            return pass_on(request);
        }
        if (chosen->size() > 1) request->subfolder = engine->name;
        requests.push_back(std::move(*request));
    }
    return requests;
}

} // namespace gonio::cli
