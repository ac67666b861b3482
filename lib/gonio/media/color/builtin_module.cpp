// The colour module of WebAssembly: the built-in configuration without OpenColorIO. Its contract is in
// detail/color_abi.hpp.
//
// The display sRGB with the views Standard, Filmic and Raw, and the scene-linear spaces lin_rec709, ACEScg and
// ACES2065-1, as color_module.cpp has them; the view ACES and other configurations need OpenColorIO. Pictures of the
// two modules differ by rounding in float.
#include <gonio/color/rgb_space.hpp>
#include <gonio/media/detail/color_abi.hpp>
#include <gonio/media/detail/filmic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace gonio::media::abi {

struct ColorConfig {};

struct ColorProcessor {
    glm::dmat3 matrix{1.0};
    bool filmic = false;
    bool encodes = false; // IEC 61966-2-1
};

} // namespace gonio::media::abi

namespace {

using namespace gonio::media::abi;
using namespace std::string_view_literals;

// A space of the configuration, and its name among those of the room color; without one it is not scene-linear.
struct Space {
    const char* name;
    std::string_view alias;
    std::string_view rgb_space;
    SpaceKind kind;
};

constexpr std::array spaces{Space{"ACES2065-1", "aces2065_1", "aces2065-1", space_scene},
                            Space{"ACEScg", "acescg", "acescg", space_scene},
                            Space{"lin_rec709", "lin_srgb", "rec709", space_scene}, Space{"raw", "", "", space_data},
                            Space{"sRGB", "", "", space_display}};
constexpr std::array views{"Standard", "Filmic", "Raw"};
constexpr std::array roles{std::array{"scene_linear"sv, "lin_rec709"sv},
                           std::array{"aces_interchange"sv, "ACES2065-1"sv}, std::array{"data"sv, "raw"sv},
                           std::array{"default"sv, "raw"sv}};

const ColorConfig builtin;

const Space* space_named(std::string_view name) {
    for (const auto& [role, of] : roles)
        if (name == role) name = of;
    for (const Space& space : spaces)
        if (name == space.name || (!space.alias.empty() && name == space.alias)) return &space;
    return nullptr;
}

int refuse(char* message, const char* text) {
    std::snprintf(message, message_bytes, "%s", text);
    return unsupported;
}

int open_config(const char* path, ColorConfig** config, char* message) noexcept {
    if (path != nullptr && *path != '\0')
        return refuse(message, "WebAssembly has the built-in configuration alone, without OpenColorIO");
    *config = const_cast<ColorConfig*>(&builtin); // it has no state
    return done;
}

void close_config(ColorConfig* /*config*/) noexcept {}

const char* display_at(const ColorConfig* /*config*/, std::size_t index) noexcept {
    return index == 0 ? "sRGB" : nullptr;
}

const char* view_at(const ColorConfig* /*config*/, const char* /*display*/, std::size_t index) noexcept {
    return index < views.size() ? views[index] : nullptr;
}

const char* space_at(const ColorConfig* /*config*/, std::size_t index) noexcept {
    return index < spaces.size() ? spaces[index].name : nullptr;
}

const char* default_display(const ColorConfig* /*config*/) noexcept {
    return "sRGB";
}

const char* default_view(const ColorConfig* /*config*/, const char* /*display*/) noexcept {
    return views.front();
}

const char* find_space(const ColorConfig* /*config*/, const char* name) noexcept {
    const Space* const space = space_named(name);
    return space == nullptr ? nullptr : space->name;
}

std::int32_t space_kind(const ColorConfig* /*config*/, const char* name) noexcept {
    const Space* const space = space_named(name);
    return space == nullptr ? space_unknown : space->kind;
}

// RGB of one scene-linear space to another; false if one is not.
bool matrix_between(std::string_view source, std::string_view target, glm::dmat3& matrix) {
    const Space* const from = space_named(source);
    const Space* const to = space_named(target);
    if (from == nullptr || to == nullptr || from->kind != space_scene || to->kind != space_scene) return false;
    if (from == to)
        matrix = glm::dmat3(1.0);
    else
        matrix = gonio::find_rgb_space(to->rgb_space)->from_xyz * gonio::find_rgb_space(from->rgb_space)->to_xyz;
    return true;
}

int space_matrix(const ColorConfig* /*config*/, const char* source, const char* target, double* matrix,
                 std::int32_t* is_matrix, char* message) noexcept {
    glm::dmat3 columns;
    if (!matrix_between(source, target, columns)) return refuse(message, "the spaces are not both scene-linear");
    *is_matrix = 1;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            matrix[3 * row + column] = columns[column][row];
    return done;
}

int display_processor(const ColorConfig* /*config*/, const char* source, const char* /*display*/, const char* view,
                      ColorProcessor** processor, char* message) noexcept {
    ColorProcessor made;
    if (view != "Raw"sv) {
        if (!matrix_between(source, "lin_rec709", made.matrix))
            return refuse(message, "the source is not scene-linear");
        made.filmic = view == "Filmic"sv;
        made.encodes = true;
    }
    *processor = new ColorProcessor(made);
    return done;
}

int space_processor(const ColorConfig* /*config*/, const char* source, const char* target, ColorProcessor** processor,
                    char* message) noexcept {
    ColorProcessor made;
    if (!matrix_between(source, target, made.matrix)) return refuse(message, "the spaces are not both scene-linear");
    *processor = new ColorProcessor(made);
    return done;
}

// filmic.hpp: the curve on channels that are moved towards their luminance, and back.
glm::dvec3 filmic(glm::dvec3 rgb) {
    using gonio::media::detail::filmic_curve;
    using gonio::media::detail::filmic_mix;
    const glm::dvec3 row = gonio::luminance_row(*gonio::find_rgb_space("rec709"));
    const auto luminance = [&](const glm::dvec3& of) { return row.x * of.x + row.y * of.y + row.z * of.z; };
    rgb = (1.0 - filmic_mix) * rgb + filmic_mix * luminance(rgb);
    for (int i = 0; i < 3; ++i)
        rgb[i] = filmic_curve(rgb[i]);
    return (rgb - filmic_mix * luminance(rgb)) / (1.0 - filmic_mix);
}

int apply(const ColorProcessor* processor, float* pixels, std::size_t pixel_count, std::int32_t channels,
          char* /*message*/) noexcept {
    for (std::size_t i = 0; i < pixel_count; ++i) {
        float* const at = pixels + i * static_cast<std::size_t>(channels);
        glm::dvec3 rgb = processor->matrix * glm::dvec3(at[0], at[1], at[2]);
        if (processor->filmic) rgb = filmic(rgb);
        for (int channel = 0; channel < 3; ++channel)
            at[channel] = static_cast<float>(processor->encodes ? gonio::encode_srgb(rgb[channel]) : rgb[channel]);
    }
    return done;
}

void close_processor(ColorProcessor* processor) noexcept {
    delete processor;
}

constexpr ColorModule table{color_version, open_config,       close_config,    display_at, view_at,
                            space_at,      default_display,   default_view,    find_space, space_kind,
                            space_matrix,  display_processor, space_processor, apply,      close_processor};

} // namespace

extern "C" const void* gonio_color_module();

const void* gonio_color_module() {
    return &table;
}
