#include "output.hpp"

#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/plot/raster.hpp>
#include <gonio/plot/svg.hpp>

#include "files_in_use.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace gonio::cli {

namespace {

bool write_durably = false;

// The names below the deepest folder that all have in common.
std::vector<std::string> below_common_folder(const std::vector<std::string>& inputs) {
    std::vector<std::string> names;
    std::optional<std::string> common; // ends with a slash
    for (const std::string& input : inputs) {
        names.push_back(input == "-" ? "stdin" : absolute_name(input));
        if (input == "-") continue;
        if (!common) common = names.back();
        const auto [differs, _] =
            std::mismatch(common->begin(), common->end(), names.back().begin(), names.back().end());
        common->erase(differs, common->end());
        common->resize(common->rfind('/') + 1);
    }
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (inputs[i] != "-") names[i].erase(0, common->size());
    return names;
}

// An error for every input that would be written to the file of one before it.
Result<void> distinct_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                              bool mirror) {
    constexpr std::size_t most = 20;
    std::map<std::string, std::string> taken; // by output, the input
    Diagnostics clashes;
    std::size_t more = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto [other, is_new] = taken.emplace(outputs[i], inputs[i]);
        if (is_new) continue;
        if (clashes.size() == most) {
            ++more;
            continue;
        }
        clashes.push_back(
            error_at("USE0108", {},
                     fmt::format("'{}' and '{}' would both be written to '{}'", other->second, inputs[i], outputs[i]))
                .diagnostics.back());
    }
    if (clashes.empty()) return {};
    Diagnostic& last = clashes.back();
    if (more > 0) last.message += fmt::format(", and so would {} more", more);
    last.hint = mirror ? "give them different names, or write them to different folders"
                       : "add --mirror, which keeps folders and, where needed, endings; or give them different names";
    return Unexpected(Error{Failure::usage, std::move(clashes)});
}

} // namespace

std::vector<std::string> names_in_folder(const std::vector<std::string>& inputs, bool mirror) {
    std::vector<std::string> names;
    if (!mirror) {
        for (const std::string& input : inputs)
            names.push_back(input == "-" ? "stdin" : without_extension(file_name(input)));
        return names;
    }
    names = below_common_folder(inputs);
    std::map<std::string, std::size_t> with_stem;
    for (const std::string& name : names)
        ++with_stem[without_extension(name)];
    for (std::string& name : names)
        if (std::string stem = without_extension(name); with_stem[stem] == 1) name = std::move(stem);
    return names;
}

Result<const media::ImageFormat*> picture_format(const std::optional<std::string>& named, const std::string& output) {
    const media::ImageFormat* format = media::find_image_format(named ? *named : output);
    if (format != nullptr) return format;
    if (named) return unknown_name("picture format", *named, names_of(media::image_formats()));
    if (output == "-") return fail("USE0104", "stdout has no file name to show the format", "add --to exr or --to png");
    return fail("USE0104", fmt::format("the name '{}' does not show a picture format", output),
                "end it in .png or .exr, or add --to");
}

Result<std::string> encode_for_display(const Image& image, const media::ImageFormat& format, bool dither) {
    media::ImageWriteOptions write;
    write.pixel = media::Pixel::uint8;
    write.color_space = "sRGB";
    write.dither = dither;
    return media::encode_image(image, format, write);
}

Result<const media::ImageFormat*> diagram_format(const std::optional<std::string>& named, const std::string& output) {
    if (named ? *named == "svg" : output.ends_with(".svg")) return nullptr;
    if (!named && media::find_image_format(output) == nullptr)
        return fail("USE0104", fmt::format("the name '{}' does not show a diagram format", output),
                    "end it in .svg or .png, or add --to");
    Result<const media::ImageFormat*> format = picture_format(named, output);
    if (!format) return pass_on(format);
    if (!has_pixel(**format, media::Pixel::uint8))
        return fail("USE0107", fmt::format("{} is for light, not for diagrams", (*format)->title),
                    "write .svg, .png, .tif or .jpg");
    return *format;
}

Result<void> write_diagram(const Drawing& drawing, const media::ImageFormat* format, const std::string& output) {
    if (format == nullptr) return write_output(output, to_svg(drawing));
    Result<std::string> bytes = encode_for_display(to_image(drawing), *format, false);
    if (!bytes) return pass_on(bytes);
    return write_output(output, *bytes);
}

void set_durable_outputs(bool durable) {
    write_durably = durable;
}

