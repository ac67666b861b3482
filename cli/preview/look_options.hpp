// How `gonio preview` shows the rendered picture: the display mode with its scale, and the exposure.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/chromaticity.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/plot/look.hpp>
#include <gonio/preview/glare.hpp>
#include <gonio/preview/tone_map.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array preview_look_options{
    Option{"--look", "LOOK", "display mode: beauty, falsecolour, isolux, luminance (beauty)", "looks"},
    Option{"--quantity", "NAME", "falsecolour, isolux: show illuminance or luminance (illuminance)"},
    Option{"--unit", "UNIT", "unit of the legend: lx or fc, nt or fL (lx; for luminance nt)"},
    Option{"--scale", "SCALE",
           "falsecolour: log or linear, LOW:HIGH, or both: 0.1lx:1000lx, linear:0lx:500lx (log with round limits)"},
    Option{"--palette", "NAME", "colours of falsecolour and isolux (viridis)", "palettes"},
    Option{"--levels", "LIST", "isolux: levels of the lines, 1lx,5lx,10lx (1, 2 and 5 times the powers of ten)"},
    Option{"--no-legend", "", "leave out the legend, which adds 84 pixels to the width"},
};

inline constexpr std::array preview_exposure_options{
    Option{"--exposure", "EV",
           "auto, an exposure value such as 8ev, or lux:300lx, under which a matte 18 % card is middle grey (auto)"},
    Option{"--white-balance", "KELVIN",
           "the light that is shown as white: 2700K, auto (the mean of the picture) or off, which is D65 (off)"},
    Option{"--glare", "",
           "add the veil that the eye scatters around what is brighter than white, from what is in the picture"},
    Option{"--eye", "KEY=VALUE,…",
           "the eye of --glare: age=60 in years, pigment=0 (dark brown) to 1.2 (light blue) (age=25,pigment=0.5)"},
    Option{"--tone-map", "NAME", "tone map instead of the view: none, ue3 or ue3-inverse (none)", "tone-maps"},
};

struct LookRequest {
    Look look = Look::beauty;
    PictureQuantity quantity = PictureQuantity::illuminance;
    const Unit* unit = nullptr; // unit of the legend
    bool logarithmic = true;
    std::optional<ValueScale> scale; // round limits if not given
    const Palette* palette = nullptr;
    std::vector<double> levels; // in base units; empty: round ones
    bool legend = true;
};

// Fails (usage) on option values that make no sense, on options that the display mode does not use, and on a format
// that cannot store the result.
Result<LookRequest> read_look(const Arguments& arguments, const media::ImageFormat& format);

enum class ExposureMode { automatic, ev, card };

struct ExposureRequest {
    ExposureMode mode = ExposureMode::automatic;
    Ev100 ev; // if not automatic
    ToneMap tone_map = ToneMap::none;
    bool auto_white = false;
    std::optional<Xy> white;  // shown as white; if not automatic
    std::optional<Eye> glare; // in which it is added

    Ev100 of(const Rendering& rendering, unsigned threads) const;
};

// "auto", "8ev", "lux:300lx".
Result<void> read_exposure_value(const std::string& text, ExposureRequest& request);

Result<ExposureRequest> read_exposure(const Arguments& arguments, const media::ImageFormat& format);

std::string_view to_text(ExposureMode mode); // "auto", "ev", "lux"

} // namespace gonio::cli
