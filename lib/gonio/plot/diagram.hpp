// Diagrams of webs: the light distribution of a luminaire, in the usual forms of the field.
//
// Intensities are candela, or candela per 1000 lm of the web's flux. Gamma counts from the nadir, C from the C0 plane;
// the curves follow the web's interpolant (evaluated at least every half degree and at every γ of the grid), so nothing
// is smoothed. Diagram kinds that stay readable with several webs (polar, cartesian) draw them over each other; the
// others take one web. Equal input gives equal drawings. Fails (usage) on a picture too small for the diagram, on more
// webs than the diagram takes, and on a web that is dark everywhere in the diagram.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/plot/drawing.hpp>
#include <gonio/web/web.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A curve of a diagram.
struct PlottedWeb {
    std::string label; // UTF-8
    const Web* web = nullptr;
    std::string name = {}; // of the luminaire, as its file states it; the title of a diagram without another
};

// What a diagram shows, and how large it is.
struct PlotOptions {
    int width_px = 720;
    int height_px = 720;
    bool lower_if_half = false;                // polar: a half circle gets a page of its own height
    std::string title;                         // empty: the name of the luminaire, if there is one
    std::vector<double> planes_deg{0.0, 90.0}; // polar, cartesian: each with the opposite plane C + 180°
    bool per_klm = false;                      // cd/klm instead of cd
    double mounting_height_m = 3.0;            // isolux: of the light above the plane; cone: the farthest plane
    double extent_m = 0.0;                     // isolux: half the side of the square; 0: twice the height
    bool has_facts = true;                     // a line of facts of a single luminaire, where there is room
    bool has_bands = true;                     // isolux: colours between the lines
};

// A diagram by its name, as `gonio list diagrams` shows it.
struct DiagramKind {
    std::string_view name; // "heat-map"
    std::string_view summary;
    // nullptr: a diagram of lights instead of webs, see falloff_diagram.hpp
    Result<Drawing> (*draw)(std::span<const PlottedWeb> webs, const PlotOptions& options);
};

// polar, cartesian, heat-map, isolux, cone, falloff.
std::span<const DiagramKind> diagram_kinds();

// Fails (usage) on an unknown name and suggests the nearest.
Result<const DiagramKind*> find_diagram(std::string_view name);

// Intensity against γ around the nadir (down), a curve for each plane.
Result<Drawing> polar_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options);

// Intensity against γ along an axis, C + 180° on the left.
Result<Drawing> cartesian_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options);

// Intensity by colour over C and γ.
Result<Drawing> heat_map_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options);

// Illuminance on a horizontal plane below the light, as coloured bands and lines of equal lux: E = I cos³γ / h², from
// a point at the height h, aimed straight down.
Result<Drawing> isolux_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options);

// The width of the beam (half the peak intensity) at five distances, and the illuminance on the axis and at its edge.
Result<Drawing> cone_diagram(std::span<const PlottedWeb> webs, const PlotOptions& options);

} // namespace gonio
#pragma GCC visibility pop