Result<void> write_output(const std::string& output, std::string_view bytes) {
    return output == "-" ? write_standard_output(bytes) : write_file(output, bytes, {write_durably});
}

Result<void> write_outputs(const std::vector<OutputFile>& files) {
    FileSet set({write_durably});
    for (const OutputFile& file : files) {
        if (file.name == "-") continue;
        if (Result<void> added = set.add(file.name, file.bytes); !added) return added;
    }
    // Output to stdout cannot be undone, so it is written after all files are complete except for their names.
    for (const OutputFile& file : files) {
        if (file.name != "-") continue;
        if (Result<void> written = write_standard_output(file.bytes); !written) return written;
    }
    return set.commit();
}

Diagnostics names_that_differ_by_case(std::span<const std::string> outputs) {
    Diagnostics warnings;
    std::map<std::string, std::string> taken;
    for (const std::string& output : outputs) {
        const auto [other, is_new] = taken.emplace(to_lower(output), output);
        if (is_new || other->second == output) continue;
        warnings.push_back(result_diagnostic(
            "RES0205", fmt::format("'{}' and '{}' differ only in upper and lower case", other->second, output),
            "on a file system that ignores case (Windows, macOS), one replaces the other"));
    }
    return warnings;
}

bool has_pixel(const media::ImageFormat& format, media::Pixel pixel) {
    return std::find(format.pixels.begin(), format.pixels.end(), pixel) != format.pixels.end();
}

Unexpected both_to_standard_output(std::string_view what) {
    return fail("USE0108", fmt::format("stdout cannot take both the {} and the report", what),
                fmt::format("write the {} to a file, or leave --json out", what));
}

Result<std::vector<Job>> plan_outputs(const Arguments& arguments, const std::vector<std::string>& inputs,
                                      std::string_view extension, Share share, const std::string& subfolder) {
    const auto file = arguments.value("--output");
    const auto folder = arguments.value("--output-dir");
    if (file && folder) return fail("USE0107", "-o and -O are both given", "-o writes one file, -O a folder of them");
    if (!file && !folder) {
        // `convert lamp.ies lamp.ldt`, as cp would take it.
        const bool second_is_output = inputs.size() == 2 && file_exists(inputs[0]) && !file_exists(inputs[1]);
        return fail("USE0104", "no output is given",
                    second_is_output ? fmt::format("did you mean -o '{}'?", inputs[1])
                                     : std::string("use -o FILE, or -O DIR for several inputs"));
    }
    if (file && inputs.size() > 1)
        return fail("USE0107", fmt::format("-o names one output, but there are {} inputs", inputs.size()),
                    "use -O DIR");
    if (folder && !is_folder(*folder))
        return file_exists(*folder)
                   ? fail("FIL0101", "cannot write into it: it is not a folder", "-O names a folder", *folder)
                   : fail(Failure::io, "the folder does not exist", fmt::format("create it: mkdir -p '{}'", *folder),
                          *folder);
    const bool mirror = arguments.has("--mirror");
    if (mirror && !folder) return fail("USE0104", "--mirror needs -O", "use -O DIR");
    std::vector<std::string> outputs;
    if (file) {
        outputs = {*file};
    } else {
        const std::string in = subfolder.empty() ? *folder : *folder + "/" + subfolder;
        for (const std::string& name : names_in_folder(inputs, mirror))
            outputs.push_back(fmt::format("{}/{}.{}", in, name, extension));
        if (Result<void> distinct = distinct_outputs(inputs, outputs, mirror); !distinct) return pass_on(distinct);
    }
    FilesInUse files(inputs);
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const std::string& input = inputs[i];
        Job job;
        job.input = input;
        job.output = outputs[i];
        if (i % share.step != share.first) continue;
        if (Result<void> free = files.take(job.output); !free) return pass_on(free);
        job.name = folder ? job.output.substr(folder->size() + 1) : job.output;
        if (folder) {
            const bool exists = file_exists(job.output);
            if (exists && arguments.has("--update") && !arguments.has("--overwrite"))
                job.skip = input != "-" && !is_newer(input, job.output);
            else if (exists && !arguments.has("--overwrite"))
                return fail("USE0108", fmt::format("'{}' exists", job.output),
                            arguments.offers("--update") ? "add --overwrite, or -u to write only outdated files"
                                                         : "add --overwrite");
        }
        jobs.push_back(std::move(job));
    }
    if (folder && !arguments.has("--dry-run"))
        for (const Job& job : jobs)
            if (Result<void> made = make_folders_of(*folder, job.name); !made) return pass_on(made);
    return jobs;
}

} // namespace gonio::cli
