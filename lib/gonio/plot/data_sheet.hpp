// The data sheet of a luminaire: pages as makers print them, with its data, diagrams, tables and classes.
//
// Pages are drawings in points of 1/72 inch with text in DejaVu Sans (page_font.hpp): as SVG they need no more, as PDF
// they go through media/pdf_file.hpp. What the profile does not give is replaced by the reason. Texts may be of any
// encoding and length. Equal content gives equal pages. Nothing fails.
#pragma once

#include <gonio/figures/luminaire_figures.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/plot/page_layout.hpp>
#include <gonio/web/web.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gonio {

// What a sheet shows. Texts are as the file has them, and may be empty.
struct DataSheetContent {
    std::string file;
    std::string name; // of the luminaire
    std::string maker;
    std::string catalogue_number;
    std::string cct; // as stated: "3000", "warm white"
    std::string cri;
    std::string report; // of the measurement
    std::string date;
    const Web* web = nullptr;
    Opening opening;    // in the frame of the web
    ProfileFacts facts; // all of them, in candela and lumens
    LuminaireFigures figures;
};

// Where a luminaire is used: indoors by UGR tables and utilisation, outdoors by classes and isolux.
enum class LuminaireUse { automatic, indoor, outdoor };

struct DataSheetOptions {
    PaperSize paper = PaperSize::a4;
    LuminaireUse use = LuminaireUse::automatic;
    std::optional<double> height_m = {}; // of the diagrams of lux; 3 m indoors, 8 m outdoors
};

struct DataSheet {
    std::vector<Drawing> pages;
    bool is_outdoor = false;
    std::size_t replaced = 0; // letters that the font does not have, wherever they are shown
};

DataSheet data_sheet(const DataSheetContent& content, const DataSheetOptions& options = {});

// What LuminaireUse::automatic decides by the light alone: outdoors if at least 85 % of it goes down, and the peak is
// from 50° to 85° off the nadir while not all sides are alike, or from 60° while they are.
bool looks_outdoor(const ProfileFacts& facts);

} // namespace gonio
