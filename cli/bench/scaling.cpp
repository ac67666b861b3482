#include <gonio/base/file_set.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/measure/scaling.hpp>
#include <gonio/plot/log_log.hpp>

#include "../interrupt.hpp"
#include "../json_text.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"
#include "../progress.hpp"
#include "modes.hpp"
#include "standings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace gonio::cli {

namespace {

struct Grown {
    const measure::Scaling* scaling;
    std::vector<measure::ScalingCurve> curves;
};

// "512 ns", "1.3 ms": three digits.
std::string duration_text(double ns) {
    constexpr std::array units{std::pair{1e9, "s"}, std::pair{1e6, "ms"}, std::pair{1e3, "us"}, std::pair{1.0, "ns"}};
    for (const auto& [size, name] : units)
        if (ns >= size) return fmt::format("{} {}", rounded(ns / size, 3), name);
    return fmt::format("{} ns", rounded(ns, 3));
}

std::string text_of(const Grown& grown) {
    std::string text = fmt::format("\n{}: {}\n", grown.scaling->name, grown.scaling->summary);
    for (const measure::ScalingCurve& curve : grown.curves) {
        text += fmt::format("  {}\n", curve.name);
        for (const measure::ScalingPoint& point : curve.points) {
            // More threads should take less time; more of anything else should take the same time for each item.
            const double first_ns = curve.points.front().timing.lowest_ns;
            const std::string each = grown.scaling->size == "threads"
                                         ? rounded(first_ns / point.timing.lowest_ns, 3) + " times as fast"
                                         : duration_text(point.timing.lowest_ns / point.size) + " each";
            text += fmt::format("    {:>10} {:<8} {:>10}  {:>18}\n", rounded(point.size), grown.scaling->size,
                                duration_text(point.timing.lowest_ns), each);
        }
    }
    return text;
}

std::string csv_of(const std::vector<Grown>& all, const BenchRun& run) {
    std::string text =
        "scaling,curve,size,size_of,time_ns,time_median_ns,time_highest_ns,samples,seed,processor,gonio,commit,"
        "compiler\n";
    for (const Grown& grown : all)
        for (const measure::ScalingCurve& curve : grown.curves)
            for (const measure::ScalingPoint& point : curve.points)
                text += fmt::format("{},\"{}\",{},{},{},{},{},{},{},\"{}\",{},{},\"{}\"\n", grown.scaling->name,
                                    curve.name, shortest(point.size), grown.scaling->size,
                                    shortest(point.timing.lowest_ns), shortest(point.timing.ns_per_item),
                                    shortest(point.timing.highest_ns), point.timing.samples, run.seed,
                                    run.machine.processor, run.build.version, commit, run.build.compiler);
    return text;
}

std::string json_of(const std::vector<Grown>& all, const BenchRun& run) {
    Json report = run_json(run);
    report["schema"] = "gonio.bench-scaling/1";
    report["complete"] = run.complete;
    report["scalings"] = Json::array();
    for (const Grown& grown : all) {
        Json curves = Json::array();
        for (const measure::ScalingCurve& curve : grown.curves) {
            Json points = Json::array();
            for (const measure::ScalingPoint& point : curve.points)
                points.push_back({{"size", point.size},
                                  {"time_ns", point.timing.lowest_ns},
                                  {"time_median_ns", point.timing.ns_per_item}});
            curves.push_back({{"curve", curve.name}, {"points", std::move(points)}});
        }
        report["scalings"].push_back(
            {{"scaling", grown.scaling->name}, {"size_of", grown.scaling->size}, {"curves", std::move(curves)}});
    }
    report["diagnostics"] = Json::array();
    return dump(report, 2);
}

Result<std::string> chart_of(const std::vector<Grown>& all, const BenchRun& run) {
    std::vector<LogLogPanel> panels;
    for (const Grown& grown : all) {
        LogLogPanel panel{std::string(grown.scaling->name), std::string(grown.scaling->size), "time [ns]", {}, {}};
        for (const measure::ScalingCurve& curve : grown.curves) {
            MarkedSeries series{curve.name, {}, true};
            for (const measure::ScalingPoint& point : curve.points)
                series.points.push_back({point.size, point.timing.lowest_ns});
            panel.series.push_back(std::move(series));
        }
        panels.push_back(std::move(panel));
    }
    LogLogOptions options;
    options.title = "Time against size";
    options.note = run_text(run);
    return log_log_panels(panels, options);
}

Result<void> write_all(const std::vector<std::string>& files, const std::vector<Grown>& all, const BenchRun& run) {
    for (const std::string& file : files) {
        Result<std::string> bytes = file.ends_with(".svg")   ? chart_of(all, run)
                                    : file.ends_with(".csv") ? Result<std::string>(csv_of(all, run))
                                                             : Result<std::string>(json_of(all, run));
        if (!bytes) return pass_on(bytes);
        Result<void> written = write_output(file, *bytes);
        if (!written) return written;
    }
    return {};
}

} // namespace

