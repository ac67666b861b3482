#include <gonio/shader/shader.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/output.hpp"
#include "../shader/request.hpp"

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array formula_options{
    Option{"--light", "LIGHT,…", "sphere, disk, rect, tube, sun, point, spot", "shader-lights"},
    Option{"--method", "METHOD,…", "exact, frostbite, ue4, point, ltc, ltc-share; a window of point, a lobe of spot",
           "shader-methods"},
    Option{"--material", "MATERIAL,…", "its BRDF; with --light, what it reflects of that light", "shader-materials"},
    Option{"--shadow-of", "SHAPE,…", "what a sphere or capsule leaves of a uniform sky"},
    Option{"--what", "WHAT,…", "irradiance, brdf, sample, pdf, shade, roughness, visibility (by the options above)"},
};
constexpr std::array text_options{
    Option{"--lang", "LANG", "glsl-es300, glsl450, hlsl, msl, wgsl, osl (glsl450)", "shader-langs"},
    Option{"--branches", "KIND", "real: return early where a case is simple; select: compute both (real)"},
    Option{"-o,--output", "FILE", "write a file; '-' is stdout, as without this option"},
    durable_option,
};
constexpr std::array groups{OptionGroup{"formula", formula_options}, OptionGroup{"output", text_options}, common_group};
constexpr std::array examples{
    Example{"gonio shader --light rect --lang hlsl", "the exact irradiance of a rectangle"},
    Example{"gonio shader --light sphere,disk,tube --lang wgsl -o lights.wgsl", "several lights in one file"},
    Example{"gonio shader --light tube --method exact,ue4 --lang msl", "an approximation next to the exact form"},
    Example{"gonio shader --material gltf --lang glsl-es300", "a BRDF"},
    Example{"gonio shader --light point --material frostbite", "what it reflects of a point light"},
    Example{"gonio shader --light rect,tube --what sample,pdf", "random directions towards lights"},
    Example{"gonio shader --light rect,tube --material ggx --method ltc --what irradiance,shade",
            "both parts of what a surface reflects"},
    Example{"gonio shader --shadow-of capsule", "ambient occlusion by a capsule"},
    Example{"gonio list shaders", "every function that there is"},
};

int run(const Arguments& arguments, Console& console) {
    const Result<ShaderRequest> request = shader_request(arguments);
    if (!request) return console.fail(request.error());
    const std::string text = write_shader(request->formulas, request->language, request->branches);
    const Result<void> written = write_output(arguments.value("--output").value_or("-"), text);
    return written ? 0 : console.fail(written.error());
}

} // namespace

extern const Command shader_command;
const Command shader_command{
    "shader",
    "print lights and materials as functions of a shading language",
    "--light LIGHT --lang LANG",
    "The functions compute what gonio computes: they are recorded from the same source. A comment gives units,\n"
    "domain, source and measured error. They need nothing but their parameters.",
    groups,
    examples,
    run};

} // namespace gonio::cli
