#include <gonio/base/kind_text.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/picture_size.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/web/profile_header.hpp>

#include "../arguments.hpp"
#include "../batch.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/values.hpp"
#include "../plot/falloff_request.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array diagram_options{
    Option{"--diagram", "KIND", "polar, cartesian, heat-map, isolux, cone, falloff (polar)", "diagrams"},
    Option{"-s,--size", "WxH", "width and height in pixels (720x720; a half circle is less high)"},
    Option{"--plane", "DEG", "polar, cartesian, cone: plane to draw, with the opposite one (0deg 90deg)", {}, true},
    Option{"--per-klm", "", "show candela per 1000 lm, to compare shapes"},
    Option{"--height", "LENGTH", "isolux, cone: height of the light above the plane (3m)"},
    Option{"--extent", "LENGTH", "isolux: distance from the centre of the plane to its edges (twice the height)"},
    Option{"--title", "TEXT", "title of the diagram"},
    Option{"--to", "FORMAT", "svg or an 8-bit picture format, if the file name does not show it (svg)", "images"},
};
constexpr std::array groups{OptionGroup{"diagram", diagram_options},
                            OptionGroup{"falloff", falloff_options},
                            output_group,
                            profile_input_group,
                            threads_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio plot lamp.ies -o lamp.svg", "a polar diagram of the planes C0 and C90"},
    Example{"gonio plot old.ies new.ldt --diagram cartesian --per-klm -o both.svg", "two profiles in one diagram"},
    Example{"gonio plot street.ldt --diagram isolux --height 8m -o street.svg", "lux on the ground"},
    Example{"gonio plot --diagram falloff --shape sphere:r=10cm --shape disk:r=30cm --intensity 800lm -o falloff.png",
            "where lights with a size depart from the inverse square"},
    Example{"gonio plot catalogue -O diagrams", "one diagram for each profile in a folder"},
};

struct Request {
    const DiagramKind* diagram = nullptr;
    PlotOptions plot;
    const media::ImageFormat* format = nullptr; // nullptr: SVG
    ProfileInputOptions input;
};

Result<double> positive_length(const Arguments& arguments, std::string_view name, double otherwise) {
    const auto text = arguments.value(name);
    if (!text) return otherwise;
    Result<double> length = parse_amount(*text, Dimension::length, name);
    if (!length) return pass_on(length);
    if (!(*length > 0.0))
        return fail("USE0105", fmt::format("{} takes a length greater than 0, not '{}'", name, *text));
    return *length;
}

Result<void> read_planes(const Arguments& arguments, PlotOptions& plot) {
    const std::vector<std::string> texts = arguments.values("--plane");
    if (texts.empty()) return {};
    plot.planes_deg.clear();
    for (const std::string& text : texts) {
        Result<double> angle = parse_amount(text, Dimension::angle, "--plane");
        if (!angle) return pass_on(angle);
        plot.planes_deg.push_back(to_degrees(Radians(*angle)));
    }
    return {};
}

Result<Request> parse(const Arguments& arguments) {
    Request request;
    Result<const DiagramKind*> diagram = find_diagram(arguments.value("--diagram").value_or("polar"));
    if (!diagram) return pass_on(diagram);
    request.diagram = *diagram;
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        request.plot.width_px = size->width;
        request.plot.height_px = size->height;
    }
    request.plot.lower_if_half = !arguments.has("--size");
    Result<void> planes = read_planes(arguments, request.plot);
    if (!planes) return pass_on(planes);
    Result<double> height = positive_length(arguments, "--height", request.plot.mounting_height_m);
    if (!height) return pass_on(height);
    Result<double> extent = positive_length(arguments, "--extent", request.plot.extent_m);
    if (!extent) return pass_on(extent);
    request.plot.mounting_height_m = *height;
    request.plot.extent_m = *extent;
    request.plot.per_klm = arguments.has("--per-klm");
    request.plot.title = arguments.value("--title").value_or("");
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    request.input = *input;
    return request;
}

// The file name without its folder: a label has little room.
std::string label_of(const std::string& file) {
    return file == "-" ? "stdin" : file_name(file);
}

PlottedWeb plotted(const std::string& file, const LoadedProfile& loaded, const Request& request) {
    const ProfileHeader header = header_of(loaded.profile, request.input.resolve);
    return {label_of(file), &loaded.web, std::string(luminaire_name(header))};
}

Result<void> write_page(const Result<Drawing>& page, const Request& request, const std::string& output) {
    if (!page) return Unexpected(page.error());
    return write_diagram(*page, request.format, output);
}

Result<void> draw(std::span<const PlottedWeb> webs, const Request& request, const std::string& output) {
    return write_page(request.diagram->draw(webs, request.plot), request, output);
}

