#include "contact_sheet.hpp"

#include <gonio/base/picture_size.hpp>

#include "../options/output.hpp"
#include "picture.hpp"

#include <fmt/format.h>

#include <charconv>

namespace gonio::cli {

Result<void> no_sheet_options(const Arguments& arguments) {
    for (const Option& option : contact_sheet_options)
        if (arguments.has(option.names))
            return fail("USE0107", fmt::format("{} is only for sheets", option.names),
                        "add --sheet, --compare or --sweep");
    return {};
}

Result<SheetOptions> read_sheet_options(const Arguments& arguments, const PreviewRequest& request, PixelSize usual) {
    SheetOptions options;
    options.title = arguments.value("--title").value_or("");
    const bool sized = arguments.has("--size");
    options.picture_width_px = sized ? request.render.width : usual.width;
    options.picture_height_px = sized ? request.render.height : usual.height;
    if (options.picture_width_px < 32 || options.picture_height_px < 32 || options.picture_width_px > 2048 ||
        options.picture_height_px > 2048)
        return fail(
            "USE0106", "the picture of a tile must be 32 to 2048 pixels wide and high",
            fmt::format("-s is the size of the picture in each tile, for example {}x{}", usual.width, usual.height));
    if (const auto text = arguments.value("--columns")) {
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), options.columns);
        if (error != std::errc() || end != text->data() + text->size() || options.columns < 1)
            return fail("USE0105", fmt::format("--columns takes a number of 1 or more, not '{}'", *text));
    }
    return options;
}

Result<void> holds_sheets(const media::ImageFormat& format, std::string_view hint) {
    if (has_pixel(format, media::Pixel::uint8) && !has_pixel(format, media::Pixel::float32)) return {};
    return fail("USE0107", fmt::format("{} is for light, not for sheets", format.title), std::string(hint));
}

Result<void> fits_sheet(std::size_t tiles, const SheetOptions& options, std::string_view what) {
    const SheetLayout layout = layout_of(tiles, options);
    Result<void> fits = check_picture_size(layout.width_px, layout.height_px, limit("picture-side"),
                                           fmt::format("{} {}: a sheet", tiles, what));
    if (!fits) error_hint(fits.error(), "use a smaller -s, or make several sheets");
    return fits;
}

Result<void> develop_tiles(std::vector<SheetTile>& tiles, std::vector<TileScene> scenes, const PreviewRequest& request,
                           const Console& console) {
    std::vector<ExposedPicture> pictures;
    for (std::size_t i = 0; i < tiles.size(); ++i)
        pictures.push_back({&tiles[i].picture, std::move(scenes[i].lights), scenes[i].camera});
    return show_exposed(pictures, request, console);
}

} // namespace gonio::cli
