#include <gonio/light/light.hpp>
#include <gonio/media/display.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/material_charts.hpp>
#include <gonio/scene/stage.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"
#include "../options/light_input.hpp"
#include "../options/output.hpp"
#include "../options/values.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>

namespace gonio::cli {

namespace {

constexpr std::array picture_options{
    Option{"--stage", "STAGE", "what the light is shown on (floor)", "stages"},
    Option{"--material", "MATERIAL", "of the sphere on the stage", "materials"},
    Option{"-s,--size", "WxH", "pixels across and down (512x512)"},
    Option{"--exposure", "EV", "exposure value: 8ev (automatic)"},
    Option{"--no-shadows", "", "let the light through the sphere"},
    Option{"--display", "NAME", "display of the OpenColorIO configuration"},
    Option{"--view", "NAME", "view of that display; of the built-in one: Standard, ACES, Raw"},
    Option{"--ocio", "FILE", "OpenColorIO configuration ($OCIO, else built in)"},
    Option{"--simd", "SET", "instruction set (the widest there is)", "simd"},
    Option{"-j,--jobs", "N", "threads (all processors)"},
};
constexpr std::array picture_output_options{
    Option{"-o,--output", "FILE",
           "the picture: .png and other integer formats through the display transform, .exr as "
           "linear Rec.709 in cd/m2; '-' is standard output (with --to)"},
    Option{"--to", "FORMAT", "picture format, where the file name does not tell", "images"},
    Option{"-n,--dry-run", "", "check everything, render nothing"},
};
constexpr std::array groups{light_group, OptionGroup{"picture", picture_options},
                            OptionGroup{"output", picture_output_options}, json_group, light_common_group};
constexpr std::array examples{
    Example{"gonio preview lamp.ies --stage floor -s 512x512 -o lamp.png", "how a measured luminaire lights a room"},
    Example{"gonio preview --shape sphere:r=10cm --intensity 800lm -o bulb.png", "a globe"},
    Example{"gonio preview lamp.ies --material 'kulla-conty:f0=rgb(1,0.77,0.34),alpha=0.2' -o gold.png",
            "what it makes of gold"},
    Example{"gonio preview lamp.ies -o - --to exr | oiiotool - -o lamp.tif", "scene-linear luminance to another tool"},
};

struct Request {
    LightDescription light;
    Diagnostics diagnostics;
    Stage stage;
    RenderOptions render;
    std::optional<Ev100> exposure; // nothing: automatic
    media::DisplayOptions display;
    std::string output;
    const media::ImageFormat* format = nullptr;
};

Result<void> read_picture(const Arguments& arguments, Request& request) {
    if (const auto text = arguments.value("--size")) {
        Result<PixelSize> size = parse_size(*text);
        if (!size) return pass_on(size);
        request.render.width = size->width;
        request.render.height = size->height;
    }
    if (const auto text = arguments.value("--material")) {
        Result<Material> material = parse_material(*text);
        if (!material) return pass_on(material);
        const Diagnostics judged = check_charts(*material);
        request.diagnostics.insert(request.diagnostics.end(), judged.begin(), judged.end());
        for (Surface& surface : request.stage.surfaces)
            if (std::holds_alternative<Ball>(surface.geometry)) surface.material = *material;
    }
    const std::string exposure = arguments.value("--exposure").value_or("auto");
    if (exposure != "auto") {
        Result<double> ev = parse_amount(exposure, Dimension::luminance_ev, "--exposure");
        if (!ev) return pass_on(ev);
        request.exposure = Ev100(*ev);
    }
    Result<unsigned> threads = thread_count(arguments);
    if (!threads) return pass_on(threads);
    Result<simd::InstructionSet> set = instruction_set(arguments);
    if (!set) return pass_on(set);
    request.render.threads = *threads;
    request.render.instruction_set = *set;
    request.render.shadows = !arguments.has("--no-shadows");
    // The library never reads the environment; the tool hands $OCIO on.
    const char* const config = std::getenv("OCIO");
    request.display.config = arguments.value("--ocio").value_or(config == nullptr ? "" : config);
    request.display.display = arguments.value("--display").value_or("");
    request.display.view = arguments.value("--view").value_or("");
    request.display.threads = *threads;
    return {};
}

Result<void> read_output(const Arguments& arguments, Request& request) {
    const auto output = arguments.value("--output");
    if (!output) return fail(Failure::usage, "no output is given", "use -o FILE, for example -o lamp.png");
    request.output = *output;
    if (*output == "-" && (arguments.has("--json") || arguments.has("--jsonl"))) return both_to_standard_output();
    Result<const media::ImageFormat*> format = picture_format(arguments.value("--to"), *output);
    if (!format) return pass_on(format);
    request.format = *format;
    return {};
}

Result<Request> parse(const Arguments& arguments) {
    Request request;
    Result<Stage> stage = make_stage(arguments.value("--stage").value_or("floor"));
    if (!stage) return pass_on(stage);
    request.stage = std::move(*stage);
    Result<LightDescription> light = light_input(arguments, request.stage.light_position, request.diagnostics);
    if (!light) return pass_on(light);
    request.light = std::move(*light);
    Result<void> read = read_picture(arguments, request);
    if (read) read = read_output(arguments, request);
    if (!read) return pass_on(read);
    return request;
}

Result<int> preview(const Arguments& arguments, Console& console) {
    Result<Request> request = parse(arguments);
    if (!request) return pass_on(request);
    Diagnostics diagnostics = std::move(request->diagnostics);
    Result<Light> light = resolve_light(request->light, diagnostics);
    if (!light) return pass_on(light);
    console.say(diagnostics);
    if (arguments.has("--dry-run")) {
        console.print(fmt::format("{}\n", request->output));
        return 0;
    }
    const Stopwatch rendering;
    Result<Image> image = render(request->stage, *light, request->stage.camera, request->render);
    if (!image) return pass_on(image);
    console.remark(fmt::format("rendered {}x{} pixels in {:.1f} ms, {} code", image->width, image->height,
                               rendering.milliseconds(), simd::to_text(request->render.instruction_set)));

    media::ImageWriteOptions write;
    const Ev100 exposure = request->exposure ? *request->exposure : auto_exposure(*image);
    console.remark(fmt::format("exposure EV100 {:.2f}", exposure.value));
    const Stopwatch encoding;
    const bool linear = has_pixel(*request->format, media::Pixel::float32);
    if (!linear) {
        expose(*image, exposure);
        Result<media::DisplayUsed> used = media::apply_display(*image, request->display);
        if (!used) return pass_on(used);
        console.say(used->diagnostics);
        write.color_space = "sRGB";
    } else {
        write.pixel = media::Pixel::float32;
        write.color_space = "Linear";
        write.attributes = {{"gonio:unit", std::string("cd/m2")},
                            {"gonio:exposure_ev100", std::vector<float>{static_cast<float>(exposure.value)}}};
    }
    Result<std::string> bytes = media::encode_image(*image, *request->format, write);
    if (!bytes) return pass_on(bytes);
    console.remark(fmt::format("display transform and encoding: {:.1f} ms", encoding.milliseconds()));
    const Result<void> written = write_output(request->output, *bytes);
    if (!written) return Unexpected(written.error());

    if (arguments.has("--json") || arguments.has("--jsonl")) {
        const Json report{{"schema", "gonio.preview/1"},
                          {"output", request->output},
                          {"width", image->width},
                          {"height", image->height},
                          {"stage", request->stage.name},
                          {"exposure_ev100", exposure.value},
                          {"intensity_cd", light->intensity.value},
                          {"diagnostics", diagnostics_json(diagnostics)}};
        console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    }
    return 0;
}

int run(const Arguments& arguments, Console& console) {
    const Result<int> status = preview(arguments, console);
    return status ? *status : console.fail(status.error());
}

} // namespace

extern const Command preview_command;
const Command preview_command{"preview",
                              "a picture of how a light falls on a stage",
                              "[FILE] --stage STAGE -s WxH -o OUT",
                              "FILE is an IES or EULUMDAT profile; other lights are given by --shape.",
                              groups,
                              examples,
                              run,
                              true};

} // namespace gonio::cli
