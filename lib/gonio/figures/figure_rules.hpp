// The rule behind each figure: the standard that defines it, with its edition.
#pragma once

#include <array>
#include <string_view>

namespace gonio {

struct FigureRule {
    std::string_view figure; // its name in a record
    std::string_view rule;
};

inline constexpr std::array figure_rules{
    FigureRule{"light_output_ratios", "EN 13032-2:2017, of the lamps' flux"},
    FigureRule{"upward_light_ratio", "CIE 126:1997, of the luminaire's flux"},
    FigureRule{"distribution_class", "DIN 5040-2:1995, by the downward share"},
    FigureRule{"ugr_correction",
               "CIE 190:2010, 8 log10 of the lamps' lumens over 1000: the table for 1000 lm is lower by this"},
    FigureRule{"ugr_table", "CIE 190:2010, spacing 0.25 H, position index of CIE 117:1995"},
    FigureRule{"ugr_table_sh1", "CIE 190:2010, spacing 1 H, position index of CIE 117:1995"},
    FigureRule{"luminances", "EN 13032-2:2017, intensity over projected area"},
    FigureRule{"direct_ratios", "CIE 52:1982, share of the downward flux"},
    FigureRule{"utilisation_factors", "CIE 52:1982, three surfaces, of the lamps' flux"},
    FigureRule{"coefficients_of_utilisation", "IES Lighting Handbook, 10th edition, zonal cavity method"},
    FigureRule{"bug", "IES TM-15-11"},
    FigureRule{"cut_off", "IES RP-8-00, per 1000 lm of the lamps"},
    FigureRule{"luminous_intensity_class", "EN 13201-2:2015, annex A, per 1000 lm of the luminaire"},
    FigureRule{"luminous_intensity_class_lamps", "EN 13201-2:2003, annex A, per 1000 lm of the lamps"},
    FigureRule{"glare_index", "EN 13201-2:2015, annex A"},
};

// Of a name in the table; empty for others.
constexpr std::string_view rule_of_figure(std::string_view figure) {
    for (const FigureRule& rule : figure_rules)
        if (rule.figure == figure) return rule.rule;
    return {};
}

} // namespace gonio
