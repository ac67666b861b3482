// Writes what the checks of tests/shader need: the source of every formula in every language, each as a whole shader,
// and for running them poses with the values of the core in double.
//
//   gonio-shader-cases FOLDER BY_HAND
//
// FOLDER/LANGUAGE/FUNCTION.BRANCHES.EXTENSION are shaders for compilers: a fragment or compute stage that calls the
// function; where BY_HAND has FUNCTION.glsl, so is FOLDER/glsl450/FUNCTION.hand.frag. FOLDER/cases/FUNCTION.json has
// what a page needs to run it: source, parameters, inputs, expected values.
#include "../unit/shader/cases.hpp"

#include <gonio/shader/formulas.hpp>
#include <gonio/shader/print.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace {

using namespace gonio;
using namespace gonio::shader;

struct Target {
    std::string_view folder;
    ShaderLanguage language;
    std::string_view extension;
};
constexpr std::array targets{Target{"glsl-es300", ShaderLanguage::glsl_es300, "frag"},
                             Target{"glsl450", ShaderLanguage::glsl450, "frag"},
                             Target{"hlsl", ShaderLanguage::hlsl, "hlsl"},
                             Target{"msl", ShaderLanguage::msl, "metal"},
                             Target{"wgsl", ShaderLanguage::wgsl, "wgsl"},
                             Target{"osl", ShaderLanguage::osl, "osl"}};

// The arguments of a call, from an array of vectors of four numbers. `of` is how a language reads number i.
template<class Of>
std::string arguments_of(const Function& function, std::string_view vector, const Of& of) {
    std::string text;
    std::size_t at = 0;
    for (const Parameter& parameter : function.parameters) {
        if (!parameter.is_used) {
            at += parameter.type == Type::vector ? 3 : 1;
            continue;
        }
        if (!text.empty()) text += ", ";
        if (parameter.type == Type::vector) {
            text += fmt::format("{}({}, {}, {})", vector, of(at), of(at + 1), of(at + 2));
            at += 3;
        } else {
            text += of(at++);
        }
    }
    return text;
}

std::string element(std::size_t i) {
    return fmt::format("inputs[{}].{}", i / 4, "xyzw"[i % 4]);
}

// The printed text in a stage that calls the function with numbers that no compiler knows.
std::string whole_shader(const Target& target, const Function& function, const std::string& text) {
    const bool is_vector = function.result == Type::vector;
    switch (target.language) {
    case ShaderLanguage::glsl_es300:
    case ShaderLanguage::glsl450: {
        const bool es = target.language == ShaderLanguage::glsl_es300;
        const std::string call = fmt::format("{}({})", function.name, arguments_of(function, "vec3", element));
        return fmt::format("{}{}\n{}\nvoid main() {{\n    result = {};\n}}\n",
                           es ? "#version 300 es\n" : "#version 450\n", text,
                           es ? "uniform vec4 inputs[8];\nout vec4 result;\n"
                              : "layout(set = 0, binding = 0) uniform Block { vec4 inputs[8]; };\n"
                                "layout(location = 0) out vec4 result;\n",
                           is_vector ? fmt::format("vec4({}, 1.0)", call) : fmt::format("vec4({})", call));
    }
    case ShaderLanguage::hlsl: {
        const std::string call = fmt::format("{}({})", function.name, arguments_of(function, "float3", element));
        return fmt::format("{}\ncbuffer Block {{\n    float4 inputs[8];\n}};\n\nfloat4 main() : SV_Target {{\n"
                           "    return float4({}, 1.0f);\n}}\n",
                           text, is_vector ? call : "(float3)" + call);
    }
    case ShaderLanguage::msl:
        return text;
    case ShaderLanguage::wgsl: {
        const std::string call = fmt::format("{}({})", function.name, arguments_of(function, "vec3<f32>", element));
        return fmt::format("{}\n@group(0) @binding(0) var<uniform> inputs: array<vec4<f32>, 8>;\n\n@fragment\n"
                           "fn main() -> @location(0) vec4<f32> {{\n    return vec4<f32>({}, 1.0);\n}}\n",
                           text, is_vector ? call : fmt::format("vec3<f32>({})", call));
    }
    case ShaderLanguage::osl: {
        const auto input = [](std::size_t i) { return fmt::format("inputs[{}]", i); };
        const std::string call = fmt::format("{}({})", function.name, arguments_of(function, "vector", input));
        return fmt::format("{}\nshader at(float inputs[32] = {{0}}, output color result = 0) {{\n"
                           "    vector all = vector({});\n    result = color(all[0], all[1], all[2]);\n}}\n",
                           text, call);
    }
    }
    return text;
}

nlohmann::ordered_json case_file(const Formula& formula, const Function& function) {
    constexpr std::size_t count = 10000;
    const std::vector<Case> cases = random_cases(formula, count);
    nlohmann::ordered_json json;
    json["function"] = function.name;
    json["vector"] = function.result == Type::vector;
    json["apart"] = formula.error.apart;
    json["near"] = formula.error.near;
    json["operations"] = operation_count(function);
    json["per_case"] = cases.front().inputs.size();
    json["arguments"] = arguments_of(function, "vec3", [](std::size_t i) { return fmt::format("n[{}]", i); });
    const Formula* const only = &formula;
    json["real"] = printed({&only, 1}, ShaderLanguage::glsl_es300, ShaderBranches::real);
    json["select"] = printed({&only, 1}, ShaderLanguage::glsl_es300, ShaderBranches::select);
    json["real_wgsl"] = printed({&only, 1}, ShaderLanguage::wgsl, ShaderBranches::real);
    json["select_wgsl"] = printed({&only, 1}, ShaderLanguage::wgsl, ShaderBranches::select);
    std::vector<float> inputs;
    std::vector<double> expected, scales;
    std::vector<int> is_near;
    for (const Case& each : cases) {
        inputs.insert(inputs.end(), each.inputs.begin(), each.inputs.end());
        expected.insert(expected.end(), each.expected.begin(), each.expected.end());
        scales.push_back(each.scale);
        is_near.push_back(each.is_near ? 1 : 0);
    }
    json["inputs"] = inputs;
    json["expected"] = expected;
    json["scale"] = scales;
    json["is_near"] = is_near;
    return json;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: gonio-shader-cases FOLDER BY_HAND\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const auto write = [](const std::filesystem::path& file, const std::string& text) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    };
    for (const Formula& formula : formulas()) {
        const Function function = recorded(formula);
        const Formula* const only = &formula;
        for (const Target& target : targets)
            for (const auto& [branches, name] :
                 {std::pair{ShaderBranches::real, "real"}, {ShaderBranches::select, "select"}})
                write(folder / target.folder / fmt::format("{}.{}.{}", function.name, name, target.extension),
                      whole_shader(target, function, printed({&only, 1}, target.language, branches)));
        nlohmann::ordered_json cases = case_file(formula, function);
        const std::filesystem::path by_hand = std::filesystem::path(argv[2]) / (function.name + ".glsl");
        if (std::filesystem::exists(by_hand)) {
            std::ifstream file(by_hand);
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            write(folder / "glsl450" / (function.name + ".hand.frag"), whole_shader(targets[1], function, text));
            cases["hand"] = "precision highp float;\n" + text;
        }
        write(folder / "cases" / (function.name + ".json"), cases.dump());
    }
    return 0;
}
