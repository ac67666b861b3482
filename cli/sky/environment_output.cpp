#include "environment_output.hpp"

#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/sky/environment_resample.hpp>

#include "../options/output.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gonio::cli {

Result<EnvironmentGrid> environment_of_side(EnvironmentLayout layout, int side, const std::string& option) {
    Result<EnvironmentGrid> grid = environment_grid(layout, side);
    if (grid) return grid;
    const Diagnostic& reason = grid.error().diagnostics.back();
    return fail("USE0106", fmt::format("{}: {}", option, reason.message), reason.hint);
}

Result<EnvironmentGrid> environment_size(EnvironmentLayout layout, const std::string& size) {
    const EnvironmentLayoutInfo& info = info_of(layout);
    if (size.find('x') != std::string::npos) {
        Result<PixelSize> whole = parse_size(size);
        if (!whole) return pass_on(whole);
        Result<EnvironmentGrid> grid = EnvironmentGrid::create(layout, whole->width, whole->height);
        if (!grid)
            return fail("USE0106", fmt::format("the layout {} has no images of {} pixels", info.name, size),
                        fmt::format("it is {}:{}, for example {}x{}", info.across, info.down, 256 * info.across,
                                    256 * info.down));
        return environment_of_side(layout, grid->side(), "--size " + size);
    }
    Result<std::uint64_t> number = whole_number(size, "--size");
    if (!number) return pass_on(number);
    const auto most = std::uint64_t{limit("environment-values").value};
    const std::uint64_t sides = layout == EnvironmentLayout::latlong ? 2 : 1;
    if (*number % sides != 0) return fail("USE0106", fmt::format("the width of a latlong is even, not {}", *number));
    return environment_of_side(layout, static_cast<int>(std::min(*number / sides, most)), "--size " + size);
}

Result<EnvironmentStorage> environment_storage(const Arguments& arguments, const std::string& output) {
    Result<const media::ImageFormat*> format = picture_format(arguments.value("--to"), output);
    if (!format) return pass_on(format);
    if (!has_pixel(**format, media::Pixel::float32))
        return fail("USE0107", fmt::format("{} holds values for a display, not light", (*format)->title),
                    "write .exr, .hdr or .tif");
    constexpr std::array kinds{Named{"float", media::Pixel::float32}, Named{"half", media::Pixel::half}};
    Result<media::Pixel> pixel = find_value("pixel type", arguments.value("--pixel").value_or("float"), kinds);
    if (!pixel) return pass_on(pixel);
    if (!has_pixel(**format, *pixel))
        return fail("USE0107", fmt::format("{} cannot store {} pixels", (*format)->title, media::to_text(*pixel)),
                    "write .exr for half");
    return EnvironmentStorage{*format, *pixel};
}

Result<EnvironmentLayout> output_layout(const Arguments& arguments, EnvironmentLayout otherwise) {
    const auto named = arguments.value("--layout");
    return named ? parse_environment_layout(*named) : otherwise;
}

Result<std::optional<std::string>> sidecar_file(const Arguments& arguments, const std::string& usual) {
    const auto named = arguments.value("--sidecar");
    if (named && arguments.has("--no-sidecar"))
        return fail("USE0107", "--sidecar and --no-sidecar contradict each other", "leave one of them out");
    if (named) return named;
    return usual.empty() || arguments.has("--no-sidecar") ? std::nullopt : std::optional(usual);
}

Result<bool> with_sun_in_pixels(const Arguments& arguments, const LoadedSky& loaded, const SkyRequest& request) {
    const bool with_the_sun = arguments.has("--with-sun");
    if (with_the_sun && (request.cut_sun || !loaded.sun))
        return fail("USE0107",
                    request.cut_sun ? std::string("--cut-sun and --with-sun contradict each other")
                                    : fmt::format("'{}' has no sun beside it", loaded.kind),
                    "--with-sun is for daylight that is not overcast");
    return with_the_sun;
}

double nits_per_unit(const EnvironmentMap& map, media::Pixel pixel) {
    if (pixel != media::Pixel::half) return 1.0;
    constexpr double largest_half = 65504.0;
    const std::vector<float>& values = map.image().pixels;
    const double most = static_cast<double>(*std::max_element(values.begin(), values.end())) * map.nits_per_unit();
    return most > largest_half ? std::exp2(std::ceil(std::log2(most / largest_half))) : 1.0;
}

} // namespace gonio::cli
