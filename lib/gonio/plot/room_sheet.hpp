// The sheet of a planned room: its plan with the illuminance in each cell and lines of equal light, the luminaires,
// what glares, and how the light compares with what a task requires.
//
// Pages are as those of data_sheet.hpp. Texts may be of any encoding and length. Fails (usage) as grid_diagram().
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/figures/tasks.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/plot/grid_diagram.hpp>
#include <gonio/plot/page_layout.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gonio {

// Luminaires of one kind.
struct RoomSheetLuminaire {
    std::string letter; // by which the plan names them; empty: there is one kind
    std::string name;
    std::size_t count = 0;
    std::optional<double> input_w = {}; // of each
    std::optional<double> flux_lm = {};
    std::string mounting; // "at 2.8 m"
};

// What a sheet of a room shows.
struct RoomSheetContent {
    std::string title;
    std::string source;                                     // the file, or what was asked for
    std::vector<std::pair<std::string, std::string>> facts; // "Mean illuminance", "730 lx"
    std::vector<std::pair<std::string, std::string>> glare; // "Towards +X", "21.1"
    std::string glare_rule = "CIE 117:1995";
    std::string task; // title and rule; empty: none
    std::vector<Verdict> verdicts;
    std::vector<RoomSheetLuminaire> luminaires;
    std::string flux_head = "flux"; // of their column
    GridPlot plot;
};

// One page, and how many letters that the font does not have are on it.
struct RoomSheet {
    std::vector<Drawing> pages;
    std::size_t replaced = 0;
};

Result<RoomSheet> room_sheet(const RoomSheetContent& content, PaperSize paper = PaperSize::a4);

} // namespace gonio
