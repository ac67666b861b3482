#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/profile_input.hpp"
#include "../options/profile_output.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gonio::cli {

namespace {

constexpr std::array edit_options{
    Option{"--sum", "", "add the light of several inputs"},
    Option{"--blend", "SHARE", "mix two inputs: this share of the second, the rest of the first"},
    Option{"--resample", "C,GAMMA", "resample to type C in equal steps: 5deg,2.5deg"},
    Option{"--crop", "LOW,HIGH", "remove the light outside these gamma: 0deg,80deg"},
    Option{"--symmetrize", "HOW",
           "take the mean of the mirror images: axial, quadrant, bilateral-0-180, bilateral-90-270"},
    Option{"--mirror", "PLANE", "mirror in the plane c0-180 or c90-270"},
    Option{"--rotate", "ANGLE", "rotate about the axis, C0 towards C90: 90deg"},
    Option{"--tilt-by", "ANGLE", "tilt the axis towards --tilt-towards: 15deg"},
    Option{"--tilt-towards", "C", "the C-plane that --tilt-by tilts towards (0deg)"},
    Option{"--stretch", "FACTOR", "make a linear luminaire this many times as long, with its flux, watts and length"},
    Option{"--length", "LENGTH", "the same, to this length of its luminous opening: 1.5m"},
    Option{"--dim", "FACTOR", "multiply every intensity by this"},
    Option{"--lumens", "FLUX", "scale to this flux: 1200lm"},
};
constexpr std::array groups{OptionGroup{"changes, applied in this order", edit_options}, profile_output_group,
                            profile_input_group, json_group, common_group};
constexpr std::array examples{
    Example{"gonio edit tube.ies --stretch 1.5 -o longer.ies", "36 W of 1.2 m become 54 W of 1.8 m"},
    Example{"gonio edit lamp.ies --rotate 90deg --lumens 1200lm -o lamp.ldt", "rotate, scale and write EULUMDAT"},
    Example{"gonio edit up.ies down.ies --sum -o both.ies", "two lights in one"},
};

// The accumulated cost of the edits so far.
struct Cost {
    double max_error_cd = 0.0;
    double flux_error_lm = 0.0;

    Web add(ResampledWeb&& resampled) {
        max_error_cd += resampled.max_error.value;
        flux_error_lm += resampled.flux_error.value;
        return std::move(resampled.web);
    }
};

Result<double> angle_deg(std::string_view text, std::string_view option) {
    Result<double> angle = parse_amount(text, Dimension::angle, option);
    if (!angle) return pass_on(angle);
    // 90deg is exactly 90, not the result of converting from radians.
    const double deg = to_degrees(Radians(*angle));
    return std::abs(deg - std::round(deg * 1e6) * 1e-6) < 1e-10 ? std::round(deg * 1e6) * 1e-6 : deg;
}

struct AnglePair {
    double first_deg;
    double second_deg;
};

Result<AnglePair> angle_pair(const std::string& text, std::string_view option) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        return fail("USE0105", fmt::format("{} takes two angles, not '{}'", option, text), "for example 0deg,80deg");
    Result<double> first = angle_deg(std::string_view(text).substr(0, comma), option);
    if (!first) return pass_on(first);
    Result<double> second = angle_deg(std::string_view(text).substr(comma + 1), option);
    if (!second) return pass_on(second);
    return AnglePair{*first, *second};
}

Result<double> factor_of(const std::string& text, std::string_view option) {
    const std::optional<double> factor = parse_number(text);
    if (!factor || !(*factor > 0.0))
        return fail("USE0106", fmt::format("{} takes a number greater than 0, not '{}'", option, text));
    return *factor;
}

Result<Symmetry> symmetry_named(const std::string& name) {
    constexpr std::array symmetries{Named{"axial", Symmetry::axial}, Named{"quadrant", Symmetry::quadrant},
                                    Named{"bilateral-0-180", Symmetry::bilateral_0_180},
                                    Named{"bilateral-90-270", Symmetry::bilateral_90_270}};
    return find_value("symmetry", name, symmetries);
}

