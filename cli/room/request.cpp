#include "request.hpp"

#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/profile_header.hpp>

#include "../options/light_input.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>
#include <variant>
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

// In metres, or with a unit: "2.8", "280cm".
Result<double> length_of(std::string_view text, std::string_view what) {
    if (const std::optional<double> meters = parse_number(text)) return *meters;
    return parse_amount(text, Dimension::length, what);
}

Result<glm::dvec3> room_size(const std::string& text) {
    const std::vector<std::string> parts = split(text, "x");
    if (parts.size() != 3)
        return fail("USE0105", fmt::format("'{}' is not the size of a room", text),
                    "write length, width and height, for example 6x4x2.8 or 6mx4mx280cm");
    glm::dvec3 size(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        Result<double> length_m = length_of(parts[static_cast<std::size_t>(axis)], "the size of a room");
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

Result<double> factor_of(std::string_view text, std::string_view what) {
    const bool is_percent = text.ends_with('%');
    const std::optional<double> number = parse_number(is_percent ? text.substr(0, text.size() - 1) : text);
    if (!number)
        return fail("USE0105", fmt::format("'{}' is not a {}", text, what),
                    "write a number up to 1, or per cent: 0.8, 80%");
    return is_percent ? 0.01 * *number : *number;
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
            Result<double> meters = length_of(*text, length.option);
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

// Of the first lamps: a number, or a group of EULUMDAT, which stands for its lowest.
std::optional<double> declared_ra(const Profile& profile) {
    std::string text;
    if (const auto* ldt = std::get_if<LdtFile>(&profile.file)) {
        if (!ldt->lamp_sets.empty()) text = ldt->lamp_sets.front().color_rendering;
    } else if (const auto* tm33 = std::get_if<Tm33File>(&profile.file)) {
        if (!tm33->emitters.empty()) return tm33->emitters.front().cri_ra;
    }
    constexpr std::array groups{Named{"1A", 90.0}, Named{"1B", 80.0}, Named{"2A", 70.0},
                                Named{"2B", 60.0}, Named{"3", 40.0},  Named{"4", 20.0}};
    std::string_view trimmed = text;
    while (!trimmed.empty() && (trimmed.front() == ' ' || trimmed.front() == '>' || trimmed.front() == '='))
        trimmed.remove_prefix(1);
    while (!trimmed.empty() && trimmed.back() == ' ')
        trimmed.remove_suffix(1);
    for (const auto& group : groups)
        if (trimmed == group.name) return group.value;
    const std::optional<double> number = parse_number(trimmed);
    return number && *number >= 20.0 && *number <= 100.0 ? number : std::nullopt;
}

Result<void> read_luminaire(const Arguments& arguments, RoomRequest& request, Diagnostics& diagnostics) {
    ProfileShape profile;
    profile.file = request.file;
    profile.size = ProfileSize::declared; // near the plane a luminaire is no point
    request.luminaire.shape = profile;
    request.luminaire.name = "luminaire";
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = parse_amount(*text, Dimension::angle, "--rotate");
        if (!angle) return pass_on(angle);
        request.luminaire.rotation = Radians(*angle);
    }
    if (const auto text = arguments.value("--flux")) {
        Result<double> lumens = parse_amount(*text, Dimension::luminous_flux, "--flux");
        if (!lumens) return pass_on(lumens);
        request.flux = *text;
        Result<PhotometricValue> value = parse_photometric_value(*text);
        if (!value) return pass_on(value);
        request.luminaire.intensity = *value;
    }
    ProfileInputOptions options;
    options.photometric = true;
    Result<LoadedProfile> loaded = load(request.file, options);
    if (!loaded) return pass_on(loaded);
    diagnostics = loaded->diagnostics;
    request.ra = declared_ra(loaded->profile);
    const ProfileHeader header = header_of(loaded->profile);
    if (header.input_watts > 0.0) request.input_w = header.input_watts;
    request.name = keyword_text(header, "LUMINAIRE");
    if (request.name.empty()) request.name = keyword_text(header, "LUMCAT");
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
        Result<double> factor = factor_of(*text, "maintenance factor");
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
    const auto file = arguments.value("--luminaire");
    if (!file) return fail("USE0104", "no luminaire is given", "add --luminaire FILE");
    request.file = *file;
    if (read = read_luminaire(arguments, request, diagnostics); !read) return pass_on(read);
    return request;
}

} // namespace gonio::cli
