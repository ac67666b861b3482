#include "texture_job.hpp"

#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/sidecar.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/json_text.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/version.hpp>
#include <gonio/media/module.hpp>
#include <gonio/media/texel_pixel.hpp>
#include <gonio/web/metrics.hpp>

#include "../json_text.hpp"
#include "../options/files_in_use.hpp"
#include "../stopwatch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 6> face_names{"px", "nx", "py", "ny", "pz", "nz"};

// "out/lamp.exr" → "out/lamp-px.exr", …
std::vector<std::string> face_files(const std::string& output) {
    const std::string stem = without_extension(output);
    std::vector<std::string> files;
    for (const std::string_view face : face_names)
        files.push_back(fmt::format("{}-{}{}", stem, face, output.substr(stem.size())));
    return files;
}

int channels_of(const BakeRequest& request) {
    return request.engine != nullptr ? request.engine->channels : 1;
}

// The requested type, or the finest that the format has.
Result<media::Pixel> pixel_of(const media::ImageFormat& format, const BakeRequest& request) {
    const bool holds_floats = has_pixel(format, media::Pixel::float32);
    const media::Pixel pixel = request.pixel.value_or(holds_floats ? media::Pixel::float32 : format.pixels.front());
    if (!has_pixel(format, pixel))
        return fail("USE0107", fmt::format("{} cannot store {} pixels", format.title, media::to_text(pixel)),
                    "write .exr for float and half, .png or .tif for uint16 and uint8");
    const bool integers = pixel == media::Pixel::uint8 || pixel == media::Pixel::uint16;
    // An integer texture of candela would be white everywhere.
    if (integers && request.bake.normalization != Normalization::peak)
        return fail(
            "USE0107",
            fmt::format("{} stores values from 0 to 1 only", holds_floats ? media::to_text(pixel) : format.title),
            "add --normalize peak, or write .exr");
    const int channels = channels_of(request);
    if (!format.channels.empty() &&
        std::find(format.channels.begin(), format.channels.end(), channels) == format.channels.end())
        return fail(
            Failure::unsupported,
            fmt::format("{} holds {} channels, but a texture has {}", format.title, format.channels.front(), channels),
            "write .exr, which holds any number of channels");
    return pixel;
}

std::string recipe_of(const BakeRequest& request, const media::ImageFormat& format, media::Pixel pixel) {
    const BakeOptions& bake = request.bake;
    std::string text = fmt::format("gonio {} layout={}", version, info_of(bake.layout).name);
    if (request.engine != nullptr) text += fmt::format(" engine={}", request.engine->name);
    if (request.max_error)
        text += fmt::format(" size=auto max-error={}{}", request.max_error->value,
                            request.max_error->of_peak ? " of peak" : "cd");
    else
        text += fmt::format(" size={}x{}", bake.width, bake.height);
    if (bake.layout == Layout::gnomonic)
        text += fmt::format(" cone={}deg border={}", to_degrees(bake.chart.cone), bake.chart.border);
    text += fmt::format(" normalize={} pixel={} format={}", to_text(bake.normalization), media::to_text(pixel),
                        format.name);
    return text + cli::recipe_of(request.input);
}

media::ImageWriteOptions write_options(const std::string& sidecar, media::Pixel pixel, int channels) {
    media::ImageWriteOptions options;
    options.pixel = pixel;
    if (channels == 1) options.channel_names = {"Y"};
    for (SidecarField& field : sidecar_fields(sidecar)) {
        std::string name = "gonio:" + field.name;
        if (const auto* const number = std::get_if<double>(&field.value))
            options.attributes.push_back({std::move(name), std::vector<float>{static_cast<float>(*number)}});
        else
            options.attributes.push_back({std::move(name), std::get<std::string>(field.value)});
    }
    return options;
}

Result<Texture> baked(const Web& web, const BakeOptions& options, const std::optional<ErrorLimit>& limit) {
    if (!limit) return bake_texture(web, options);
    const double cd = limit->of_peak ? limit->value * peak(web).intensity.value : limit->value;
    return bake_smallest(web, options, Candelas(cd));
}

std::string stats_line(const std::string& input, const Texture& texture, double read_ms, double bake_ms) {
    const auto left_out = static_cast<double>(texture.texels - texture.evaluated);
    return fmt::format("{}: {} of {} texels evaluated, {:.1f} % left out; read in {:.2f} ms, baked in {:.2f} ms, "
                       "modules opened: {}\n",
                       input, texture.evaluated, texture.texels,
                       100.0 * left_out / std::max(1.0, static_cast<double>(texture.texels)), read_ms, bake_ms,
                       fmt::join(media::opened_modules(), ", "));
}

