#include <gonio/base/unit_text.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/rig.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_writer.hpp"
#include "../options/common.hpp"
#include "../options/light_input.hpp"
#include "../options/points_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace gonio::cli {

namespace {

constexpr std::array rig_options{
    Option{"--rig", "RIG", "lights from a rig file (JSON), '-' for standard input"},
};
constexpr std::array probe_options{
    Option{"--method", "METHOD", "how the light of each shape is computed (exact)", "methods"},
    Option{"--compare", "M1,M2", "several methods beside each other, with their errors against exact", "methods"},
    Option{"--view", "X,Y,Z", "direction from the points to the eye: asks for the luminance seen there"},
    Option{"--material", "MATERIAL", "of the surface, for that luminance", "materials"},
    Option{"-j,--jobs", "N", "threads (all processors)"},
};
constexpr std::array report_options{
    Option{"--json", "", "one JSON object, with the share of every light"},
    Option{"--jsonl", "", "the same on one line"},
    Option{"--csv", "", "a table of the points"},
};
constexpr std::array probe_common{
    Option{"-q,--quiet", "", "no warnings, notes or progress"},
    Option{"-h,--help", "", "this text"},
};
constexpr std::array groups{OptionGroup{"lights", rig_options},
                            light_group,
                            points_group,
                            OptionGroup{"evaluation", probe_options},
                            OptionGroup{"report", report_options},
                            OptionGroup{"common options", probe_common}};
constexpr std::array examples{
    Example{"gonio probe --rig room.json --at 0,0,0.8 --normal 0,0,1", "lux on a table, and what each light gives"},
    Example{"gonio probe lamp.ies --position 0,0,2.5 --grid -2,-2,0:4,0,0:0,4,0:21x21",
            "min, mean, max and uniformity on a floor"},
    Example{"gonio probe --shape rect:w=60cm,h=30cm --intensity 4000lm --position 0,0,1 --at 0.5,0,0 "
            "--compare exact,frostbite",
            "what an approximation costs"},
};

constexpr std::size_t numbers_at_once = std::size_t{1} << 22; // shares of lights held at a time
constexpr std::size_t points_at_once = std::size_t{1} << 16;
constexpr std::size_t points_listed = 100; // as text; more are summed up
constexpr std::size_t lights_listed = 32;

enum class Form { text, json, json_line, csv };

struct Request {
    std::string rig; // empty: one light by options
    std::vector<Light> lights;
    Diagnostics diagnostics;
    Points points;
    std::vector<IrradianceMethod> methods; // one, or those compared; `exact` first then
    bool compare = false;
    ProbeOptions options;
    Form form = Form::text;
};

Result<void> read_lights(const Arguments& arguments, Request& request) {
    const auto rig_file = arguments.value("--rig");
    if (!rig_file) {
        Result<LightDescription> description = light_input(arguments, {0.0, 0.0, 0.0}, request.diagnostics);
        if (!description) return pass_on(description);
        Result<Light> light = resolve_light(std::move(*description), request.diagnostics);
        if (!light) return pass_on(light);
        request.lights.push_back(std::move(*light));
        return {};
    }
    if (const std::string_view option = given_light_option(arguments); !option.empty())
        return fail(Failure::usage, fmt::format("--rig and {} are both given", option),
                    "the rig says all of its lights");
    if (!arguments.positional().empty())
        return fail(Failure::usage, "--rig and a profile are both given", "name the profile in the rig");
    request.rig = *rig_file;
    Result<Rig> rig = read_rig_file(*rig_file);
    if (!rig) return pass_on(rig);
    Result<std::vector<Light>> lights = resolve_lights(std::move(*rig), request.diagnostics, request.options.threads);
    if (!lights) return pass_on(lights);
    request.lights = std::move(*lights);
    return {};
}

Result<void> read_methods(const Arguments& arguments, Request& request) {
    const auto compare = arguments.value("--compare");
    const auto method = arguments.value("--method");
    if (compare && method)
        return fail(Failure::usage, "--method and --compare are both given", "name every method in --compare");
    std::string_view rest = compare ? *compare : method ? *method : std::string_view("exact");
    request.compare = compare.has_value();
    if (request.compare) request.methods.push_back(IrradianceMethod::exact);
    for (bool more = true; more;) {
        const std::size_t comma = request.compare ? rest.find(',') : std::string_view::npos;
        Result<IrradianceMethod> parsed = parse_irradiance_method(rest.substr(0, comma));
        if (!parsed) return pass_on(parsed);
        if (std::find(request.methods.begin(), request.methods.end(), *parsed) == request.methods.end())
            request.methods.push_back(*parsed);
        more = comma != std::string_view::npos;
        if (more) rest.remove_prefix(comma + 1);
    }
    return {};
}

Result<void> read_view(const Arguments& arguments, Request& request) {
    const auto view = arguments.value("--view");
    const auto material = arguments.value("--material");
    if (!view && !material) return {};
    if (!view || !material)
        return fail(Failure::usage, view ? "--view is given without --material" : "--material is given without --view",
                    "luminance needs both");
    if (request.compare) return fail(Failure::usage, "--compare compares illuminance, without --view and --material");
    Result<glm::dvec3> direction = parse_vector(*view, "--view");
    if (!direction) return pass_on(direction);
    if (!unit_vector(*direction))
        return fail(Failure::usage, "--view is zero", "it points from the surface to the eye");
    Result<Material> parsed = parse_material(*material);
    if (!parsed) return pass_on(parsed);
    const Diagnostics judged = check_charts(*parsed);
    request.diagnostics.insert(request.diagnostics.end(), judged.begin(), judged.end());
    request.options.view = ProbeView{*direction, *parsed};
    return {};
}

Result<void> read_form(const Arguments& arguments, Request& request) {
    const std::array given{arguments.has("--json"), arguments.has("--jsonl"), arguments.has("--csv")};
    if (std::count(given.begin(), given.end(), true) > 1)
        return fail(Failure::usage, "more than one of --json, --jsonl and --csv is given");
    request.form = given[0] ? Form::json : given[1] ? Form::json_line : given[2] ? Form::csv : Form::text;
    return {};
}

// Everything but the files is checked first: a mistake is told before a large rig is read.
Result<Request> parse(const Arguments& arguments) {
    Request request;
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    request.options.threads = *threads;
    if (arguments.value("--rig") == "-" && arguments.value("--points") == "-")
        return fail(Failure::usage, "standard input cannot be both the rig and the points");
    Result<void> read = read_form(arguments, request);
    if (read) read = read_methods(arguments, request);
    if (read) read = read_view(arguments, request);
    if (!read) return pass_on(read);
    Result<Points> points = points_input(arguments);
    if (!points) return pass_on(points);
    request.points = std::move(*points);
    if (Result<void> lights = read_lights(arguments, request); !lights) return pass_on(lights);
    return request;
}

// Results of a stretch of the points by every method.
struct Stretch {
    std::size_t first = 0;
    std::span<const Receiver> receivers;
    std::vector<ProbeResult> by_method;
};

double relative_error(double value, double truth) {
    return value == truth ? 0.0 : (value - truth) / truth;
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json point_json(const Request& request, const Stretch& stretch, std::size_t i) {
    const Receiver& receiver = stretch.receivers[i];
    const ProbeResult& result = stretch.by_method.front();
    Json json{{"position", vector_json(receiver.position)},
              {"normal", vector_json(unit_vector(receiver.normal).value_or(receiver.normal))},
              {"illuminance_lx", result.illuminance_lx[i]}};
    if (!result.luminance.empty()) {
        const ProbeLuminance& nt = result.luminance[i];
        json["luminance_nt"] = {{"diffuse", nt.diffuse.value},
                                {"specular", nt.specular.value},
                                {"total", (nt.diffuse + nt.specular).value}};
    }
    if (request.compare) {
        Json methods = Json::array();
        for (std::size_t m = 0; m < request.methods.size(); ++m) {
            const double lx = stretch.by_method[m].illuminance_lx[i];
            // The ratio to darkness is no number.
            methods.push_back({{"method", to_text(request.methods[m])},
                               {"illuminance_lx", lx},
                               {"error_lx", lx - result.illuminance_lx[i]},
                               {"error_relative", number_or_null(relative_error(lx, result.illuminance_lx[i]))}});
        }
        json["methods"] = std::move(methods);
    }
    Json lights = Json::array();
    for (std::size_t l = 0; l < request.lights.size(); ++l)
        lights.push_back(
            {{"name", request.lights[l].name}, {"illuminance_lx", result.parts_lx[i * request.lights.size() + l]}});
    json["lights"] = std::move(lights);
    return json;
}

std::string row_text(const glm::dvec3& p) {
    return fmt::format("{},{},{}", shortest(p.x), shortest(p.y), shortest(p.z));
}

std::string position_text(const glm::dvec3& p) {
    return fmt::format("{},{},{}", rounded(p.x), rounded(p.y), rounded(p.z));
}

std::string percent(double relative) {
    if (!std::isfinite(relative)) return "not dark";
    const std::string text = rounded(100.0 * relative, 3);
    return fmt::format("{}{} %", relative > 0.0 ? "+" : "", text);
}

std::string method_column(const Request& request, std::size_t m) {
    return fmt::format("{} lx", to_text(request.methods[m]));
}

class Report {
public:
    Report(const Request& request, Console& console) : request_(request), console_(console) {
        for (std::size_t m = 0; m < request.methods.size(); ++m)
            values_.emplace_back();
    }

    bool wants_parts() const {
        return request_.form == Form::json || request_.form == Form::json_line || (listed() && lights_listed_too());
    }

    void begin() {
        if (request_.form == Form::json || request_.form == Form::json_line) {
            json_.emplace(console_, request_.form == Form::json);
            json_->member("schema", "gonio.probe/1");
            if (!request_.rig.empty()) json_->member("rig", request_.rig);
            json_->member("method", to_text(request_.methods.front()));
            json_->begin_array("points");
        } else if (request_.form == Form::csv) {
            console_.print("x,y,z,nx,ny,nz");
            for (const IrradianceMethod method : request_.methods)
                console_.print(request_.compare ? fmt::format(",illuminance_{}_lx", to_text(method))
                                                : ",illuminance_lx");
            console_.print(request_.options.view ? ",diffuse_nt,specular_nt,total_nt\n" : "\n");
        } else if (request_.compare && listed()) {
            console_.print(fmt::format("{:<24}", "point"));
            for (std::size_t m = 0; m < request_.methods.size(); ++m)
                console_.print(fmt::format("{:>14}{}", method_column(request_, m), m == 0 ? "" : "       error"));
            console_.print("\n");
        }
    }

    void add(const Stretch& stretch) {
        for (std::size_t i = 0; i < stretch.receivers.size(); ++i) {
            if (json_)
                json_->element(point_json(request_, stretch, i));
            else if (request_.form == Form::csv)
                csv_row(stretch, i);
            else if (listed())
                text_lines(stretch, i);
        }
        for (std::size_t m = 0; m < request_.methods.size(); ++m) {
            const std::vector<double>& lx = stretch.by_method[m].illuminance_lx;
            values_[m].insert(values_[m].end(), lx.begin(), lx.end());
        }
        remarks_.add(stretch.by_method.front().remarks, stretch.first);
    }

    void end(Diagnostics& diagnostics) {
        const Diagnostics said = to_diagnostics(remarks_, request_.lights);
        diagnostics.insert(diagnostics.end(), said.begin(), said.end());
        if (json_) {
            json_->end_array();
            if (request_.points.grid) json_->member("grid", grid_json());
            json_->member("diagnostics", diagnostics_json(diagnostics));
            json_->end();
        } else if (request_.form == Form::text && !listed()) {
            summary_text();
        }
    }

private:
    bool listed() const {
        return request_.form == Form::text && !request_.points.grid &&
               request_.points.receivers.size() <= points_listed;
    }
    bool lights_listed_too() const {
        return request_.lights.size() > 1 && request_.lights.size() <= lights_listed && !request_.compare;
    }

    void csv_row(const Stretch& stretch, std::size_t i) {
        const Receiver& r = stretch.receivers[i];
        const glm::dvec3 n = unit_vector(r.normal).value_or(r.normal);
        std::string row = row_text(r.position) + ',' + row_text(n);
        for (const ProbeResult& result : stretch.by_method)
            row += ',' + shortest(result.illuminance_lx[i]);
        if (request_.options.view) {
            const ProbeLuminance& nt = stretch.by_method.front().luminance[i];
            row += fmt::format(",{},{},{}", shortest(nt.diffuse.value), shortest(nt.specular.value),
                               shortest((nt.diffuse + nt.specular).value));
        }
        console_.print(row + '\n');
    }

    void text_lines(const Stretch& stretch, std::size_t i) {
        const std::string position = position_text(stretch.receivers[i].position);
        const ProbeResult& result = stretch.by_method.front();
        const double lx = result.illuminance_lx[i];
        if (request_.compare) {
            std::string line = fmt::format("{:<24}{:>14}", position, rounded(lx));
            for (std::size_t m = 1; m < request_.methods.size(); ++m) {
                const double other = stretch.by_method[m].illuminance_lx[i];
                line += fmt::format("{:>14}{:>12}", rounded(other), percent(relative_error(other, lx)));
            }
            console_.print(line + '\n');
            return;
        }
        console_.print(fmt::format("{:<24}{:>14} lx", position, rounded(lx)));
        if (!result.luminance.empty()) {
            const ProbeLuminance& nt = result.luminance[i];
            console_.print(fmt::format("{:>14} nt (diffuse {}, specular {})", rounded((nt.diffuse + nt.specular).value),
                                       rounded(nt.diffuse.value), rounded(nt.specular.value)));
        }
        console_.print("\n");
        if (!lights_listed_too()) return;
        for (std::size_t l = 0; l < request_.lights.size(); ++l)
            console_.print(fmt::format("  {:<22}{:>14} lx\n", request_.lights[l].name,
                                       rounded(result.parts_lx[i * request_.lights.size() + l])));
    }

    static Json spread_json(const Spread& s) {
        return {{"min_lx", s.least},
                {"mean_lx", s.mean},
                {"max_lx", s.greatest},
                {"uniformity_min_mean", s.uniformity()},
                {"uniformity_min_max", s.diversity()}};
    }

    Json grid_json() const {
        Json json{{"columns", request_.points.grid->across}, {"rows", request_.points.grid->along}};
        json.update(spread_json(spread(values_.front())));
        if (!request_.compare) return json;
        Json methods = Json::array();
        for (std::size_t m = 0; m < request_.methods.size(); ++m) {
            Json of_method{{"method", to_text(request_.methods[m])}};
            of_method.update(spread_json(spread(values_[m])));
            of_method["max_error_lx"] = worst(m).error_lx;
            methods.push_back(std::move(of_method));
        }
        json["methods"] = std::move(methods);
        return json;
    }

    struct Worst {
        double error_lx = 0.0; // the largest in size, signed
        std::size_t point = 0;
    };

    Worst worst(std::size_t m) const {
        Worst found;
        for (std::size_t i = 0; i < values_[m].size(); ++i) {
            const double error = values_[m][i] - values_.front()[i];
            if (std::abs(error) > std::abs(found.error_lx)) found = {error, i};
        }
        return found;
    }

    void summary_text() {
        if (const auto& grid = request_.points.grid)
            console_.print(fmt::format("{} x {} points\n", grid->across, grid->along));
        else
            console_.print(fmt::format("{} points\n", request_.points.receivers.size()));
        struct Line {
            const char* name;
            double (*of)(const Spread&);
        };
        constexpr std::array lines{Line{"min", [](const Spread& s) { return s.least; }},
                                   Line{"mean", [](const Spread& s) { return s.mean; }},
                                   Line{"max", [](const Spread& s) { return s.greatest; }},
                                   Line{"min/mean", [](const Spread& s) { return s.uniformity(); }},
                                   Line{"min/max", [](const Spread& s) { return s.diversity(); }}};
        std::vector<Spread> spreads;
        for (const std::vector<double>& values : values_)
            spreads.push_back(spread(values));
        if (request_.compare) {
            console_.print(fmt::format("{:<10}", ""));
            for (std::size_t m = 0; m < request_.methods.size(); ++m)
                console_.print(fmt::format("{:>14}", method_column(request_, m)));
            console_.print("\n");
        }
        for (std::size_t line = 0; line < lines.size(); ++line) {
            console_.print(fmt::format("{:<10}", lines[line].name));
            for (const Spread& s : spreads)
                console_.print(fmt::format("{:>14}", rounded(lines[line].of(s))));
            console_.print(line < 3 && !request_.compare ? " lx\n" : "\n");
        }
        for (std::size_t m = 1; m < request_.methods.size(); ++m) {
            const Worst w = worst(m);
            console_.print(fmt::format("{} is off by up to {} lx ({}), at {}\n", to_text(request_.methods[m]),
                                       rounded(w.error_lx),
                                       percent(relative_error(values_[m][w.point], values_.front()[w.point])),
                                       position_text(request_.points.receivers[w.point].position)));
        }
    }

    const Request& request_;
    Console& console_;
    std::optional<JsonWriter> json_;
    std::vector<std::vector<double>> values_; // of each method, for the summary
    ProbeRemarks remarks_;
};

Result<int> run_probe(const Arguments& arguments, Console& console) {
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);

    Report report(*request, console);
    request->options.parts = report.wants_parts();
    const std::size_t numbers = request->options.parts ? request->lights.size() : 1;
    const std::size_t at_once =
        std::clamp<std::size_t>(numbers_at_once / std::max<std::size_t>(numbers, 1), 1, points_at_once);
    const std::span<const Receiver> receivers = request->points.receivers;
    for (std::size_t first = 0; first < receivers.size(); first += at_once) {
        Stretch stretch{first, receivers.subspan(first, std::min(at_once, receivers.size() - first)), {}};
        for (std::size_t m = 0; m < request->methods.size(); ++m) {
            ProbeOptions options = request->options;
            options.method = request->methods[m];
            options.parts = options.parts && m == 0;
            Result<ProbeResult> result = probe(request->lights, stretch.receivers, options);
            if (!result) return pass_on(result);
            stretch.by_method.push_back(std::move(*result));
        }
        if (first == 0) report.begin();
        report.add(stretch);
    }
    report.end(request->diagnostics);
    console.say(request->diagnostics);
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = run_probe(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command probe_command;
const Command probe_command{"probe",
                            "illuminance at points, from a rig or one light",
                            "--rig RIG | FILE | --shape SHAPE … --at X,Y,Z",
                            "FILE is an IES or EULUMDAT profile. A rig is a JSON file of schema gonio.rig/1.\n"
                            "Prints lux in double precision; lights neither occlude nor reflect each other.",
                            groups,
                            examples,
                            run,
                            true};

} // namespace gonio::cli
