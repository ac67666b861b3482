#include "refine.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/preview/reference_picture.hpp>

#include "../interrupt.hpp"
#include "../progress.hpp"
#include "../stopwatch.hpp"
#include "request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace gonio::cli {

namespace {

constexpr double standard_error = 0.01;
constexpr std::size_t least_passes = 8; // before the error estimate is trusted

// "1%" or "0.01".
Result<double> parse_error(std::string_view text) {
    const bool percent = text.ends_with('%');
    const std::optional<double> number = parse_number(percent ? text.substr(0, text.size() - 1) : text);
    const double error = number.value_or(-1.0) * (percent ? 0.01 : 1.0);
    if (error == 0.0) return fail("USE0106", "--error 0 would never end", "for example --error 1%, or --time 30s");
    if (!(error >= 1e-12) || !(error <= 0.5))
        return fail("USE0106", fmt::format("--error must lie in [1e-12, 0.5], not '{}'", text),
                    "it is relative: 1% is 0.01");
    return error;
}

// "30s".
Result<double> parse_time_ms(std::string_view text) {
    constexpr std::array units{std::pair{"ms", 1.0}, std::pair{"min", 6e4}, std::pair{"s", 1e3}, std::pair{"h", 3.6e6}};
    for (const auto& [unit, ms] : units) {
        if (!text.ends_with(unit)) continue;
        const std::optional<double> number = parse_number(text.substr(0, text.size() - std::string_view(unit).size()));
        if (!number) break;
        if (*number == 0.0) return fail("USE0106", "--time must be greater than 0", "for example --time 30s");
        if (!(*number > 0.0) || !(*number * ms <= 1e9)) break;
        return *number * ms;
    }
    return fail("USE0105", fmt::format("--time takes a duration, not '{}'", text),
                "for example 500ms, 30s, 2min or 1h");
}

} // namespace

Result<ReferenceBudget> reference_budget(const Arguments& arguments, bool by_reference) {
    ReferenceBudget budget;
    const auto error = arguments.value("--error");
    const auto time = arguments.value("--time");
    if (time && !by_reference) return fail("USE0104", "--time needs the method reference", "add --method reference");
    if (error && !by_reference)
        return fail("USE0104", "--error needs the method exact, ltc or reference", "add --method reference");
    for (const std::string_view option : {"--aov", "--compare", "--sheet", "--sweep"})
        if (time && arguments.has(option))
            return fail("USE0107", fmt::format("--time is for one picture, not for {}", option),
                        "there --error ends the method reference");
    if (error) {
        Result<double> parsed = parse_error(*error);
        if (!parsed) return pass_on(parsed);
        budget.relative_error = *parsed;
    }
    if (time) {
        Result<double> parsed = parse_time_ms(*time);
        if (!parsed) return pass_on(parsed);
        budget.milliseconds = *parsed;
    }
    if (!error && !time) budget.relative_error = standard_error;
    return budget;
}

Result<RefinedPicture> refine(const PreviewRequest& request, std::span<const Light> lights, const Console& console) {
    Result<ReferencePicture> picture =
        ReferencePicture::begin(request.stage, lights, request.stage.camera, request.render);
    if (!picture) return pass_on(picture);
    const ReferenceBudget& budget = request.budget;
    listen_for_interrupt();
    const Stopwatch watch;
    constexpr std::size_t steps = 1000;
    Progress progress(steps, console.shows_progress());
    // Any picture is better than none: the time limit does not end the first pass.
    const auto is_over = [&] { return budget.milliseconds && watch.milliseconds() >= *budget.milliseconds; };
    RefinedPicture refined;
    bool good = false;
    while (!good && !interrupted() && (picture->passes() == 0 || !is_over())) {
        picture->add_pass([&] { return interrupted() || (picture->passes() > 0 && is_over()); });
        refined.error_estimate = picture->error_estimate();
        good = budget.relative_error && picture->passes() >= least_passes &&
               refined.error_estimate <= *budget.relative_error;
        // Noise falls at least with the square root of the number of passes.
        double done = budget.relative_error && refined.error_estimate > 0.0
                          ? std::min(*budget.relative_error / refined.error_estimate, 1.0)
                          : 0.0;
        done *= done;
        if (budget.milliseconds) done = std::max(done, watch.milliseconds() / *budget.milliseconds);
        progress.show(std::min(static_cast<std::size_t>(done * steps), steps - 1),
                      fmt::format("pass {}, error {:.2g} %", picture->passes(), 100.0 * refined.error_estimate));
    }
    progress.clear();
    refined.passes = picture->passes();
    refined.interrupted = interrupted() && !good;
    if (refined.interrupted && refined.passes == 0)
        console.note("warning: stopped by Ctrl-C during the first pass: the part that it did not reach is black");
    else if (refined.interrupted)
        console.note(fmt::format("warning: stopped by Ctrl-C after {} passes, with an error of about {:.2g} %",
                                 refined.passes, 100.0 * refined.error_estimate));
    else
        console.remark(
            fmt::format("{} passes, an error of about {:.2g} %", refined.passes, 100.0 * refined.error_estimate));
    refined.rendering = picture->picture();
    return refined;
}

} // namespace gonio::cli
