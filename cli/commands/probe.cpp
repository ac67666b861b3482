#include <gonio/base/unit_text.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/scene/probe.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_writer.hpp"
#include "../options/common.hpp"
#include "../options/light_input.hpp"
#include "../options/points_input.hpp"
#include "../options/rig_input.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace gonio::cli {

namespace {

constexpr std::array probe_options{
    Option{"--method", "METHOD", "how the light of each shape is computed (exact)", "methods"},
    Option{"--compare", "M1,M2", "several methods beside each other, with their errors against the true one",
           "methods"},
    Option{"--error", "E", "relative error that the method reference may have (1e-6)"},
    Option{"--view", "X,Y,Z", "direction from the points to the eye, or at:X,Y,Z its place: asks for luminance"},
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
    Example{"gonio probe --shape tube:r=2cm,l=1.2m --intensity 2500lm --position 0,0,2 --at 0,0,0 "
            "--view 1,0,1 --material frostbite:smoothness=0.7 --method reference --error 1e-8",
            "what the eye sees of a glossy floor, with the error that is left"},
    Example{"gonio probe --shape sphere:r=20cm --intensity 800lm --position 0,1,1 --at 0,0,0 "
            "--view 0,-1,1 --material frostbite:smoothness=0.8 --compare representative-point",
            "how far a highlight's approximation is off"},
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
    std::vector<IrradianceMethod> methods; // one, or those compared; then the true one first
    bool compare = false;
    ProbeOptions options;
    Form form = Form::text;
};

Result<void> read_lights(const Arguments& arguments, Request& request) {
    Result<LightsInput> input = lights_input(arguments, LightPlacement{glm::dvec3(0.0)}, request.diagnostics);
    if (!input) return pass_on(input);
    request.rig = input->rig_file;
    Result<std::vector<Light>> lights = resolve_input(std::move(*input), request.diagnostics, request.options.threads);
    if (!lights) return pass_on(lights);
    request.lights = std::move(*lights);
    return {};
}

Result<void> read_error(const Arguments& arguments, Request& request) {
    const auto given = arguments.value("--error");
    if (!given) return {};
    if (std::find(request.methods.begin(), request.methods.end(), IrradianceMethod::reference) == request.methods.end())
        return fail(Failure::usage, "--error is given without the method reference", "add --method reference");
    const std::optional<double> error = parse_number(*given);
    if (!error || !(*error >= 1e-12) || !(*error <= 0.1))
        return fail(Failure::usage, fmt::format("--error must lie in [1e-12, 0.1], not '{}'", *given),
                    "it is relative: 1e-4 is a hundredth of a percent");
    request.options.goal.relative_error = *error;
    return {};
}

Result<void> read_methods(const Arguments& arguments, Request& request) {
    const auto compare = arguments.value("--compare");
    const auto method = arguments.value("--method");
    if (compare && method)
        return fail(Failure::usage, "--method and --compare are both given", "name every method in --compare");
    std::string_view rest = compare ? *compare : method ? *method : std::string_view("exact");
    request.compare = compare.has_value();
    // Of luminance the quadrature is the truth, of illuminance the closed forms are.
    if (request.compare)
        request.methods.push_back(arguments.has("--view") ? IrradianceMethod::reference : IrradianceMethod::exact);
    for (bool more = true; more;) {
        const std::size_t comma = request.compare ? rest.find(',') : std::string_view::npos;
        Result<IrradianceMethod> parsed = parse_irradiance_method(rest.substr(0, comma));
        if (!parsed) return pass_on(parsed);
        if (std::find(request.methods.begin(), request.methods.end(), *parsed) == request.methods.end())
            request.methods.push_back(*parsed);
        more = comma != std::string_view::npos;
        if (more) rest.remove_prefix(comma + 1);
    }
    return read_error(arguments, request);
}

Result<void> read_view(const Arguments& arguments, Request& request) {
    const auto view = arguments.value("--view");
    const auto material = arguments.value("--material");
    if (!view && !material) return {};
    if (!view || !material)
        return fail(Failure::usage, view ? "--view is given without --material" : "--material is given without --view",
                    "luminance needs both");
    constexpr std::string_view place = "at:";
    const bool is_place = view->starts_with(place);
    Result<glm::dvec3> vector = parse_vector(is_place ? view->substr(place.size()) : *view, "--view");
    if (!vector) return pass_on(vector);
    if (!is_place && !unit_vector(*vector))
        return fail(Failure::usage, "--view is zero", "it points from the surface to the eye");
    Result<Material> parsed = parse_material(*material);
    if (!parsed) return pass_on(parsed);
    const Diagnostics judged = check_charts(*parsed);
    request.diagnostics.insert(request.diagnostics.end(), judged.begin(), judged.end());
    request.options.view = ProbeView{*vector, *parsed};
    if (is_place) request.options.view->eye = *vector;
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

// What is compared: the luminance where one is asked for, else the illuminance.
double compared(const ProbeResult& result, std::size_t i) {
    return result.luminance.empty() ? result.illuminance_lx[i] : result.luminance[i].total().value;
}

Json luminance_json(const ProbeLuminance& nt, bool with_error) {
    Json json{{"diffuse", nt.diffuse.value}, {"specular", nt.specular.value}, {"total", nt.total().value}};
    if (with_error) json["error_estimate"] = nt.error_estimate.value;
    return json;
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

// One of the methods compared at a point, beside the first of them.
Json method_json(const Request& request, const Stretch& stretch, std::size_t m, std::size_t i) {
    const ProbeResult& truth = stretch.by_method.front();
    const ProbeResult& result = stretch.by_method[m];
    const double lx = result.illuminance_lx[i];
    // The ratio to darkness is no number.
    Json json{{"method", to_text(request.methods[m])},
              {"illuminance_lx", lx},
              {"error_lx", lx - truth.illuminance_lx[i]},
              {"error_relative", number_or_null(relative_error(lx, truth.illuminance_lx[i]))}};
    if (result.luminance.empty()) return json;
    const double nt = compared(result, i);
    const double true_nt = compared(truth, i);
    json["luminance_nt"] = luminance_json(result.luminance[i], false);
    json["error_nt"] = nt - true_nt;
    json["error_nt_relative"] = number_or_null(relative_error(nt, true_nt));
    return json;
}

Json point_json(const Request& request, const Stretch& stretch, std::size_t i) {
    const Receiver& receiver = stretch.receivers[i];
    const ProbeResult& result = stretch.by_method.front();
    const bool estimated = !result.illuminance_error_lx.empty();
    Json json{{"position", vector_json(receiver.position)},
              {"normal", vector_json(unit_vector(receiver.normal).value_or(receiver.normal))},
              {"illuminance_lx", result.illuminance_lx[i]}};
    if (estimated) json["illuminance_error_lx"] = result.illuminance_error_lx[i];
    if (!result.luminance.empty()) json["luminance_nt"] = luminance_json(result.luminance[i], estimated);
    if (request.compare) {
        Json methods = Json::array();
        for (std::size_t m = 0; m < request.methods.size(); ++m)
            methods.push_back(method_json(request, stretch, m, i));
        json["methods"] = std::move(methods);
    }
    Json lights = Json::array();
    for (std::size_t l = 0; l < request.lights.size(); ++l) {
        const std::size_t part = i * request.lights.size() + l;
        Json light{{"name", request.lights[l].name}, {"illuminance_lx", result.parts_lx[part]}};
        if (!result.parts_nt.empty()) light["luminance_nt"] = luminance_json(result.parts_nt[part], estimated);
        lights.push_back(std::move(light));
    }
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

std::string luminance_text(const ProbeLuminance& nt) {
    return fmt::format("{:>14} nt (diffuse {}, specular {})", rounded(nt.total().value), rounded(nt.diffuse.value),
                       rounded(nt.specular.value));
}

// Heading and width of the column of a method in a comparison.
std::string method_column(const Request& request, std::size_t m) {
    return fmt::format("{} {}", to_text(request.methods[m]), request.options.view ? "nt" : "lx");
}
std::size_t column_width(const Request& request, std::size_t m) {
    return std::max<std::size_t>(14, method_column(request, m).size() + 2);
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
            print_csv_heading();
        } else if (request_.compare && listed()) {
            console_.print(fmt::format("{:<24}", "point"));
            for (std::size_t m = 0; m < request_.methods.size(); ++m)
                console_.print(fmt::format("{:>{}}{}", method_column(request_, m), column_width(request_, m),
                                           m == 0 ? "" : "       error"));
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
            const ProbeResult& result = stretch.by_method[m];
            for (std::size_t i = 0; i < stretch.receivers.size(); ++i)
                values_[m].push_back(request_.compare ? compared(result, i) : result.illuminance_lx[i]);
        }
        note_error(stretch.by_method.front());
        remarks_.add(stretch.by_method.front().remarks, stretch.first);
    }

    void end(Diagnostics& diagnostics) {
        const Diagnostics said = to_diagnostics(remarks_, request_.lights);
        diagnostics.insert(diagnostics.end(), said.begin(), said.end());
        if (json_) {
            json_->end_array();
            if (request_.methods.front() == IrradianceMethod::reference)
                json_->member("error_estimate", largest_error_);
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

    // The largest error that the quadrature leaves open, relative to its value.
    void note_error(const ProbeResult& result) {
        const auto note = [&](double error, double value) {
            if (value > 0.0) largest_error_ = std::max(largest_error_, error / value);
        };
        for (std::size_t i = 0; i < result.illuminance_error_lx.size(); ++i) {
            note(result.illuminance_error_lx[i], result.illuminance_lx[i]);
            if (!result.luminance.empty())
                note(result.luminance[i].error_estimate.value, result.luminance[i].total().value);
        }
    }

    bool estimated() const { return request_.methods.front() == IrradianceMethod::reference; }

    void print_csv_heading() {
        if (request_.compare) {
            for (const IrradianceMethod method : request_.methods)
                console_.print(fmt::format(",illuminance_{}_lx", to_text(method)));
            for (const IrradianceMethod method : request_.methods)
                if (request_.options.view) console_.print(fmt::format(",total_{}_nt", to_text(method)));
            console_.print("\n");
            return;
        }
        console_.print(estimated() ? ",illuminance_lx,illuminance_error_lx" : ",illuminance_lx");
        if (request_.options.view) console_.print(",diffuse_nt,specular_nt,total_nt");
        console_.print(request_.options.view && estimated() ? ",error_nt\n" : "\n");
    }

    void csv_row(const Stretch& stretch, std::size_t i) {
        const Receiver& r = stretch.receivers[i];
        const glm::dvec3 n = unit_vector(r.normal).value_or(r.normal);
        std::string row = row_text(r.position) + ',' + row_text(n);
        const ProbeResult& first = stretch.by_method.front();
        for (const ProbeResult& result : stretch.by_method)
            row += ',' + shortest(result.illuminance_lx[i]);
        if (request_.compare) {
            for (const ProbeResult& result : stretch.by_method)
                if (!result.luminance.empty()) row += ',' + shortest(result.luminance[i].total().value);
        } else {
            if (estimated()) row += ',' + shortest(first.illuminance_error_lx[i]);
            if (request_.options.view) {
                const ProbeLuminance& nt = first.luminance[i];
                row += fmt::format(",{},{},{}", shortest(nt.diffuse.value), shortest(nt.specular.value),
                                   shortest(nt.total().value));
                if (estimated()) row += ',' + shortest(nt.error_estimate.value);
            }
        }
        console_.print(row + '\n');
    }

    void text_lines(const Stretch& stretch, std::size_t i) {
        const std::string position = position_text(stretch.receivers[i].position);
        const ProbeResult& result = stretch.by_method.front();
        const double lx = result.illuminance_lx[i];
        if (request_.compare) {
            const double truth = compared(result, i);
            std::string line = fmt::format("{:<24}{:>{}}", position, rounded(truth), column_width(request_, 0));
            for (std::size_t m = 1; m < request_.methods.size(); ++m) {
                const double other = compared(stretch.by_method[m], i);
                line += fmt::format("{:>{}}{:>12}", rounded(other), column_width(request_, m),
                                    percent(relative_error(other, truth)));
            }
            console_.print(line + '\n');
            return;
        }
        console_.print(fmt::format("{:<24}{:>14} lx", position, rounded(lx)));
        if (estimated()) console_.print(fmt::format(" ±{}", rounded(result.illuminance_error_lx[i], 2)));
        if (!result.luminance.empty()) {
            console_.print(luminance_text(result.luminance[i]));
            if (estimated()) console_.print(fmt::format(" ±{}", rounded(result.luminance[i].error_estimate.value, 2)));
        }
        console_.print("\n");
        if (!lights_listed_too()) return;
        for (std::size_t l = 0; l < request_.lights.size(); ++l) {
            const std::size_t part = i * request_.lights.size() + l;
            console_.print(fmt::format("  {:<22}{:>14} lx", request_.lights[l].name, rounded(result.parts_lx[part])));
            if (!result.parts_nt.empty()) console_.print(luminance_text(result.parts_nt[part]));
            console_.print("\n");
        }
    }

    std::string_view compared_unit() const { return request_.compare && request_.options.view ? "nt" : "lx"; }

    Json spread_json(const Spread& s) const {
        const std::string_view unit = compared_unit();
        return {{fmt::format("min_{}", unit), s.least},
                {fmt::format("mean_{}", unit), s.mean},
                {fmt::format("max_{}", unit), s.greatest},
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
            of_method[fmt::format("max_error_{}", compared_unit())] = worst(m).error;
            methods.push_back(std::move(of_method));
        }
        json["methods"] = std::move(methods);
        return json;
    }

    struct Worst {
        double error = 0.0; // the largest in size, signed
        std::size_t point = 0;
    };

    Worst worst(std::size_t m) const {
        Worst found;
        for (std::size_t i = 0; i < values_[m].size(); ++i) {
            const double error = values_[m][i] - values_.front()[i];
            if (std::abs(error) > std::abs(found.error)) found = {error, i};
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
                console_.print(fmt::format("{:>{}}", method_column(request_, m), column_width(request_, m)));
            console_.print("\n");
        }
        for (std::size_t line = 0; line < lines.size(); ++line) {
            console_.print(fmt::format("{:<10}", lines[line].name));
            for (std::size_t m = 0; m < spreads.size(); ++m)
                console_.print(fmt::format("{:>{}}", rounded(lines[line].of(spreads[m])),
                                           request_.compare ? column_width(request_, m) : 14));
            console_.print(line < 3 && !request_.compare ? " lx\n" : "\n");
        }
        for (std::size_t m = 1; m < request_.methods.size(); ++m) {
            const Worst w = worst(m);
            console_.print(fmt::format("{} is off by up to {} {} ({}), at {}\n", to_text(request_.methods[m]),
                                       rounded(w.error), compared_unit(),
                                       percent(relative_error(values_[m][w.point], values_.front()[w.point])),
                                       position_text(request_.points.receivers[w.point].position)));
        }
    }

    const Request& request_;
    Console& console_;
    std::optional<JsonWriter> json_;
    std::vector<std::vector<double>> values_; // of each method, for the summary
    double largest_error_ = 0.0;              // relative, of `reference`
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
                            "illuminance and luminance at points, from a rig or one light",
                            "--rig RIG | FILE | --shape SHAPE … --at X,Y,Z",
                            "FILE is an IES or EULUMDAT profile. A rig is a JSON file of schema gonio.rig/1.\n"
                            "Prints lux in double precision, and with --view and --material the luminance that\n"
                            "the eye sees there, in nits; lights neither occlude nor reflect each other.",
                            groups,
                            examples,
                            run,
                            true};

} // namespace gonio::cli
