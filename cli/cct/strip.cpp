#include "strip.hpp"

#include <gonio/base/picture_size.hpp>
#include <gonio/plot/axis.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/plot/stroke_font.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace gonio::cli {

namespace {

glm::dvec3 shown(Uv at, const CctRequest& request, bool for_display) {
    if (!for_display) return to_space(at, request.space, request.gamut, request.normalize).rgb;
    return to_space(at, *find_rgb_space("rec709"), Gamut::clip, Normalize::max).rgb;
}

constexpr double number_px = 12.0;
constexpr Ink numbers_ink = ink(0xdcdcdc);

struct Label {
    double x = 0.0; // position in the picture
    std::string text;
};

// Round temperatures if the answers are a range of them, else the inputs in the middle of their columns, as far as they
// fit.
std::vector<Label> scale_labels(std::span<const CctAnswer> answers, int width) {
    std::vector<Label> labels;
    const double column = width / static_cast<double>(answers.size());
    const auto kelvin = [&](std::size_t i) { return answers[i].cct ? answers[i].cct->temperature.value : 0.0; };
    bool rising = answers.size() >= 8;
    for (std::size_t i = 0; i < answers.size() && rising; ++i)
        rising = answers[i].kind == CctKind::temperature && answers[i].cct && (i == 0 || kelvin(i) > kelvin(i - 1));
    if (!rising) {
        double free = 0.0;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const double middle = column * (static_cast<double>(i) + 0.5);
            const double half = 0.5 * text_width_px(answers[i].input, number_px) + 4.0;
            if (middle - half < free || middle + half > width) continue;
            free = middle + half;
            labels.push_back({middle, answers[i].input});
        }
        return labels;
    }
    std::size_t i = 0;
    for (const double at : ticks(kelvin(0), kelvin(answers.size() - 1), std::max(2, width / 90))) {
        if (at < kelvin(0) || at > kelvin(answers.size() - 1)) continue;
        while (i + 2 < answers.size() && kelvin(i + 1) < at)
            ++i;
        const double share = (at - kelvin(i)) / (kelvin(i + 1) - kelvin(i));
        labels.push_back({column * (static_cast<double>(i) + 0.5 + share), fmt::format("{:.0f} K", at)});
    }
    return labels;
}

} // namespace

Result<Image> strip(std::span<const CctAnswer> answers, const CctRequest& request, PixelSize size, bool for_display) {
    const std::size_t rows = 1 + answers.front().versus.size();
    for (const CctAnswer& answer : answers)
        if (1 + answer.versus.size() != rows || (rows > 1 && !answer.versus.front().of_color))
            return fail("USE0107", "a picture with --versus compares only colour temperatures");
    if (Result<void> fits = check_picture_size(size.width, size.height + strip_scale_px(size)); !fits)
        return pass_on(fits);
    const auto width = static_cast<std::size_t>(size.width);
    const auto height = static_cast<std::size_t>(size.height);
    if (size.width < 1 || size.height < 1 || width < answers.size() || height < 2 * rows)
        return fail("USE0106",
                    fmt::format("a picture of {}x{} pixels is too small for {} colours{}", size.width, size.height,
                                answers.size(), rows > 1 ? fmt::format(" and {} methods", rows - 1) : std::string()),
                    "use a larger -s");
    Image image(size.width, size.height, 3);
    std::vector<glm::dvec3> column(rows);
    std::size_t done = answers.size(); // the answer in `column`
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
            // The colour itself takes half, the methods share the other half.
            const std::size_t below = height / 2;
            const std::size_t row = rows == 1 || y < below ? 0 : 1 + (y - below) * (rows - 1) / (height - below);
            for (int c = 0; c < 3; ++c)
                image.at(static_cast<int>(x), static_cast<int>(y))[c] = static_cast<float>(column[row][c]);
        }
    }
    return image;
}

int strip_scale_px(PixelSize size) {
    constexpr int scale_px = 24;
    constexpr int least_strip_px = 40;
    return size.height >= least_strip_px + scale_px && size.width >= 160 ? scale_px : 0;
}

Image with_scale(const Image& strip, std::span<const CctAnswer> answers, int scale_px) {
    Image image(strip.width, strip.height + scale_px, 3);
    Drawing page(image.width, image.height, {});
    page.rectangle({0.0, static_cast<double>(strip.height)}, image.width, scale_px, ink(0x17181a));
    for (const Label& label : scale_labels(answers, strip.width)) {
        const double x = std::clamp(label.x, 0.5, image.width - 0.5);
        const double half = 0.5 * text_width_px(label.text, number_px) + 4.0;
        const double middle = std::clamp(x, half, std::fmax(half, image.width - half));
        page.line({x, static_cast<double>(strip.height)}, {x, strip.height + 5.0}, {numbers_ink});
        page.text({middle, strip.height + 18.0}, label.text, {TextAnchor::middle, number_px, numbers_ink});
    }
    const std::size_t methods = answers.front().versus.size();
    const double row_px =
        methods == 0 ? 0.0 : (strip.height - std::floor(0.5 * strip.height)) / static_cast<double>(methods);
    for (std::size_t i = 0; i < methods && row_px >= 13.0; ++i)
        page.text({8.0, std::floor(0.5 * strip.height) + row_px * (static_cast<double>(i) + 0.5) + 4.0},
                  answers.front().versus[i].method, {TextAnchor::start, number_px, ink(0x000000, 0.8)});
    paste(strip, image, 0, 0);
    draw(page, image);
    return image;
}

} // namespace gonio::cli
