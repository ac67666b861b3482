#include <gonio/base/named.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/media/color_space.hpp>
#include <gonio/media/detail/color_config.hpp>
#include <gonio/media/detail/open_module.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gonio::media {

namespace {

using detail::Config;
using detail::Processor;

Unexpected not_linear(const std::string& name, const std::string& config, std::string_view what) {
    return fail(Failure::unsupported, fmt::format("the colour space '{}' is {}", name, what),
                "lights are computed in linear spaces of the scene", config);
}

// Finds the matrix of a transform that is not stated as a matrix, from its effect on red, green and blue; refuses it if
// mixtures and multiples of these do not follow the matrix.
Result<glm::dmat3> measured(const Config& config, const std::string& name, const std::string& file) {
    Result<abi::ColorProcessor*> handle = detail::space_processor(config, detail::interchange, name);
    if (!handle) return pass_on(handle);
    const Processor processor(config.module(), *handle);
    constexpr std::size_t count = 7;
    constexpr std::array<std::array<float, 3>, count> probes{{{1, 0, 0},
                                                              {0, 1, 0},
                                                              {0, 0, 1},
                                                              {0.18F, 0.18F, 0.18F},
                                                              {4, 2, 1},
                                                              {0.01F, 0.02F, 0.005F},
                                                              {-0.1F, 0.3F, 0.2F}}};
    std::array<float, 3 * count> pixels{};
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            pixels.at(3 * i + c) = probes.at(i).at(c);
    if (Result<void> applied = processor.apply(pixels.data(), count, 3); !applied) return pass_on(applied);
    const auto result = [&](std::size_t i) {
        return glm::dvec3(pixels.at(3 * i), pixels.at(3 * i + 1), pixels.at(3 * i + 2));
    };
    const glm::dmat3 matrix(result(0), result(1), result(2));
    for (std::size_t i = 3; i < count; ++i) {
        const glm::dvec3 expected = matrix * glm::dvec3(probes.at(i)[0], probes.at(i)[1], probes.at(i)[2]);
        const glm::dvec3 got = result(i);
        const double size = std::abs(expected.x) + std::abs(expected.y) + std::abs(expected.z);
        for (int c = 0; c < 3; ++c)
            if (!(std::abs(got[c] - expected[c]) <= 1e-5 * size))
                return not_linear(name, file, "not linear: it encodes its colours");
    }
    return matrix;
}

} // namespace

Result<SceneLinearSpace> scene_linear_space(const std::string& name, const std::string& file) {
    Result<Config> config = Config::open(file);
    if (!config) return pass_on(config);
    const abi::ColorModule& module = config->module();
    const char* const found = module.find_space(config->get(), name.c_str());
    if (found == nullptr) return detail::unknown("colour space", name, config->spaces());
    SceneLinearSpace space{found, {}, true};
    if (!config->has_space(detail::interchange))
        return fail(Failure::unsupported, "the colour configuration has no role aces_interchange",
                    "colours enter through it: add the role for its ACES2065-1, or give the space by its primaries, "
                    "--space primaries:…",
                    file);
    switch (module.space_kind(config->get(), found)) {
    case abi::space_data:
        return not_linear(space.name, file, "for data, which has no colour");
    case abi::space_display:
        return not_linear(space.name, file, "that of a display");
    default:
        break;
    }
    std::array<double, 9> rows{};
    std::array<char, abi::message_bytes> message{};
    std::int32_t is_matrix = 0;
    if (const int status =
            module.space_matrix(config->get(), detail::interchange, found, rows.data(), &is_matrix, message.data());
        status != 0)
        return fail(detail::cause_of(status),
                    fmt::format("no transform to the colour space '{}': {}", space.name, message.data()), {}, file);
    if (is_matrix == 0) {
        Result<glm::dmat3> matrix = measured(*config, found, file);
        if (!matrix) return pass_on(matrix);
        space.from_aces2065_1 = *matrix;
        space.exact = false;
        return space;
    }
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            space.from_aces2065_1[column][row] =
                rows.at(3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column));
    return space;
}

Result<RgbSpace> rgb_space_of_config(const std::string& name, const std::string& config) {
    Result<SceneLinearSpace> space = scene_linear_space(name, config);
    if (!space) {
        // If no configuration was given, a mistyped name of a built-in space is the more likely mistake.
        if (config.empty() && space.error().failure == Failure::usage) {
            const std::string_view guess = nearest(name, names_of(rgb_spaces()));
            error_hint(space.error(), guess.empty() ? std::string("'gonio list spaces' names those built in; others "
                                                                  "come from a configuration, --ocio FILE")
                                                    : fmt::format("did you mean '{}'?", guess));
        }
        return pass_on(space);
    }
    return rgb_space_of_aces(space->name, space->from_aces2065_1);
}

} // namespace gonio::media
