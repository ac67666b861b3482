#include <gonio/shader/formulas.hpp>
#include <gonio/shader/print.hpp>
#include <gonio/shader/shader.hpp>

#include <array>
#include <vector>

namespace gonio {

std::span<const ShaderLanguageName> shader_languages() {
    static constexpr std::array languages{
        ShaderLanguageName{"glsl-es300", ShaderLanguage::glsl_es300, "GLSL ES 3.00: WebGL 2, OpenGL ES 3"},
        ShaderLanguageName{"glsl450", ShaderLanguage::glsl450, "GLSL 4.50: Vulkan, OpenGL"},
        ShaderLanguageName{"hlsl", ShaderLanguage::hlsl, "HLSL: Direct3D, shader model 5 and later"},
        ShaderLanguageName{"msl", ShaderLanguage::msl, "Metal Shading Language"},
        ShaderLanguageName{"wgsl", ShaderLanguage::wgsl, "WGSL: WebGPU"},
        ShaderLanguageName{"osl", ShaderLanguage::osl, "Open Shading Language: Cycles, Arnold, RenderMan"},
    };
    return languages;
}

std::size_t shader_formula_count() {
    return shader::formulas().size();
}

ShaderFormulaInfo shader_formula(std::size_t place) {
    const shader::Formula& formula = shader::formulas()[place];
    return {formula.names, formula.function, formula.title, formula.error};
}

std::string write_shader(std::span<const std::size_t> places, ShaderLanguage language, ShaderBranches branches) {
    std::vector<const shader::Formula*> chosen;
    for (const std::size_t place : places)
        chosen.push_back(&shader::formulas()[place]);
    return shader::printed(chosen, language, branches);
}

} // namespace gonio
