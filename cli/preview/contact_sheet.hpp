// Shared by all sheets of `gonio preview`: the size of the tiles, their display transform, the file.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/legend.hpp>
#include <gonio/plot/sheet.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/values.hpp"
#include "request.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

inline constexpr std::array contact_sheet_options{
    Option{"--columns", "N", "tiles per row (as many as make the sheet about 4:3)"},
    Option{"--title", "TEXT", "title of the sheet"},
};

// Fails (usage) if an option for sheets is given.
Result<void> no_sheet_options(const Arguments& arguments);

// Reads -s (default `usual`) for each tile's picture, --columns and --title. Fails (usage) on values that make no
// sense.
Result<SheetOptions> read_sheet_options(const Arguments& arguments, const PreviewRequest& request, PixelSize usual);

// Fails (usage) on a format of light values, which cannot hold labels.
Result<void> holds_sheets(const media::ImageFormat& format, std::string_view hint = "write .png or .jpg");

// Fails (usage) if this number of tiles ("profiles") makes too large a picture.
Result<void> fits_sheet(std::size_t tiles, const SheetOptions& options, std::string_view what);

// What a tile's display takes beside its picture.
struct TileScene {
    std::vector<PartialLight> lights; // in its pixels, exposed too
    Camera camera;
};

// Puts the exposed linear pictures of all tiles through the display transform. Empty pictures stay empty.
Result<void> develop_tiles(std::vector<SheetTile>& tiles, std::vector<TileScene> scenes, const PreviewRequest& request,
                           const Console& console);

} // namespace gonio::cli