Result<int> bench_scaling(const Arguments& arguments, Console& console) {
    constexpr std::array<std::string_view, 6> others{"--suite", "--method",   "--stress",
                                                     "--count", "--markdown", "--jsonl"};
    Result<void> fine = refuse_beside("--scaling", others, arguments);
    if (!fine) return pass_on(fine);
    Result<std::vector<const measure::Scaling*>> scalings =
        measure::parse_scalings(arguments.value("--scaling").value_or("all"));
    if (!scalings) return pass_on(scalings);
    measure::ScalingOptions options;
    options.quick = arguments.has("--quick");
    options.stop = interrupted;
    if (const auto text = arguments.value("--seed")) {
        Result<std::uint64_t> seed = whole_number(*text, "--seed");
        if (!seed) return pass_on(seed);
        options.seed = *seed;
    }
    const std::vector<std::string> files = arguments.values("--output");
    fine = check_outputs({}, files);
    if (!fine) return pass_on(fine);
    for (const std::string& file : files) {
        if (!file.ends_with(".svg") && !file.ends_with(".csv") && !file.ends_with(".json"))
            return fail("USE0104", fmt::format("the name '{}' does not end in .svg, .csv or .json", file));
        Result<void> writable = check_writable(file);
        if (!writable) return pass_on(writable);
    }
    BenchRun run;
    run.seed = options.seed;
    run.quick = options.quick;
    const bool words = !arguments.has("--json") && !arguments.has("--csv");
    if (words) console.print(run_text(run) + "\n");
    listen_for_interrupt();
    Progress progress(scalings->size(), console.shows_progress());
    std::vector<Grown> all;
    int status = 0;
    for (const measure::Scaling* scaling : *scalings) {
        if (interrupted()) break;
        progress.show(all.size(), scaling->name);
        Result<std::vector<measure::ScalingCurve>> curves = scaling->measure(options);
        if (!curves) return pass_on(curves);
        all.push_back({scaling, std::move(*curves)});
        progress.clear();
        if (words) console.print(text_of(all.back()));
        status = console.flush(status);
    }
    run.complete = !interrupted();
    if (arguments.has("--csv")) console.print(csv_of(all, run));
    if (arguments.has("--json")) console.print(json_of(all, run));
    const bool any = std::any_of(all.begin(), all.end(), [](const Grown& grown) {
        return std::any_of(grown.curves.begin(), grown.curves.end(),
                           [](const measure::ScalingCurve& curve) { return !curve.points.empty(); });
    });
    if (any) {
        Result<void> written = write_all(files, all, run);
        if (!written) return pass_on(written);
    }
    if (run.complete) return status;
    console.note("stopped by Ctrl-C");
    return worse(status, interrupted_status);
}

} // namespace gonio::cli