Result<Web> on_even_steps(const Web& web, const AnglePair& steps, Cost& cost) {
    const auto cells = [](double range, double step) { return std::lround(range / step); };
    const auto divides = [&](double range, double step) {
        return step > 0.0 && step <= range && std::abs(static_cast<double>(cells(range, step)) * step - range) < 1e-6;
    };
    if (!divides(360.0, steps.first_deg) || !divides(180.0, steps.second_deg) || steps.first_deg < 0.1 ||
        steps.second_deg < 0.1)
        return fail("USE0105",
                    fmt::format("steps of {}° and {}° do not divide 360° and 180° evenly", rounded(steps.first_deg),
                                rounded(steps.second_deg)),
                    "from 0.1deg, for example 5deg,2.5deg");
    Result<ResampledWeb> resampled =
        resampled_to_c(web, even_angles(0.0, 360.0, static_cast<std::size_t>(cells(360.0, steps.first_deg))),
                       even_angles(0.0, 180.0, static_cast<std::size_t>(cells(180.0, steps.second_deg))));
    if (!resampled) return pass_on(resampled);
    return cost.add(std::move(*resampled));
}

Result<void> change_web(Web& web, const Arguments& arguments, Cost& cost) {
    if (const auto text = arguments.value("--resample")) {
        Result<AnglePair> steps = angle_pair(*text, "--resample");
        if (!steps) return pass_on(steps);
        Result<Web> even = on_even_steps(web, *steps, cost);
        if (!even) return pass_on(even);
        web = std::move(*even);
    }
    if (const auto text = arguments.value("--crop")) {
        Result<AnglePair> range = angle_pair(*text, "--crop");
        if (!range) return pass_on(range);
        Result<Web> cut = cropped(web, range->first_deg, range->second_deg);
        if (!cut) return pass_on(cut);
        web = std::move(*cut);
    }
    if (const auto name = arguments.value("--symmetrize")) {
        Result<Symmetry> symmetry = symmetry_named(*name);
        if (!symmetry) return pass_on(symmetry);
        Result<Web> even = symmetrized(web, *symmetry);
        if (!even) return pass_on(even);
        web = std::move(*even);
    }
    if (const auto plane = arguments.value("--mirror")) {
        constexpr std::array planes{Named{"c0-180", MirrorPlane::c0_180}, Named{"c90-270", MirrorPlane::c90_270}};
        Result<MirrorPlane> mirror = find_value("plane", *plane, planes);
        if (!mirror) return pass_on(mirror);
        web = mirrored(web, *mirror);
    }
    if (const auto text = arguments.value("--rotate")) {
        Result<double> angle = angle_deg(*text, "--rotate");
        if (!angle) return pass_on(angle);
        web = cost.add(rotated(web, *angle));
    }
    if (const auto text = arguments.value("--tilt-by")) {
        Result<double> angle = angle_deg(*text, "--tilt-by");
        if (!angle) return pass_on(angle);
        Result<double> towards = angle_deg(arguments.value("--tilt-towards").value_or("0deg"), "--tilt-towards");
        if (!towards) return pass_on(towards);
        web = cost.add(tilted(web, *angle, *towards));
    }
    return {};
}

Result<Luminaire> scale(Luminaire luminaire, const Arguments& arguments) {
    if (const auto text = arguments.value("--length")) {
        if (arguments.has("--stretch")) return fail("USE0107", "--length and --stretch are both given", "give one");
        Result<double> meters = parse_amount(*text, Dimension::length, "--length");
        if (!meters) return pass_on(meters);
        const double now = luminaire.header.opening.length_m;
        if (!(*meters > 0.0) || !(now > 0.0))
            return fail("USE0106",
                        now > 0.0 ? fmt::format("--length must be greater than 0, not {}", *text)
                                  : std::string("this luminaire has no length to change"),
                        now > 0.0 ? "" : "--stretch FACTOR needs an opening with a length too");
        Result<Luminaire> longer = stretched(luminaire, *meters / now);
        if (!longer) return longer;
        luminaire = std::move(*longer);
    }
    if (const auto text = arguments.value("--stretch")) {
        Result<double> factor = factor_of(*text, "--stretch");
        if (!factor) return pass_on(factor);
        Result<Luminaire> longer = stretched(luminaire, *factor);
        if (!longer) return longer;
        luminaire = std::move(*longer);
    }
    if (const auto text = arguments.value("--dim")) {
        Result<double> factor = factor_of(*text, "--dim");
        if (!factor) return pass_on(factor);
        Result<Luminaire> dim = dimmed(luminaire, *factor);
        if (!dim) return dim;
        luminaire = std::move(*dim);
    }
    if (const auto text = arguments.value("--lumens")) {
        Result<double> lumens = parse_amount(*text, Dimension::luminous_flux, "--lumens");
        if (!lumens) return pass_on(lumens);
        return scaled_to(luminaire, Lumens(*lumens));
    }
    return luminaire;
}

