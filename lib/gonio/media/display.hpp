// Conversion of scene-linear light to display values, and to the colour spaces of a configuration, by OpenColorIO.
//
// gonio's pictures are linear with Rec.709 primaries and D65 white; 1 is the white of the display. Without a
// configuration file the built-in one is used: the display "sRGB" with the views
//   Standard   only the IEC 61966-2-1 curve (the default)
//   Filmic     the same up to middle grey; above it bright light becomes white without a change of hue
//   ACES       the ACES 1.0 SDR video output transform: tone-mapped, for pictures beyond 1
//   Raw        the numbers unchanged
// With a file, gonio's pixels enter through its role aces_interchange. A configuration without that role is entered
// through a space that is named as linear Rec.709 by convention, else through its role scene_linear, and the result has
// a warning. The library never reads $OCIO; the caller passes it as `config`.
//
// Everything here opens the module gonio-color.so (see module.hpp) and fails (unsupported) without it; the first call
// takes a few milliseconds. Safe to call from any thread, but one Image must be used by one caller at a time.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>

#include <span>
#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio::media {

// Which configuration, display and view.
struct DisplayOptions {
    std::string config;   // path of an OpenColorIO configuration; empty: the built-in one
    std::string source;   // colour space or role of the pixels; empty: linear Rec.709, entered as described above
    std::string display;  // empty: the configuration's default
    std::string view;     // empty: the display's default
    unsigned threads = 0; // 0: all; the result is the same with any number
};

// What a display transform did, with all defaults filled in.
struct DisplayUsed {
    std::string source;
    std::string display;
    std::string view;
    Diagnostics diagnostics; // a warning if the space of the pixels had to be assumed
};

// Replaces the first three channels of every pixel by display values, white = 1; a fourth channel stays unchanged.
// Values outside [0, 1] are possible and are left to the file format. Fails (usage) on unknown names, with the known
// ones in the hint, and on an image without 3 or 4 channels; (io, malformed) on a configuration that cannot be read;
// (unsupported) on a transform that OpenColorIO refuses.
Result<DisplayUsed> apply_display(Image& image, const DisplayOptions& options = {});

// The same for several pictures, through one transform: setting it up costs as much as applying it to a small picture.
Result<DisplayUsed> apply_display(std::span<Image* const> images, const DisplayOptions& options = {});

// A display of a configuration, with its views.
struct Display {
    std::string name;
    std::vector<std::string> views; // the default first
};

// The displays of a configuration with their views, the default display first.
Result<std::vector<Display>> list_displays(const std::string& config = {});

// Every colour space of a configuration, in its order.
Result<std::vector<std::string>> list_spaces(const std::string& config = {});

// Converts packed RGB triples in place, without tone mapping between scene-linear spaces. `from` and `to` are colour
// spaces, aliases or roles; ACES2065-1 of a configuration is its role aces_interchange. float32 arithmetic. Fails as
// apply_display does; (usage) when the size of the span is not a multiple of three.
Result<void> convert_space(std::span<float> rgb, const std::string& from, const std::string& to,
                           const std::string& config = {});

} // namespace gonio::media
#pragma GCC visibility pop
