// From the rendering to the bytes of a picture file.
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
    Ev100 exposure; // the exposure used; for a picture of numbers the one that would be used
    // For display modes other than beauty.
    ScaleUse use;
    std::optional<ValueScale> scale; // falsecolour, luminance
    std::vector<double> levels;      // isolux, in base units
};

// A picture as a display shows it: display-encoded, white = 1, with the legend of its display mode.
struct ShownPicture {
    Image image;
    Ev100 exposure;
    ScaleUse use;
    std::optional<ValueScale> scale; // falsecolour, luminance
    std::vector<double> levels;      // isolux, in base units
};

// An exposed linear picture, the lights in its pixels and the camera.
struct ExposedPicture {
    Image* picture = nullptr;
    std::vector<PartialLight> lights;
    Camera camera;
};

// Converts them to display-encoded values, by the selected view or tone map. All together, because setting up a
// transform costs as much as applying it; a white balance is that of all of them, without glare.
Result<void> show_exposed(std::span<ExposedPicture> pictures, const PreviewRequest& request, const Console& console);

// Whether integers are dithered; not where colours are read against the legend.
bool is_dithered(Look look);

// What encode_picture() stores in an integer format.
Result<ShownPicture> show_picture(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                                  const Console& console);

// Integer formats: exposed, through the display transform, in the selected display mode. Float formats: linear Rec.709
// in cd/m², or one channel Y with the display mode's quantity in lux or cd/m².
Result<EncodedPicture> encode_picture(Rendering rendering, const PreviewRequest& request, std::span<const Light> lights,
                                      const Console& console);

// A warning if numbers of the picture may have been clipped at shading::illuminance_ceiling. For pictures that store
// numbers.
void warn_of_ceiling(const Image& luminance_nt, Diagnostics& diagnostics);

// A warning if the picture is black though a light shines: nothing lit is visible.
void warn_of_black(const Image& luminance_nt, const PreviewRequest& request, std::span<const Light> lights,
                   Diagnostics& diagnostics);

} // namespace gonio::cli