// The weights of the inputs. Fails if the options do not fit the number of inputs.
Result<std::vector<double>> weights_for(const Arguments& arguments, std::size_t inputs) {
    const auto blend = arguments.value("--blend");
    if (blend && arguments.has("--sum"))
        return fail("USE0107", "--sum and --blend are both given", "--sum adds, --blend takes a mean");
    if (blend) {
        const std::optional<double> share = parse_number(*blend);
        if (!share || *share < 0.0 || *share > 1.0)
            return fail("USE0105", fmt::format("--blend takes a share from 0 to 1, not '{}'", *blend));
        if (inputs != 2) return fail("USE0107", fmt::format("--blend takes two profiles, not {}", inputs));
        return std::vector{1.0 - *share, *share};
    }
    if (inputs > 1 && !arguments.has("--sum"))
        return fail("USE0107", fmt::format("edit takes one profile, not {}", inputs),
                    "--sum adds their light, --blend mixes two");
    return std::vector<double>(inputs, 1.0);
}

Json report_of(const std::vector<std::string>& files, const ProfileOutput& output, const WrittenProfile& written,
               const Cost& cost, const Diagnostics& diagnostics) {
    return {{"schema", "gonio.edit/1"},
            {"files", files},
            {"output", output.file},
            {"flux_lm", written.flux_lm},
            {"peak_cd", written.peak_cd},
            {"max_error_cd", cost.max_error_cd + written.max_error_cd},
            {"flux_error_lm", cost.flux_error_lm},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

Result<int> edit(const Arguments& arguments, Console& console) {
    Result<std::vector<std::string>> files = input_files(arguments);
    if (!files) return pass_on(files);
    Result<ProfileOutput> output = profile_output(arguments);
    if (!output) return pass_on(output);
    if (Result<void> free = check_outputs(*files, {&output->file, 1}); !free) return pass_on(free);
    Result<ProfileInputOptions> input = profile_input(arguments);
    if (!input) return pass_on(input);
    Result<std::vector<double>> weights = weights_for(arguments, files->size());
    if (!weights) return pass_on(weights);
    const bool lines = arguments.has("--jsonl");
    const bool json = lines || arguments.has("--json");
    if (json && output->file == "-") return both_to_standard_output("profile");

    std::vector<Luminaire> luminaires;
    Diagnostics diagnostics;
    for (const std::string& file : *files) {
        Result<LoadedProfile> loaded = load(file, *input);
        if (!loaded) return pass_on(loaded);
        diagnostics.insert(diagnostics.end(), loaded->diagnostics.begin(), loaded->diagnostics.end());
        luminaires.push_back({std::move(loaded->web), header_of(loaded->profile, input->resolve)});
    }
    Cost cost;
    if (luminaires.size() > 1) {
        Result<CombinedLuminaire> sum = combined(luminaires, *weights);
        if (!sum) return pass_on(sum);
        cost.max_error_cd += sum->max_error_cd;
        luminaires = {std::move(sum->luminaire)};
    }
    Luminaire& edited = luminaires.front();
    if (Result<void> changed = change_web(edited.web, arguments, cost); !changed) return pass_on(changed);
    if (arguments.has("--rotate")) edited.header.azimuth = AzimuthConvention::as_written;
    if (cost.max_error_cd > 0.0) {
        const double top = std::abs(peak(edited.web).intensity.value);
        console.note(fmt::format("resampled: error up to {} cd, {} of the peak; flux {:+.3g} lm",
                                 rounded(cost.max_error_cd, 3), rounded(top > 0.0 ? cost.max_error_cd / top : 0.0, 3),
                                 cost.flux_error_lm));
    }
    edited.web = compacted(edited.web);
    Result<Luminaire> scaled = scale(std::move(edited), arguments);
    if (!scaled) return pass_on(scaled);
    Result<WrittenProfile> written = write_luminaire(*scaled, *output);
    if (!written) return pass_on(written);
    diagnostics.insert(diagnostics.end(), written->diagnostics.begin(), written->diagnostics.end());
    console.say(diagnostics);
    if (json) console.print(dump(report_of(*files, *output, *written, cost, diagnostics), lines ? -1 : 2));
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = edit(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command edit_command;
const Command edit_command{"edit",
                           "rotate, crop, symmetrise, scale, stretch or mix profiles",
                           "IN… [changes] -o OUT",
                           "IN is a profile of any format, or '-' for stdin; --sum and --blend take several.\n"
                           "If a change needs resampling, the error is reported.",
                           groups,
                           examples,
                           run};

} // namespace gonio::cli
