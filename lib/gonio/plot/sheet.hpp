// A sheet: labelled pictures side by side in one picture. It shows many profiles, as an overview of a library, or one
// scene by several methods or with a changing value.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/web/web.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gonio {

// Each side of the square polar diagram in a tile.
inline constexpr int sheet_polar_px = 132;

struct SheetTile {
    std::string name;               // UTF-8, cut with an ellipsis if too long
    std::vector<std::string> facts; // one line each, below the name; there is room for one
    Image picture;                  // three display-encoded channels; empty: none
    std::optional<Drawing> polar;   // from polar_thumbnail
    std::string fault;              // a message instead of the picture
};

struct SheetOptions {
    int columns = 0; // 0: chosen to make the sheet about 4:3
    std::string title;
    int picture_width_px = 176; // of every tile
    int picture_height_px = 132;
    bool polar = true; // reserves space for polar diagrams
};

struct SheetLayout {
    int columns = 1;
    int rows = 1;
    int width_px = 0;
    int height_px = 0;
};

SheetLayout layout_of(std::size_t tiles, const SheetOptions& options);

// The tiles in order, row by row, on a dark background.
Image sheet(std::span<const SheetTile> tiles, const SheetOptions& options);

// Intensity around the nadir in the planes C0 and C90 with their opposites, scaled to fill the dial, without numbers;
// for a dark background.
Drawing polar_thumbnail(const Web& web);

} // namespace gonio
