#include <gonio/base/file.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/profile_input.hpp"

#include <fmt/format.h>

#include <array>

namespace gonio::cli {

namespace {

constexpr std::array sample_options{
    Option{"--at", "C,GAMMA", "a direction in degrees", {}, true},
};
constexpr std::array report_options{
    Option{"--csv", "", "a CSV table: C, gamma and candela"},
    json_options[0],
    json_options[1],
};
constexpr std::array groups{OptionGroup{"directions", sample_options}, profile_input_group,
                            OptionGroup{"report", report_options}, common_group};
constexpr std::array examples{
    Example{"gonio sample lamp.ies --at 0,30", "candela 30° from the nadir in the C0 plane"},
    Example{"printf '0,0\\n90,45\\n' | gonio sample lamp.ldt -", "directions from stdin, one per line"},
};

struct Direction {
    double c_deg;
    double gamma_deg;
};

Result<Direction> parse_direction(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma != std::string_view::npos) {
        const auto c = parse_number(trimmed(text.substr(0, comma)));
        const auto gamma = parse_number(trimmed(text.substr(comma + 1)));
        if (c && gamma && *gamma >= 0.0 && *gamma <= 180.0) return Direction{*c, *gamma};
        if (c && gamma) return fail("USE0106", fmt::format("gamma must lie between 0 and 180 degrees, not {}", *gamma));
    }
    return fail("USE0105", fmt::format("'{}' is not a direction", text), "write C,GAMMA in degrees, for example 90,30");
}

// One direction per line; empty lines are skipped.
Result<std::vector<Direction>> read_directions() {
    Result<std::string> text = read_standard_input();
    if (!text) return pass_on(text);
    std::vector<Direction> directions;
    std::string_view rest = *text;
    for (std::uint32_t line = 1; !rest.empty(); ++line) {
        const std::size_t end = rest.find('\n');
        const std::string_view word = trimmed(rest.substr(0, end));
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        if (word.empty()) continue;
        Result<Direction> direction = parse_direction(word);
        if (!direction) {
            Error error = std::move(direction.error());
            error.failure = Failure::malformed;
            error.diagnostics.back().location = {"-", line, 1};
            return Unexpected(std::move(error));
        }
        directions.push_back(*direction);
    }
    return directions;
}

Result<int> sample(const Arguments& arguments, Console& console) {
    std::vector<std::string> files = arguments.positional();
    const std::vector<std::string> at = arguments.values("--at");
    const bool from_pipe = files.size() == 2 && files[1] == "-" && at.empty();
    if (from_pipe) files.pop_back();
    if (files.size() != 1)
        return fail("USE0107", fmt::format("sample takes one profile, not {}", files.size()),
                    "for example: gonio sample lamp.ies --at 0,30");
    if (from_pipe && files[0] == "-") return fail("USE0108", "stdin cannot be both the profile and the directions");
    if (at.empty() && !from_pipe)
        return fail("USE0104", "no direction is given", "use --at C,GAMMA, or '-' to read them from stdin");
    Result<ProfileInputOptions> options = profile_input(arguments);
    if (!options) return pass_on(options);

    std::vector<Direction> directions;
    for (const std::string& text : at) {
        Result<Direction> direction = parse_direction(text);
        if (!direction) return pass_on(direction);
        directions.push_back(*direction);
    }
    Result<LoadedProfile> loaded = load(files[0], *options);
    if (!loaded) return pass_on(loaded);
    console.say(loaded->diagnostics);
    if (from_pipe) {
        Result<std::vector<Direction>> read = read_directions();
        if (!read) return pass_on(read);
        directions = std::move(*read);
    }

    if (arguments.has("--csv")) {
        console.print("c_deg,gamma_deg,cd\n");
        for (const Direction& d : directions)
            console.print(fmt::format("{},{},{}\n", shortest(d.c_deg), shortest(d.gamma_deg),
                                      shortest(loaded->web.candela(d.c_deg, d.gamma_deg))));
        return 0;
    }
    const bool lines = arguments.has("--jsonl");
    if (lines || arguments.has("--json")) {
        Json samples = Json::array();
        for (const Direction& d : directions)
            samples.push_back(
                {{"c_deg", d.c_deg}, {"gamma_deg", d.gamma_deg}, {"cd", loaded->web.candela(d.c_deg, d.gamma_deg)}});
        const Json json{{"schema", "gonio.sample/1"},
                        {"file", files[0]},
                        {"samples", std::move(samples)},
                        {"diagnostics", diagnostics_json(loaded->diagnostics)}};
        console.print(dump(json, lines ? -1 : 2));
        return 0;
    }
    for (const Direction& d : directions)
        console.print(fmt::format("{}\n", shortest(loaded->web.candela(d.c_deg, d.gamma_deg))));
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = sample(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command sample_command;
const Command sample_command{
    "sample",
    "print the candela of a profile in given directions",
    "FILE --at C,GAMMA | FILE -",
    "FILE is an IES, EULUMDAT or TM-33 profile. C counts from the C0 plane, GAMMA from the nadir.\n"
    "Prints one intensity in candela for each direction.",
    groups,
    examples,
    run};

} // namespace gonio::cli
