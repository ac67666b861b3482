#include <gonio/base/file.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/plot/color_vector_graphic.hpp>

#include "../arguments.hpp"
#include "../cct/cct_report.hpp"
#include "../cct/question.hpp"
#include "../cct/strip.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../options/common.hpp"
#include "../options/files_in_use.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array color_options{
    Option{"--xy", "X,Y", "colour temperature of a CIE 1931 chromaticity", {}, true},
    Option{"--uv-prime", "U,V", "colour temperature of a CIE 1976 chromaticity u', v'", {}, true},
    Option{"--rgb", "R,G,B", "colour temperature of a linear RGB in --space", {}, true},
    Option{"--spectrum", "NAME", "an illuminant, blackbody:2700K, a CSV or TM-33 file; '-' is stdin", "illuminants"},
    Option{"--duv", "DUV", "distance from the Planckian locus in u, v; positive is above it, greener"},
    Option{"--tint", "TINT", "the same distance as the tint of a program: 10@dng", "tints"},
    Option{"--locus", "LOCUS", "planckian, daylight, blend (planckian)", "loci"},
};
constexpr std::array space_options{
    Option{"--space", "SPACE", "colour space of the RGB (rec709), or a linear space of the OpenColorIO configuration",
           "spaces"},
    Option{"--gamut", "GAMUT", "keep negative components, or clip them at the same luminance (keep)"},
    Option{"--normalize", "WHAT",
           "luminance: Y = 1, which keeps the lumens; max: the greatest component is 1 (luminance)"},
    Option{"--ocio", "FILE", "OpenColorIO configuration ($OCIO, else built in)"},
    Option{"--band", "BAND", "wavelengths of the radiant flux in the efficacy: 380nm:780nm (the whole spectrum)"},
    Option{"--versus", "METHOD,…", "compare with other methods: names, or all", "color-methods"},
};
constexpr std::array quality_options{
    Option{"--quality", "",
           "of spectra and black bodies: colour rendering (CRI, TM-30) and alpha-opic figures; with -o a colour vector "
           "graphic"},
    Option{"--illuminance", "LUX", "also the equivalent daylight illuminance (EDI) of that much light: 500lx (100lx)"},
};
constexpr std::array strip_options{
    Option{"-o,--output", "FILE", "write a picture of the colours side by side; '-' is stdout (with --to)"},
    Option{"-s,--size", "WxH", "width and height of the picture in pixels (1024x128, with --quality 720x720)"},
    Option{"--to", "FORMAT", "format of the picture, if the file name does not show it; svg with --quality", "images"},
    Option{"--no-scale", "", "leave out the scale that integer formats have at the bottom"},
    durable_option,
};
constexpr std::array groups{OptionGroup{"colour", color_options},
                            OptionGroup{"space", space_options},
                            OptionGroup{"quality", quality_options},
                            OptionGroup{"picture", strip_options},
                            json_group,
                            common_group};
constexpr std::array examples{
    Example{"gonio cct 2700K", "the colour of a 2700 K black body"},
    Example{"gonio cct 2700K/0.003 --space acescg --json", "3e-3 above the locus, in ACEScg"},
    Example{"gonio cct --xy 0.3127,0.329", "the correlated colour temperature and Duv of D65"},
    Example{"gonio cct 2000K:10000K:500K", "a table"},
    Example{"gonio cct 2000K:10000K:50K --versus krystek,helland,usd -o strip.png",
            "colours next to their approximations"},
    Example{"gonio cct 1850K --versus all", "how far engines are off at the colour of a candle"},
    Example{"gonio cct --spectrum lamp.csv --band 380nm:780nm", "colour and luminous efficacy of a measured spectrum"},
    Example{"gonio cct LED-B3 --quality --illuminance 500lx", "CRI, TM-30 and melanopic EDI of a lamp at 500 lx"},
    Example{"gonio cct --spectrum lamp.csv --quality -o lamp.svg", "its colour vector graphic"},
    Example{"cut -d, -f2 lamps.csv | gonio cct - --jsonl", "values from stdin"},
};

struct Question {
    std::string text;
    std::uint32_t line = 0; // of stdin
    Result<std::vector<CctAnswer>> (*answer)(const std::string&, const CctRequest&) = nullptr;
};

Result<std::vector<Question>> questions(const Arguments& arguments) {
    std::vector<Question> all;
    const auto add = [&](const std::string& word, std::uint32_t line) -> Result<void> {
        Result<std::vector<std::string>> values = expanded(word);
        if (!values) {
            if (line > 0) values.error().diagnostics.back().location = {"-", line, 1};
            return pass_on(values);
        }
        for (std::string& value : *values)
            all.push_back({std::move(value), line, answer_value});
        return {};
    };
    for (const std::string& word : arguments.positional()) {
        if (word != "-") {
            if (Result<void> added = add(word, 0); !added) return pass_on(added);
            continue;
        }
        Result<std::string> text = read_standard_input();
        if (!text) return pass_on(text);
        std::string_view rest = *text;
        for (std::uint32_t line = 1; !rest.empty(); ++line) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            std::string_view row = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            const std::size_t first = row.find_first_not_of(" \t\r");
            if (first == std::string_view::npos) continue;
            row = row.substr(first, row.find_last_not_of(" \t\r") - first + 1);
            if (Result<void> added = add(std::string(row), line); !added) return pass_on(added);
        }
    }
    using Answer = decltype(Question::answer);
    for (const auto& [option, answer] : {std::pair<std::string_view, Answer>{"--xy", answer_xy},
                                         {"--uv-prime", answer_uv_prime},
                                         {"--rgb", answer_rgb},
                                         {"--spectrum", answer_spectrum}})
        for (const std::string& text : arguments.values(option))
            all.push_back({text, 0, answer});
    if (all.empty())
        return fail("USE0104", "no colour is given",
                    "for example: gonio cct 2700K, gonio cct --xy 0.3127,0.329, gonio cct --spectrum d65");
    return all;
}

