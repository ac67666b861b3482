// The shading core's formulas as functions of shading languages: what `gonio shader` prints.
//
// The source is recorded from the templates that compute in C++: a scalar that records runs through them. It depends on
// nothing but its parameters. Lengths are in metres, between 1e-4 and 1e5; angles in radians; directions are unit.
// Deterministic: equal requests give equal bytes. Nothing here fails or reads files; recording takes one to fifty
// milliseconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)

namespace gonio {

// GLSL ES 3.00 (WebGL 2), GLSL 4.50 (Vulkan, OpenGL), HLSL (shader model 5 and later), the Metal Shading Language, WGSL
// (WebGPU), and the Open Shading Language.
enum class ShaderLanguage : std::uint8_t { glsl_es300, glsl450, hlsl, msl, wgsl, osl };

// A row of the list of languages.
struct ShaderLanguageName {
    std::string_view name;   // as the tool takes it
    ShaderLanguage language; // the language of that name
    std::string_view help;   // one line about it
};

// All languages, in their order.
std::span<const ShaderLanguageName> shader_languages();

// What happens where a simple case needs less work: an early return, or both results and a choice between them.
enum class ShaderBranches : std::uint8_t { real, select };

// What identifies a formula. A part that a formula does not have is empty.
struct ShaderFormula {
    std::string_view what;     // irradiance, brdf, sample, pdf, shade, roughness or visibility
    std::string_view light;    // sphere, disk, rect, tube, sun, point or spot
    std::string_view method;   // exact, frostbite, ue4, point, representative-point, ltc, ltc-share, a window or a lobe
    std::string_view material; // lambert, eon, frostbite, ue4, gltf, blinn, ggx, ggx-anisotropic or kulla-conty
    std::string_view shadow_of; // sphere or capsule
    bool operator==(const ShaderFormula&) const = default;
};

// The largest error of the formula in float against the core in double, over 10,000 random poses: a share of the result
// plus a tenth of the subtended angle [rad] (irradiance), or plus 0.1 (else). The core's own bound is 1e-5.
struct ShaderError {
    double apart; // farther from the light than a tenth of its size
    double near;  // nearer, where the core computes in double; outside the light. Of a disk's highlight by ltc it is
                  // the largest found with any compiler: float decides on which side of the disk a receiver is
};

// A formula that has a shader.
struct ShaderFormulaInfo {
    ShaderFormula formula;     // its names
    std::string_view function; // the name of its function
    std::string_view title;    // one sentence about it
    ShaderError error;         // measured; a test repeats the measurement
};

// The number of formulas.
std::size_t shader_formula_count();
// A formula by its place in the list, which is below that number.
ShaderFormulaInfo shader_formula(std::size_t place);

// The source of the formulas at these places, in one text. Functions that several of them need are there once.
std::string write_shader(std::span<const std::size_t> places, ShaderLanguage language,
                         ShaderBranches branches = ShaderBranches::real);

} // namespace gonio

#pragma GCC visibility pop