// SVG, or a picture format given by --to or by the output's name.
Result<void> read_format(const Arguments& arguments, Request& request) {
    const auto named = arguments.value("--to");
    const std::string output = arguments.value("--output").value_or("");
    const bool by_name = !output.empty() && output != "-";
    if (!named && !by_name) return {};
    Result<const media::ImageFormat*> format = diagram_format(named, output);
    if (!format) return pass_on(format);
    if (*format == nullptr) return {};
    Result<void> fits = check_picture_size(request.plot.width_px, request.plot.height_px);
    if (!fits) error_hint(fits.error(), "use a smaller -s, or write .svg, which has no pixels");
    if (!fits) return fits;
    request.format = *format;
    return {};
}

// All profiles in one diagram. If one cannot be read, nothing is drawn, because that one would be missing.
Result<int> draw_together(const std::vector<std::string>& files, const Request& request, const std::string& output,
                          Console& console) {
    std::vector<LoadedProfile> profiles;
    for (const std::string& file : files) {
        Result<LoadedProfile> loaded = load(file, request.input);
        if (!loaded) return pass_on(loaded);
        console.say(loaded->diagnostics);
        profiles.push_back(std::move(*loaded));
    }
    std::vector<PlottedWeb> webs;
    for (std::size_t i = 0; i < files.size(); ++i)
        webs.push_back(plotted(files[i], profiles[i], request));
    Result<void> drawn = draw(webs, request, output);
    if (!drawn) return pass_on(drawn);
    return 0;
}

int draw_each(const std::vector<Job>& jobs, const Request& request, unsigned threads, Console& console) {
    std::vector<std::string> names;
    for (const Job& job : jobs)
        names.push_back(job.input);
    return run_batch({names, "gonio.plot/1", "drawn", threads}, ReportKind::words, console, [&](std::size_t index) {
        Outcome outcome;
        Result<LoadedProfile> loaded = load(jobs[index].input, request.input);
        if (!loaded) {
            outcome.error = std::move(loaded.error());
            return outcome;
        }
        const PlottedWeb web = plotted(jobs[index].input, *loaded, request);
        Result<void> drawn = draw({&web, 1}, request, jobs[index].output);
        if (!drawn) outcome.error = std::move(drawn.error());
        outcome.diagnostics = std::move(loaded->diagnostics);
        return outcome;
    });
}

Result<int> draw_falloff(const Arguments& arguments, Request& request, Console& console) {
    const std::optional<std::string> output = arguments.value("--output");
    if (!output || arguments.has("--output-dir"))
        return fail("USE0107", "falloff shows all lights in one diagram", "use -o FILE");
    const Result<void> format = read_format(arguments, request);
    if (!format) return Unexpected(format.error());
    Result<FalloffOptions> options = read_falloff(arguments);
    if (!options) return pass_on(options);
    options->width_px = request.plot.width_px;
    options->height_px = request.plot.height_px;
    options->title = request.plot.title;
    Diagnostics diagnostics;
    Result<std::vector<PlottedLight>> lights = falloff_lights(arguments, diagnostics);
    console.say(diagnostics);
    if (!lights) return pass_on(lights);
    if (arguments.has("--dry-run")) {
        console.print(*output + "\n");
        return 0;
    }
    const Result<void> written = write_page(falloff_diagram(*lights, *options), request, *output);
    if (!written) return Unexpected(written.error());
    return 0;
}

Result<int> plot(const Arguments& arguments, Console& console) {
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);
    if (request->diagram->draw == nullptr) return draw_falloff(arguments, *request, console);
    const Result<void> only = no_falloff_options(arguments);
    if (!only) return Unexpected(only.error());
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return pass_on(files);
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    const std::optional<std::string> together = arguments.value("--output");
    const Result<void> format = read_format(arguments, *request);
    if (!format) return Unexpected(format.error());
    if (together && !arguments.has("--output-dir")) {
        const Result<void> free = check_outputs(*files, {&*together, 1});
        if (!free) return Unexpected(free.error());
        if (!arguments.has("--dry-run")) return draw_together(*files, *request, *together, console);
        console.print(*together + "\n");
        return 0;
    }
    Result<std::vector<Job>> jobs =
        plan_outputs(arguments, *files, request->format == nullptr ? "svg" : request->format->extensions.front());
    if (!jobs) return pass_on(jobs);
    std::erase_if(*jobs, [](const Job& job) { return job.skip; });
    if (!arguments.has("--dry-run")) return draw_each(*jobs, *request, *threads, console);
    for (const Job& job : *jobs)
        console.print(fmt::format("{} -> {}\n", job.input, job.output));
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = plot(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command plot_command;
const Command plot_command{"plot",
                           "draw polar, cartesian, heat-map, isolux, cone and falloff diagrams",
                           "FILE… -o OUT.svg | FILE… -o OUT.png | FILE… -O DIR",
                           "FILE is a profile, a folder of profiles, '-' for stdin, or @LIST for a list of files.\n"
                           "With -o all profiles share one diagram; with -O each has its own.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
