#include <gonio/sky/sky.hpp>
#include <gonio/sky/sky_description.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/values.hpp"
#include "../sky/sky_report.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::array groups{json_group, threads_group, common_group};
constexpr std::array examples{
    Example{"gonio sky info cie:12,sun=180/40,horizontal=20klx", "a clear sky: lux on the ground and on walls"},
    Example{"gonio sky info daylight:place=52.52/13.405,time=2024-06-21T12:00+02:00 --json",
            "sky and sun at a place and time"},
};

Outcome info(const std::string& text) {
    Outcome outcome;
    Result<SkyDescription> description = parse_sky_description(text, &outcome.diagnostics);
    if (!description) {
        outcome.error = std::move(description.error());
        return outcome;
    }
    Result<Sky> sky = resolve_sky(*description);
    if (!sky) {
        outcome.error = std::move(sky.error());
        return outcome;
    }
    const SkyReport report = report_of(text, name_of(description->kind), *sky, outcome.diagnostics);
    outcome.words = to_text(report);
    outcome.report = to_json(report, outcome.diagnostics);
    return outcome;
}

Result<int> info_all(const Arguments& arguments, Console& console) {
    const std::vector<std::string> skies(arguments.positional().begin() + 1, arguments.positional().end());
    if (skies.empty())
        return fail("USE0104", "no sky is given", "for example: gonio sky info cie:12,sun=180/40,horizontal=20klx");
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    const ReportKind kind = report_kind(arguments);
    return run_batch({skies, "gonio.sky/1", "measured", *threads}, kind, console, [&](std::size_t index) {
        Outcome outcome = info(skies[index]);
        if (kind == ReportKind::words) outcome.report = nullptr;
        return outcome;
    });
}

Result<int> work(const Arguments& arguments, Console& console) {
    const std::vector<std::string>& words = arguments.positional();
    if (words.empty()) return fail("USE0104", "info?", "gonio sky info SKY measures a sky");
    if (words.front() == "info") return info_all(arguments, console);
    return fail("USE0103", fmt::format("unknown action '{}'", words.front()),
                fmt::format("write gonio sky info '{}'", words.front()));
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = work(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command sky_command;
const Command sky_command{"sky",
                          "measure skies and daylight in lux",
                          "info SKY…",
                          "SKY is an amount (500lx) or KIND:key=value,…: 'gonio list skies' shows the kinds.\n"
                          "Azimuths count from north over east; z is up and +Y is north.",
                          groups,
                          examples,
                          run};

} // namespace gonio::cli
