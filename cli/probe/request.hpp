// The request of `gonio probe`: lights, points, methods, and the form of the answer.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/spatial_illuminance.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../options/emits_input.hpp"
#include "../options/grid_drawing.hpp"
#include "../options/points_input.hpp"
#include "../options/profile_size.hpp"
#include "../options/sky_input.hpp"
#include "../options/task_input.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

inline constexpr std::array probe_options{
    Option{"--method", "METHOD", "method for the light of each shape (exact)", "methods"},
    Option{"--compare", "M1,M2", "show methods side by side, with their errors", "methods"},
    Option{"--quantity", "KIND",
           "planar, horizontal, vertical, cylindrical, semi-cylindrical, hemispherical or modelling (planar); vertical "
           "and semi-cylindrical face --normal",
           "quantities"},
    Option{"--glare", "", "rate the glare (UGR) for eyes at the points that look along --normal; needs --indirect"},
    Option{"--error", "E", "relative tolerance of the method reference (1e-6)"},
    Option{"--view", "X,Y,Z",
           "also print the luminance: direction from the points to the eye, or at:X,Y,Z for its position"},
    Option{"--material", "[SURFACE=]MATERIAL",
           "with --view, material of the surface; with --indirect, of a surface of the stage; without SURFACE, of what "
           "the stage shows",
           "materials", true},
    Option{"-j,--jobs", "N", "number of threads (all processors)"},
};
inline constexpr std::array probe_profile_options{profile_size_option};
inline constexpr std::array probe_stage_options{
    Option{
        "--indirect", "",
        "add the light that the surfaces of a stage reflect, and the shadows of what stands on it: that of the rig or "
        "of --stage"},
    sky_option,
    Option{"--stage", "STAGE", "with --indirect, --sky or --emits: a stage by name (that of the rig)", "stages"},
    emits_option,
};
inline constexpr std::array probe_report_options{
    Option{"--json", "", "one JSON object, with the share of each light"},
    Option{"--jsonl", "", "the same on one line"},
    Option{"--csv", "", "a table with one row per point"},
    Option{"-o,--output", "FILE", "draw a grid: its plan with a number in each cell, and lines of equal light"},
    Option{"-s,--size", "WxH", "of the drawing in pixels (as the numbers need)"},
    Option{"--title", "TEXT", "of the drawing"},
    Option{"--to", "FORMAT", "svg or an 8-bit picture format, if the file name does not show it (svg)", "images"},
};

inline constexpr std::size_t lights_listed = 32;                    // at most, each with its share
inline constexpr std::size_t points_at_once = std::size_t{1} << 16; // whose values are held at a time

// The light of lights that were not kept.
struct SummedLight {
    ProbeResult result;
    std::vector<Light> remarked; // the lights that the remarks of the result count
    std::size_t count = 0;       // of all lights
    double milliseconds = 0.0;   // that the sum took
};

enum class ProbeForm { text, json, json_line, csv };

struct ProbeRequest {
    std::string rig; // empty: one light from options
    std::vector<Light> lights;
    std::optional<SummedLight> summed; // instead of lights
    Diagnostics diagnostics;
    Points points;
    std::vector<IrradianceMethod> methods; // one, or those compared, with the reference first
    bool compare = false;
    ProbeOptions options;
    std::optional<Stage> stage; // of --indirect or --sky, whose stage may have no surfaces
    bool indirect = false;
    bool glare = false;
    std::optional<TaskInput> task;
    Sky sky;
    ProbeForm form = ProbeForm::text;
    IlluminanceKind kind = IlluminanceKind::planar;
    std::optional<GridDrawing> drawing;

    std::size_t light_count() const { return summed ? summed->count : lights.size(); }

    // Whether the kind is the illuminance of a flat surface, with the receivers' normals.
    bool is_planar() const { return kind <= IlluminanceKind::vertical; }
};

// Checks everything except the files first: a mistake is reported before a large rig is read.
Result<ProbeRequest> parse_probe(const Arguments& arguments);

} // namespace gonio::cli