// Whether the picture matches its sidecar. Another gonio may have been killed between writing the two, or may have
// written at the same time.
bool holds(const std::string& picture, const FileRecord& record) {
    const Result<std::string> bytes = read_file(picture, limit("output-bytes"));
    return bytes && file_name(picture) == record.file && matches(record, *bytes);
}

// Refuses to replace files without --overwrite; plan_outputs has already checked the output's own name.
Result<void> refuse_existing(const Arguments& arguments, const TextureJob& job) {
    if (!arguments.has("--output-dir") || arguments.has("--overwrite") || arguments.has("--update")) return {};
    for (const std::string& file : job.pictures)
        if (file_exists(file))
            return fail("USE0108", fmt::format("'{}' exists", file),
                        "add --overwrite, or -u to write only outdated files");
    return {};
}

} // namespace

Result<std::vector<TextureJob>> plan_textures(const Arguments& arguments, const BakeRequest& request,
                                              const std::vector<std::string>& inputs) {
    std::optional<std::string> named = arguments.value("--to");
    if (!named && request.engine != nullptr && arguments.value("--output-dir")) named = request.engine->format;
    Result<std::vector<Job>> outputs =
        plan_outputs(arguments, inputs, named.value_or("exr"), share_of(request.catalogue), request.subfolder);
    if (!outputs) return pass_on(outputs);
    if (!request.max_error) {
        const Result<std::vector<PlacedChart>> charts =
            charts_of(request.bake.layout, request.bake.width, request.bake.height, request.bake.chart);
        if (!charts && request.bake.width > 0 && request.bake.height > 0) return Unexpected(charts.error());
    }
    FilesInUse in_use(inputs);
    if (request.catalogue.manifest)
        if (Result<void> free = in_use.take(*request.catalogue.manifest); !free) return pass_on(free);
    std::vector<TextureJob> jobs;
    for (Job& files : *outputs) {
        const Result<const media::ImageFormat*> format = picture_format(named, files.output);
        if (!format) return Unexpected(format.error());
        const Result<media::Pixel> pixel = pixel_of(**format, request);
        if (!pixel) return Unexpected(pixel.error());
        TextureJob job{&request, std::move(files), *format, *pixel, {}, {}, recipe_of(request, **format, *pixel)};
        const bool to_stdout = job.files.output == "-";
        if (request.bake.layout == Layout::cube && to_stdout)
            return fail("USE0108", "six files cannot go to stdout", "use -o FILE, or --layout cube-strip");
        job.pictures = request.bake.layout == Layout::cube ? face_files(job.files.output)
                                                           : std::vector<std::string>{job.files.output};
        if (request.sidecar || (!to_stdout && !request.no_sidecar))
            job.sidecar = request.sidecar.value_or(job.files.output + ".json");
        for (const std::string& picture : job.pictures)
            if (Result<void> free = in_use.take(picture); !free) return pass_on(free);
        if (job.sidecar)
            if (Result<void> free = in_use.take(*job.sidecar); !free) return pass_on(free);
        // With a sidecar, contents decide and not modification times; see is_up_to_date.
        if (job.files.skip && !job.sidecar) continue;
        if (const Result<void> free = refuse_existing(arguments, job); !free) return Unexpected(free.error());
        jobs.push_back(std::move(job));
    }
    return jobs;
}

bool is_up_to_date(const TextureJob& job) {
    if (!job.sidecar || job.files.input == "-" || !file_exists(*job.sidecar)) return false;
    const Result<std::string> sidecar = read_file(*job.sidecar, limit("record-bytes"));
    const std::optional<TextureRecord> record = sidecar ? read_sidecar(*sidecar) : std::nullopt;
    if (!record || record->recipe != job.recipe) return false;
    const Result<std::string> input = read_file(job.files.input, limit_of_profile(job.files.input));
    return input && sha256(*input) == record->source_sha256 &&
           std::equal(job.pictures.begin(), job.pictures.end(), record->files.begin(), record->files.end(), holds);
}

