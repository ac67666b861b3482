#include <gonio/base/unit_text.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/metrics.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gonio::cli {

namespace {

constexpr std::array compare_options{
    Option{"--rtol", "FRACTION", "tolerance in every direction, as a fraction of the peak (1e-6)"},
    Option{"--smallest-angle", "ANGLE", "differences narrower than this are reported and do not count (0.001deg)"},
};
constexpr std::array groups{OptionGroup{"comparison", compare_options}, profile_input_group, json_group, common_group};
constexpr std::array examples{
    Example{"gonio compare lamp.ies lamp.ldt", "exit status 0 if they are the same light, 1 if not"},
    Example{"gonio compare new.ies old.ies --rtol 0.02", "equal within 2 % of the peak"},
};

constexpr int differ = 1; // exit status

struct Side {
    std::string file;
    double peak_cd = 0.0;
    double flux_lm = 0.0;
};

struct Report {
    Side a;
    Side b;
    WebDifference difference;
    double rtol = 1e-6;
    double smallest_deg = 1e-3; // formats store jumps as ramps 1e-4° wide

    bool equal() const { return difference.relative <= rtol; }
    double flux_difference_lm() const { return b.flux_lm - a.flux_lm; }
    // Relative to the greater flux; empty for two dark webs.
    std::optional<double> flux_relative() const {
        const double most = std::max(std::abs(a.flux_lm), std::abs(b.flux_lm));
        return most > 0.0 ? std::optional(flux_difference_lm() / most) : std::nullopt;
    }
};

Json to_json(const Side& side) {
    return {{"file", side.file}, {"peak_cd", side.peak_cd}, {"flux_lm", side.flux_lm}};
}

Json to_json(const Report& report, const Diagnostics& diagnostics) {
    const WebDifference& d = report.difference;
    return {{"schema", "gonio.compare/1"},
            {"a", to_json(report.a)},
            {"b", to_json(report.b)},
            {"equal", report.equal()},
            {"rtol", report.rtol},
            {"max_difference_cd", d.greatest.value},
            {"max_difference_relative", d.relative},
            {"max_difference_c_deg", d.c_deg},
            {"max_difference_gamma_deg", d.gamma_deg},
            {"a_cd", d.a.value},
            {"b_cd", d.b.value},
            {"rms_difference_cd", d.rms.value},
            {"flux_difference_lm", report.flux_difference_lm()},
            {"flux_difference_relative", number_or_null(report.flux_relative())},
            {"smallest_angle_deg", report.smallest_deg},
            {"max_difference_in_steps_cd", d.in_steps.value},
            {"exact", d.exact},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

std::string to_text(const Report& report) {
    const WebDifference& d = report.difference;
    std::string text = fmt::format("{} and {}: {} within {} of the peak\n", report.a.file, report.b.file,
                                   report.equal() ? "equal" : "not equal", rounded(report.rtol));
    const auto line = [&](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<12}{}\n", name, value);
    };
    line("peak", fmt::format("{} cd and {} cd", rounded(report.a.peak_cd), rounded(report.b.peak_cd)));
    line("flux", fmt::format("{} lm and {} lm, {} % apart", rounded(report.a.flux_lm), rounded(report.b.flux_lm),
                             rounded(100.0 * std::abs(report.flux_relative().value_or(0.0)), 3)));
    line("greatest", d.greatest.value > 0.0
                         ? fmt::format("{} cd, {} of the peak, at C {}°, gamma {}°: {} cd and {} cd",
                                       rounded(d.greatest.value, 4), rounded(d.relative, 3), rounded(d.c_deg),
                                       rounded(d.gamma_deg), rounded(d.a.value), rounded(d.b.value))
                         : std::string("none"));
    if (d.in_steps.value > report.rtol * std::max(report.a.peak_cd, report.b.peak_cd))
        line("steps", fmt::format("{} cd in steps narrower than {}°, which do not count", rounded(d.in_steps.value, 4),
                                  rounded(report.smallest_deg)));
    line("rms", fmt::format("{} cd", rounded(d.rms.value, 4)));
    if (!d.exact) line("note", "two types of goniometer: compared every half degree and at the angles of both tables");
    return text;
}

Result<double> tolerance(const Arguments& arguments) {
    const auto text = arguments.value("--rtol");
    if (!text) return 1e-6;
    const std::optional<double> value = parse_number(*text);
    if (!value || *value < 0.0)
        return fail("USE0105", fmt::format("--rtol takes a fraction of 0 or more, not '{}'", *text),
                    "for example 1e-3");
    return *value;
}

Result<double> smallest_angle_deg(const Arguments& arguments) {
    const auto text = arguments.value("--smallest-angle");
    if (!text) return Report().smallest_deg;
    Result<double> angle = parse_amount(*text, Dimension::angle, "--smallest-angle");
    if (!angle) return angle;
    const double degrees = to_degrees(Radians(*angle));
    if (!(degrees >= 0.0 && degrees <= 1.0))
        return fail("USE0106", fmt::format("--smallest-angle must lie between 0deg and 1deg, not {}", *text));
    return degrees;
}

Result<int> compare(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (files && files->size() != 2)
        return fail("USE0107", fmt::format("compare takes two profiles, not {}", files->size()),
                    "for example: gonio compare lamp.ies lamp.ldt");
    if (!files) return pass_on(files);
    if (files->front() == "-" && files->back() == "-") return fail("USE0108", "stdin cannot be both profiles");
    Result<double> rtol = tolerance(arguments);
    if (!rtol) return pass_on(rtol);
    Result<double> smallest = smallest_angle_deg(arguments);
    if (!smallest) return pass_on(smallest);
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return pass_on(options);
    Result<LoadedProfile> a = load(files->front(), *options);
    if (!a) return pass_on(a);
    Result<LoadedProfile> b = load(files->back(), *options);
    if (!b) return pass_on(b);
    Diagnostics diagnostics = a->diagnostics;
    diagnostics.insert(diagnostics.end(), b->diagnostics.begin(), b->diagnostics.end());
    console.say(diagnostics);

    Report report;
    report.rtol = *rtol;
    report.smallest_deg = *smallest;
    report.difference = difference(a->web, b->web, *smallest);
    report.a = {files->front(), peak(a->web).intensity.value, report.difference.flux_a.value};
    report.b = {files->back(), peak(b->web).intensity.value, report.difference.flux_b.value};
    const bool lines = arguments.has("--jsonl");
    if (lines || arguments.has("--json"))
        console.print(dump(to_json(report, diagnostics), lines ? -1 : 2));
    else
        console.print(to_text(report));
    return report.equal() ? 0 : differ;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = compare(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command compare_command;
const Command compare_command{"compare",
                              "measure how much two profiles differ, and in which direction most",
                              "A B [--rtol FRACTION]",
                              "A and B are profiles of any format; one of them may be '-' for stdin.\n"
                              "Exit status: 0 equal within --rtol of the peak in every direction; 1 not equal.",
                              groups,
                              examples,
                              run};

} // namespace gonio::cli
