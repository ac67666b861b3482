#include "strip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gonio::cli {

namespace {

glm::dvec3 shown(Uv at, const CctRequest& request, bool for_display) {
    if (!for_display) return to_space(at, request.space, request.gamut, request.normalize).rgb;
    return to_space(at, *find_rgb_space("rec709"), Gamut::clip, Normalize::max).rgb;
}

} // namespace

Result<Image> strip(std::span<const CctAnswer> answers, const CctRequest& request, PixelSize size, bool for_display) {
    const std::size_t rows = 1 + answers.front().versus.size();
    for (const CctAnswer& answer : answers)
        if (1 + answer.versus.size() != rows || (rows > 1 && !answer.versus.front().of_color))
            return fail(Failure::usage, "--versus in a picture compares colours of temperatures only");
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    if (size.width < 1 || size.height < 1 || width < answers.size() || height < 2 * rows)
        return fail(Failure::usage,
                    fmt::format("a picture of {}x{} pixels has no room for {} colours{}", size.width, size.height,
                                answers.size(), rows > 1 ? fmt::format(" and {} methods", rows - 1) : std::string()),
                    "use a larger -s");
    Image image(size.width, size.height, 3);
    std::vector<glm::dvec3> column(rows);
    std::size_t done = answers.size(); // the answer that `column` holds
    for (std::size_t x = 0; x < width; ++x) {
        const std::size_t i = x * answers.size() / width;
        if (i != done) {
            const CctAnswer& answer = answers[i];
            column[0] = shown(answer.at, request, for_display);
            for (std::size_t row = 1; row < rows; ++row)
                column[row] = shown(answer.versus[row - 1].of_color->at, request, for_display);
            done = i;
        }
        for (std::size_t y = 0; y < height; ++y) {
            // The colour itself takes half, the methods share the rest.
            const std::size_t below = height / 2;
            const std::size_t row = rows == 1 || y < below ? 0 : 1 + (y - below) * (rows - 1) / (height - below);
            for (int c = 0; c < 3; ++c)
                image.at(static_cast<int>(x), static_cast<int>(y))[c] = static_cast<float>(column[row][c]);
        }
    }
    return image;
}

} // namespace gonio::cli
