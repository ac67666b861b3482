#include <gonio/base/codes/result.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/text.hpp>
#include <gonio/media/detail/color_config.hpp>
#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/display.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace gonio::media {

namespace {

// The built-in configuration's name for the space of gonio's pixels; other configurations use it, or one of these.
constexpr std::array<std::string_view, 7> rec709_names{"lin_rec709",
                                                       "lin_rec709_scene",
                                                       "lin_srgb",
                                                       "Linear Rec.709 (sRGB)",
                                                       "Linear Rec.709",
                                                       "Utility - Linear - sRGB",
                                                       "Utility - Linear - Rec.709"};

constexpr const char* rec709 = "lin_rec709";
using detail::Config;
using detail::interchange;
using detail::Processor;
using detail::space_processor;
using detail::unknown;

// An exact name, else the one name that differs only in case.
std::optional<std::string> match(const std::string& name, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return name;
    for (const std::string& other : known)
        if (equals_any_case(name, other)) return other;
    return std::nullopt;
}

struct Entrance {
    std::string space;
    bool from_aces = false; // the pixels must be brought to ACES2065-1 first
};

Result<Entrance> entrance(const Config& config, const DisplayOptions& options, Diagnostics& diagnostics) {
    if (!options.source.empty()) {
        if (!config.has_space(options.source)) return unknown("colour space", options.source, config.spaces());
        return Entrance{options.source, false};
    }
    if (options.config.empty()) return Entrance{rec709, false};
    if (config.has_space(interchange)) return Entrance{interchange, true};
    for (const std::string_view name : rec709_names)
        if (config.has_space(name)) return Entrance{std::string(name), false};
    if (!config.has_space("scene_linear"))
        return fail(Failure::unsupported, "the colour configuration has neither aces_interchange nor scene_linear",
                    "name its linear Rec.709 space as the source", options.config);
    diagnostics.push_back(
        result_diagnostic("RES0107",
                          "the colour configuration has no role aces_interchange: linear Rec.709 pixels are taken for "
                          "its scene_linear",
                          "name its linear Rec.709 space as the source", options.config));
    return Entrance{"scene_linear", false};
}

// Applies each processor in turn, row by row.
Result<void> apply_rows(Image& image, const std::vector<const Processor*>& processors, unsigned threads) {
    std::mutex mutex;
    std::optional<Error> failure;
    const auto width = static_cast<std::size_t>(image.width);
    parallel_for(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
        for (const Processor* const processor : processors) {
            Result<void> applied = processor->apply(image.at(0, static_cast<int>(row)), width, image.channels);
            if (applied) continue;
            const std::scoped_lock lock(mutex);
            if (!failure) failure = std::move(applied.error());
            return;
        }
    });
    if (failure) return Unexpected(std::move(*failure));
    return {};
}

} // namespace

Result<DisplayUsed> apply_display(Image& image, const DisplayOptions& options) {
    Image* const images[] = {&image};
    return apply_display(images, options);
}

Result<DisplayUsed> apply_display(std::span<Image* const> images, const DisplayOptions& options) {
    for (const Image* const image : images) {
        if (image->channels != 3 && image->channels != 4)
            return fail("USE0106", fmt::format("a picture of {} channels has no display colours", image->channels),
                        "the picture must be RGB or RGBA");
        if (image->pixels.size() != image->index(0, image->height))
            return fail(Failure::internal, "the picture's buffer is not of the picture's size");
    }
    Result<Config> config = Config::open(options.config);
    if (!config) return pass_on(config);

    DisplayUsed used;
    Result<Entrance> enter = entrance(*config, options, used.diagnostics);
    if (!enter) return pass_on(enter);
    used.source = enter->space;
    used.display = options.display.empty() ? config->default_display() : options.display;
    const std::vector<std::string> displays = config->displays();
    const std::optional<std::string> display = match(used.display, displays);
    if (!display) return unknown("display", used.display, displays);
    used.display = *display;
    used.view = options.view.empty() ? config->default_view(used.display) : options.view;
    const std::vector<std::string> views = config->views(used.display);
    const std::optional<std::string> view = match(used.view, views);
    if (!view) return unknown("view", used.view, views);
    used.view = *view;

    std::array<char, abi::message_bytes> message{};
    abi::ColorProcessor* handle = nullptr;
    if (const int status = config->module().display_processor(config->get(), used.source.c_str(), used.display.c_str(),
                                                              used.view.c_str(), &handle, message.data());
        status != 0)
        return fail(detail::cause_of(status), fmt::format("no transform to the view '{}' of the display '{}': {}",
                                                          used.view, used.display, message.data()));
    const Processor to_display(config->module(), handle);

    std::vector<const Processor*> chain{&to_display};
    std::optional<Processor> to_aces;
    if (enter->from_aces) {
        Result<Config> own = Config::open({});
        if (!own) return pass_on(own);
        Result<abi::ColorProcessor*> first = space_processor(*own, rec709, interchange);
        if (!first) return pass_on(first);
        to_aces.emplace(own->module(), *first);
        chain.insert(chain.begin(), &*to_aces);
    }
    for (Image* const image : images)
        if (Result<void> applied = apply_rows(*image, chain, options.threads); !applied) return pass_on(applied);
    return used;
}

Result<std::vector<Display>> list_displays(const std::string& path) {
    Result<Config> config = Config::open(path);
    if (!config) return pass_on(config);
    const auto move_to_front = [](std::vector<std::string>& names, const std::string& first) {
        const auto found = std::find(names.begin(), names.end(), first);
        if (found != names.end()) std::rotate(names.begin(), found, found + 1);
    };
    std::vector<std::string> names = config->displays();
    move_to_front(names, config->default_display());
    std::vector<Display> displays;
    for (const std::string& name : names) {
        Display display{name, config->views(name)};
        move_to_front(display.views, config->default_view(name));
        displays.push_back(std::move(display));
    }
    return displays;
}

Result<std::vector<std::string>> list_spaces(const std::string& path) {
    Result<Config> config = Config::open(path);
    if (!config) return pass_on(config);
    return config->spaces();
}

Result<void> convert_space(std::span<float> rgb, const std::string& from, const std::string& to,
                           const std::string& path) {
    if (rgb.size() % 3 != 0) return fail("USE0105", "the number of values must be a multiple of three");
    Result<Config> config = Config::open(path);
    if (!config) return pass_on(config);
    Result<abi::ColorProcessor*> handle = space_processor(*config, from, to);
    if (!handle) return pass_on(handle);
    const Processor processor(config->module(), *handle);
    if (rgb.empty()) return {};
    return processor.apply(rgb.data(), rgb.size() / 3, 3);
}

} // namespace gonio::media