Result<void> draw(std::span<const CctAnswer> answers, const CctRequest& request, const Arguments& arguments,
                  const std::string& output) {
    PixelSize size{1024, 128};
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> parsed = parse_size(*text);
        if (!parsed) return pass_on(parsed);
        size = *parsed;
    }
    Result<const media::ImageFormat*> format = picture_format(arguments.value("--to"), output);
    if (!format) return pass_on(format);
    const bool linear = has_pixel(**format, media::Pixel::float32);
    // Labels are for people: a file of floats contains only colours.
    const int scale_px = linear || arguments.has("--no-scale") ? 0 : strip_scale_px(size);
    Result<Image> image = strip(answers, request, {size.width, size.height - scale_px}, !linear);
    if (!image) return pass_on(image);
    media::ImageWriteOptions write;
    if (linear) {
        write.pixel = media::Pixel::float32;
        write.attributes = {{"gonio:space", request.space.name}};
    } else {
        Result<media::DisplayUsed> used = media::apply_display(*image);
        if (!used) return pass_on(used);
        write.color_space = "sRGB";
        if (scale_px > 0) *image = with_scale(*image, answers, scale_px);
    }
    Result<std::string> bytes = media::encode_image(*image, **format, write);
    if (!bytes) return pass_on(bytes);
    return write_output(output, *bytes);
}

Result<void> draw_quality(std::span<const CctAnswer> answers, const Arguments& arguments, const std::string& output) {
    if (answers.size() != 1)
        return fail("USE0107", fmt::format("a colour vector graphic shows one light, but {} are given", answers.size()),
                    "leave out -o for a table");
    ColorVectorOptions options;
    options.title = answers.front().input;
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        options.width_px = size->width;
        options.height_px = size->height;
    }
    Result<const media::ImageFormat*> format = diagram_format(arguments.value("--to"), output);
    if (!format) return pass_on(format);
    Result<Drawing> page = color_vector_graphic(*answers.front().quality, options);
    if (!page) return pass_on(page);
    return write_diagram(*page, *format, output);
}

Result<int> cct(const Arguments& arguments, Console& console) {
    Result<CctRequest> request = cct_request(arguments);
    if (!request) return pass_on(request);
    Result<std::vector<Question>> asked = questions(arguments);
    if (!asked) return pass_on(asked);
    const bool json = arguments.has("--json");
    const bool lines = arguments.has("--jsonl");
    const auto output = arguments.value("--output");
    if (output == "-" && (json || lines)) return both_to_standard_output();
    if (output) {
        std::vector<std::string> inputs = arguments.positional();
        for (const std::string_view option : {"--spectrum", "--ocio"})
            for (std::string& file : arguments.values(option))
                inputs.push_back(std::move(file));
        if (Result<void> free = check_outputs(inputs, {&*output, 1}); !free) return pass_on(free);
    }

    int status = 0;
    std::size_t failed = 0;
    std::vector<CctAnswer> answers;
    for (const Question& question : *asked) {
        Result<std::vector<CctAnswer>> found = question.answer(question.text, *request);
        if (!found) {
            if (asked->size() == 1 && question.line == 0) return pass_on(found);
            ++failed;
            if (question.line > 0)
                for (Diagnostic& diagnostic : found.error().diagnostics)
                    if (diagnostic.location.file.empty()) diagnostic.location = {"-", question.line, 1};
            status = worse(status, console.fail(found.error()));
            continue;
        }
        for (CctAnswer& answer : *found) {
            console.say(answer.diagnostics);
            answers.push_back(std::move(answer));
        }
    }
    if (!answers.empty()) {
        if (output) {
            Result<void> drawn = request->quality ? draw_quality(answers, arguments, *output)
                                                  : draw(answers, *request, arguments, *output);
            if (!drawn) return pass_on(drawn);
        }
        if (lines) {
            for (const CctAnswer& answer : answers)
                console.print(dump(to_json(answer, *request), -1));
        } else if (json) {
            Json reports = Json::array();
            for (const CctAnswer& answer : answers)
                reports.push_back(to_json(answer, *request));
            console.print(dump(asked->size() == 1 && reports.size() == 1 ? reports.front() : reports, 2));
        } else if (!output) {
            console.print(to_text(answers, *request));
        }
    }
    if (failed > 0)
        console.note(fmt::format("{} values: {} answered, {} failed", asked->size(), asked->size() - failed, failed));
    return status;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = cct(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command cct_command;
const Command cct_command{
    "cct",
    "compute colour temperature, Duv, chromaticity and RGB of lights and spectra",
    "VALUE… [options]",
    "VALUE is a temperature (2700K), a temperature with its Duv (2700K/0.003), a range\n"
    "(2000K:10000K:100K), a CIE illuminant (d65), or '-' to read such values from stdin, one per line.",
    groups,
    examples,
    run};

} // namespace gonio::cli
