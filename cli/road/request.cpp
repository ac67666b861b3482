#include "request.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

Result<void> read_lengths(const Arguments& arguments, RoadPlanRequest& plan) {
    struct Length {
        std::string_view option;
        double RoadPlanRequest::*to;
    };
    constexpr std::array lengths{Length{"--spacing", &RoadPlanRequest::spacing_m},
                                 Length{"--height", &RoadPlanRequest::height_m},
                                 Length{"--overhang", &RoadPlanRequest::overhang_m}};
    for (const Length& length : lengths)
        if (const auto text = arguments.value(length.option)) {
            Result<double> meters = parse_length(*text, length.option);
            if (!meters) return pass_on(meters);
            plan.*length.to = *meters;
        }
    return {};
}

// A name of the library's tables, or a file.
Result<RoadSurface> road_surface(const Arguments& arguments) {
    const std::string name = arguments.value("--surface").value_or("r3");
    const std::span<const RoadSurface> known = known_road_surfaces();
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const RoadSurface& surface) { return surface.name == name; });
    RoadSurface surface;
    if (found != known.end()) {
        surface = *found;
    } else if (name.find_first_of("./\\") == std::string::npos) {
        auto none = find_named("road surface", name, known);
        if (none) return **none;
        error_hint(none.error(), "there is r3; others are read from a file: --surface r2.csv");
        return pass_on(none);
    } else {
        Result<std::string> text = read_file(name, limit("list-bytes"));
        if (!text) return pass_on(text);
        Result<RoadSurface> parsed = parse_road_surface(*text, name);
        if (!parsed) return parsed;
        surface = std::move(*parsed);
    }
    const auto q0 = arguments.value("--q0");
    if (!q0) return surface;
    const std::optional<double> average = parse_number(*q0);
    if (!average) return fail("USE0105", fmt::format("--q0 takes a number, not '{}'", *q0), "for example 0.07");
    return with_average(std::move(surface), *average);
}

} // namespace

Result<RoadRequest> parse_road(const Arguments& arguments, Diagnostics& diagnostics) {
    RoadRequest request;
    RoadPlanRequest& plan = request.plan;
    if (arguments.positional().size() != 1)
        return fail("USE0104", arguments.positional().empty() ? "no road is given" : "more than one road is given",
                    "write its width from kerb to kerb, for example 7m");
    Result<double> width_m = parse_length(arguments.positional().front(), "the width of a road");
    if (!width_m) return pass_on(width_m);
    plan.width_m = *width_m;
    if (const auto text = arguments.value("--lanes")) {
        Result<std::uint64_t> lanes = whole_number(*text, "--lanes");
        if (!lanes) return pass_on(lanes);
        plan.lanes = static_cast<std::size_t>(*lanes);
    }
    plan.two_way = arguments.has("--two-way");
    if (Result<void> read = read_lengths(arguments, plan); !read) return pass_on(read);
    if (const auto text = arguments.value("--arrangement")) {
        auto found = find_named("arrangement", *text, road_arrangements());
        if (!found) return pass_on(found);
        plan.arrangement = (*found)->arrangement;
    }
    if (const auto text = arguments.value("--tilt")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--tilt");
        if (!angle) return pass_on(angle);
        plan.tilt = Radians(*angle);
    }
    if (const auto text = arguments.value("--maintenance")) {
        Result<double> factor = parse_factor(*text, "maintenance factor");
        if (!factor) return pass_on(factor);
        plan.maintenance_factor = *factor;
    }
    Result<std::optional<TaskInput>> task = task_input(arguments);
    if (!task) return pass_on(task);
    request.task = std::move(*task);
    request.has_spacing = arguments.has("--spacing");
    if (!request.has_spacing && !request.task)
        return fail("USE0104", "neither --spacing nor --task is given",
                    "say how far the luminaires are apart (--spacing 30m), or what to plan for (--task road.m3)");
    Result<RoadSurface> surface = road_surface(arguments);
    if (!surface) return pass_on(surface);
    plan.surface = std::move(*surface);
    Result<LuminaireInput> luminaire = luminaire_input(arguments, ProfileSize::point, diagnostics);
    if (!luminaire) return pass_on(luminaire);
    request.luminaire = std::move(*luminaire);
    plan.street_side_c_deg = request.luminaire.street_side_c_deg;
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        plan.street_side_c_deg -= to_degrees(Radians(*angle));
    }
    return request;
}

} // namespace gonio::cli
