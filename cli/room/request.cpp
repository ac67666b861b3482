#include "request.hpp"

#include <gonio/base/unit_text.hpp>

#include "../options/values.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

// The parts of "6x4x2.8"; "×" separates too.
std::vector<std::string> split(std::string_view text, std::string_view separators) {
    std::vector<std::string> parts(1);
    constexpr std::string_view times = "×";
    while (!text.empty()) {
        const bool is_times = separators.find('x') != std::string_view::npos && text.starts_with(times);
        if (is_times || separators.find(text.front()) != std::string_view::npos)
            parts.emplace_back();
        else
            parts.back() += text.front();
        text.remove_prefix(is_times ? times.size() : 1);
    }
    return parts;
}

Result<glm::dvec3> room_size(const std::string& text) {
    const std::vector<std::string> parts = split(text, "x");
    if (parts.size() != 3)
        return fail("USE0105", fmt::format("'{}' is not the size of a room", text),
                    "write length, width and height, for example 6x4x2.8 or 6mx4mx280cm");
    glm::dvec3 size(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        Result<double> length_m = parse_length(parts[static_cast<std::size_t>(axis)], "the size of a room");
        if (!length_m) return pass_on(length_m);
        size[axis] = *length_m;
    }
    return size;
}

Result<RoomReflectances> reflectances_of(const std::string& text) {
    const std::vector<std::string> parts = split(text, "/");
    std::array<double, 3> percent{};
    bool is_right = parts.size() == percent.size();
    for (std::size_t i = 0; is_right && i < percent.size(); ++i) {
        const std::optional<double> number = parse_number(parts[i]);
        is_right = number.has_value();
        percent[i] = number.value_or(0.0);
    }
    if (!is_right)
        return fail("USE0105", fmt::format("'{}' is not three reflectances", text),
                    "write those of ceiling, walls and floor in per cent, for example 70/50/20");
    return RoomReflectances{0.01 * percent[0], 0.01 * percent[1], 0.01 * percent[2]};
}

Result<RoomLayout> layout_of(std::string_view text) {
    Result<PixelSize> size = parse_size(text);
    if (!size) {
        error_hint(size.error(), "write the luminaires along the length and along the width, for example 4x3");
        return pass_on(size);
    }
    return RoomLayout{static_cast<std::size_t>(size->width), static_cast<std::size_t>(size->height)};
}

Result<void> read_lengths(const Arguments& arguments, RoomPlanRequest& plan) {
    struct Length {
        std::string_view option;
        double RoomPlanRequest::*to;
    };
    constexpr std::array lengths{
        Length{"--mount", &RoomPlanRequest::mounting_height_m}, Length{"--plane", &RoomPlanRequest::plane_height_m},
        Length{"--wall-zone", &RoomPlanRequest::wall_zone_m}, Length{"--eye", &RoomPlanRequest::eye_height_m}};
    for (const Length& length : lengths)
        if (const auto text = arguments.value(length.option)) {
            Result<double> meters = parse_length(*text, length.option);
            if (!meters) return pass_on(meters);
            plan.*length.to = *meters;
        }
    if (arguments.has("--mount") && !(plan.mounting_height_m > 0.0))
        return fail("USE0106", "--mount takes a height above 0");
    return {};
}

// What the room is planned for: --for, --count, or what the task asks for.
Result<void> read_aim(const Arguments& arguments, const std::optional<TaskInput>& task, RoomPlanRequest& plan) {
    const auto lux = arguments.value("--for");
    const auto count = arguments.value("--count");
    if (!lux && !count && task && task->mean_lx()) {
        plan.mean = Lux(*task->mean_lx());
        return {};
    }
    if (!lux && !count)
        return fail("USE0104", "neither --for, --count nor --task is given",
                    "say what to plan for: --for 500lx, --task office.writing, or --count 4x3");
    if (lux && count)
        return fail("USE0107", "--for and --count are both given", "a layout gives the light that it gives");
    if (lux) {
        Result<double> mean = parse_amount(*lux, Dimension::illuminance, "--for");
        if (!mean) return pass_on(mean);
        plan.mean = Lux(*mean);
        return {};
    }
    Result<RoomLayout> layout = layout_of(*count);
    if (!layout) return pass_on(layout);
    plan.layout = *layout;
    return {};
}

} // namespace

Result<RoomRequest> parse_room(const Arguments& arguments, Diagnostics& diagnostics) {
    RoomRequest request;
    if (arguments.positional().size() != 1)
        return fail("USE0104", arguments.positional().empty() ? "no room is given" : "more than one room is given",
                    "write its length, width and height, for example 6x4x2.8");
    request.size = arguments.positional().front();
    Result<glm::dvec3> size = room_size(request.size);
    if (!size) return pass_on(size);
    request.plan.size_m = *size;
    if (const auto text = arguments.value("--reflectances")) {
        Result<RoomReflectances> reflectances = reflectances_of(*text);
        if (!reflectances) return pass_on(reflectances);
        request.plan.reflectances = *reflectances;
    }
    if (const auto text = arguments.value("--maintenance")) {
        Result<double> factor = parse_factor(*text, "maintenance factor");
        if (!factor) return pass_on(factor);
        request.plan.maintenance_factor = *factor;
    }
    Result<void> read = read_lengths(arguments, request.plan);
    Result<std::optional<TaskInput>> task = task_input(arguments);
    if (!task) return pass_on(task);
    request.task = std::move(*task);
    request.plan.surfaces = request.task.has_value();
    if (read) read = read_aim(arguments, request.task, request.plan);
    if (!read) return pass_on(read);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.plan.threads = *threads;
    // Near the plane a luminaire is no point.
    Result<LuminaireInput> luminaire = luminaire_input(arguments, ProfileSize::declared, diagnostics);
    if (!luminaire) return pass_on(luminaire);
    request.luminaire = std::move(*luminaire);
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        request.luminaire.light.rotation = Radians(*angle);
    }
    return request;
}

} // namespace gonio::cli