Result<Made> make_texture(const TextureJob& job, ReportKind kind) {
    const BakeRequest& request = *job.request;
    Made made;
    const Stopwatch reading;
    Result<LoadedProfile> loaded = load(job.files.input, request.input);
    if (!loaded) return pass_on(loaded);
    const double read_ms = reading.milliseconds();
    const Stopwatch baking;
    BakeOptions options = request.bake;
    options.texel_type = media::texel_type(job.pixel);
    Result<Texture> texture = baked(loaded->web, options, request.max_error);
    if (!texture) return pass_on(texture);
    const double bake_ms = baking.milliseconds();
    const std::vector<float>& texels = texture->image.pixels;
    const bool black = std::all_of(texels.begin(), texels.end(), [](float texel) { return texel == 0.0F; });
    if (black && peak(loaded->web).intensity.value > 0.0)
        loaded->diagnostics.push_back(
            result_diagnostic("RES0206",
                              fmt::format("the texture is black: none of the light is in the directions that {} covers",
                                          info_of(request.bake.layout).name),
                              "the layouts latlong and octahedral cover all directions", job.files.input));
    made.outcome.remarks.push_back(
        fmt::format("{}: read in {:.2f} ms, baked in {:.2f} ms", job.files.input, read_ms, bake_ms));

    const bool faces = request.bake.layout == Layout::cube;
    const ManifestFile source{job.files.input, sha256(loaded->bytes)};
    TextureFile description{
        std::string(media::to_text(job.pixel)), channels_of(request), request.engine, {}, job.recipe};
    if (faces)
        std::transform(job.pictures.begin(), job.pictures.end(), std::back_inserter(description.face_files),
                       [](const std::string& picture) { return file_name(picture); });
    const auto sidecar_of = [&] { return texture_sidecar(*texture, {source.file, source.sha256}, description); };
    std::vector<OutputFile> files;
    const int width = texture->image.width / static_cast<int>(job.pictures.size());
    media::ImageWriteOptions writing = write_options(sidecar_of(), job.pixel, channels_of(request));
    writing.threads = request.bake.threads;
    for (std::size_t i = 0; i < job.pictures.size(); ++i) {
        Result<std::string> bytes = media::encode_image(
            picture_of(*texture, static_cast<int>(i) * width, width, channels_of(request)), *job.format, writing);
        if (!bytes) return pass_on(bytes);
        description.files.push_back(file_record(file_name(job.pictures[i]), *bytes));
        files.push_back({job.pictures[i], std::move(*bytes)});
    }
    const std::string sidecar = sidecar_of(); // describes the pictures, which cannot describe themselves
    if (job.sidecar) files.push_back({*job.sidecar, sidecar});
    if (Result<void> written = write_outputs(files); !written) return pass_on(written);

    if (request.catalogue.manifest) {
        made.asset.input = source;
        for (const OutputFile& file : files)
            made.asset.files.push_back({file.name, sha256(file.bytes)});
    }
    if (request.stats) made.outcome.words = stats_line(job.files.input, *texture, read_ms, bake_ms);
    if (kind != ReportKind::words) {
        made.outcome.report = {{"schema", "gonio.bake/1"}, {"output", job.files.name}, {"up_to_date", false}};
        Result<Json> texture_report = detail::parse_json(sidecar);
        if (!texture_report) return pass_on(texture_report);
        made.outcome.report["texture"] = std::move(*texture_report);
        if (request.stats)
            made.outcome.report["stats"] = {{"texels", texture->texels},
                                            {"evaluated", texture->evaluated},
                                            {"read_ms", read_ms},
                                            {"bake_ms", bake_ms},
                                            {"modules", media::opened_modules()}};
        made.outcome.report["diagnostics"] = diagnostics_json(loaded->diagnostics);
    }
    made.outcome.diagnostics = std::move(loaded->diagnostics);
    return made;
}

Result<Made> found_texture(const TextureJob& job, ReportKind kind) {
    const BakeRequest& request = *job.request;
    Made found;
    found.outcome.unchanged = true;
    found.outcome.remarks.push_back(fmt::format("{}: up to date", job.files.output));
    if (request.catalogue.manifest) {
        Result<ManifestFile> input = hashed(job.files.input);
        if (!input) return pass_on(input);
        found.asset.input = std::move(*input);
        std::vector<std::string> files = job.pictures;
        if (job.sidecar) files.push_back(*job.sidecar);
        for (const std::string& name : files) {
            Result<ManifestFile> file = hashed(name);
            if (!file) return pass_on(file);
            found.asset.files.push_back(std::move(*file));
        }
    }
    if (kind != ReportKind::words) {
        Result<std::string> sidecar = read_file(*job.sidecar, limit("record-bytes"));
        if (!sidecar) return pass_on(sidecar);
        Result<Json> texture_report = detail::parse_json(*sidecar, *job.sidecar);
        if (!texture_report) return pass_on(texture_report);
        found.outcome.report = {{"schema", "gonio.bake/1"}, {"output", job.files.name}, {"up_to_date", true}};
        found.outcome.report["texture"] = std::move(*texture_report);
        found.outcome.report["diagnostics"] = Json::array();
    }
    return found;
}

} // namespace gonio::cli
