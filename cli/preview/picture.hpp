// From what was rendered to the bytes of a picture file.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>

#include "../console.hpp"
#include "request.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gonio::cli {

struct EncodedPicture {
    std::string bytes;
    int width = 0;  // of the file, with its legend
    Ev100 exposure; // which it was exposed by; of a picture of numbers the one that would be
    // Of other looks than beauty.
    ScaleUse use;
    std::optional<ValueScale> scale; // falsecolour, luminance
    std::vector<double> levels;      // isolux, in base units
};

// An exposed linear picture as display-encoded values, by the view or the tone map that is asked for.
Result<void> show_exposed(Image& exposed, const PreviewRequest& request, const Console& console);

// Integer formats: exposed, through the display transform, as the look that is asked for. Float formats: linear Rec.709
// in cd/m², or one channel Y of the look's quantity in lux or cd/m².
Result<EncodedPicture> encode_picture(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                                      const Console& console);

// A warning where numbers of the picture may have been cut at shading::illuminance_ceiling. For pictures that keep
// them.
void warn_of_ceiling(const Image& luminance_nt, Diagnostics& diagnostics);

} // namespace gonio::cli
