#include "output.hpp"

#include <gonio/base/atomic_file.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/base/kind_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace gonio::cli {

namespace {

std::string stem_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.rfind('.');
    return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

} // namespace

Result<const media::ImageFormat*> picture_format(const std::optional<std::string>& named, const std::string& output) {
    const media::ImageFormat* format = media::find_image_format(named ? *named : output);
    if (format != nullptr) return format;
    std::vector<std::string_view> names;
    for (const media::ImageFormat& known : media::image_formats())
        names.push_back(known.name);
    if (named) return unknown_name("picture format", *named, names);
    if (output == "-")
        return fail(Failure::usage, "standard output has no name that tells the format", "add --to exr or --to png");
    return fail(Failure::usage, fmt::format("the name '{}' does not tell a picture format", output),
                "end it in .png or .exr, or add --to");
}

Result<std::string> encode_for_display(const Image& image, const media::ImageFormat& format) {
    media::ImageWriteOptions write;
    write.pixel = media::Pixel::uint8;
    write.color_space = "sRGB";
    return media::encode_image(image, format, write);
}

Result<void> write_output(const std::string& output, std::string_view bytes) {
    return output == "-" ? write_standard_output(bytes) : write_file(output, bytes);
}

Result<void> check_writable(const std::string& output) {
    if (output == "-") return {};
    if (is_folder(output)) return fail(Failure::io, "is a folder, and cannot be written as a file", {}, output);
    std::error_code ignored;
    if (file_exists(output) && !std::filesystem::is_regular_file(output, ignored)) return {}; // a device, a pipe
    const std::string trial = output + ".trial";
    Result<void> written = write_file(trial, {});
    if (!written) return fail(written.error().failure, written.error().diagnostics.back().message, {}, output);
    std::filesystem::remove(trial, ignored);
    return {};
}

Result<void> write_outputs(const std::vector<OutputFile>& files) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        Result<void> written = write_output(files[i].name, files[i].bytes);
        if (written) continue;
        if (i > 0)
            for (const OutputFile& file : files) {
                std::error_code ignored;
                if (file.name != "-" && std::filesystem::is_regular_file(file.name, ignored))
                    std::filesystem::remove(file.name, ignored);
            }
        return written;
    }
    return {};
}

bool has_pixel(const media::ImageFormat& format, media::Pixel pixel) {
    return std::find(format.pixels.begin(), format.pixels.end(), pixel) != format.pixels.end();
}

Unexpected both_to_standard_output(std::string_view what) {
    return fail(Failure::usage, fmt::format("standard output cannot take both the {} and the report", what),
                fmt::format("write the {} to a file, or leave --json out", what));
}

Result<std::vector<Job>> plan_outputs(const Arguments& arguments, const std::vector<std::string>& inputs,
                                      std::string_view extension, Share share) {
    const auto file = arguments.value("--output");
    const auto folder = arguments.value("--output-dir");
    if (file && folder)
        return fail(Failure::usage, "-o and -O are both given", "-o writes one file, -O a folder of them");
    if (!file && !folder)
        return fail(Failure::usage, "no output is given", "use -o FILE, or -O DIR for several inputs");
    if (file && inputs.size() > 1)
        return fail(Failure::usage, fmt::format("-o names one output, but there are {} inputs", inputs.size()),
                    "use -O DIR");
    if (folder && !is_folder(*folder))
        return file_exists(*folder)
                   ? fail(Failure::io, "cannot write into it: it is no folder", "-O names a folder", *folder)
                   : fail(Failure::io, "the folder does not exist", fmt::format("make it: mkdir -p '{}'", *folder),
                          *folder);
    std::vector<Job> jobs;
    std::set<std::string> taken;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const std::string& input = inputs[i];
        Job job;
        job.input = input;
        job.output =
            file ? *file : fmt::format("{}/{}.{}", *folder, input == "-" ? "stdin" : stem_of(input), extension);
        if (folder && !taken.insert(job.output).second)
            return fail(Failure::usage, fmt::format("two inputs would both be written to '{}'", job.output),
                        "give them different names, or write them to different folders");
        if (i % share.step != share.first) continue;
        if (folder) {
            const bool exists = file_exists(job.output);
            if (exists && arguments.has("--update") && !arguments.has("--overwrite"))
                job.skip = input != "-" && !is_newer(input, job.output);
            else if (exists && !arguments.has("--overwrite"))
                return fail(Failure::usage, fmt::format("'{}' exists", job.output),
                            "add --overwrite, or -u to write only what is out of date");
        }
        jobs.push_back(std::move(job));
    }
    return jobs;
}

} // namespace gonio::cli
