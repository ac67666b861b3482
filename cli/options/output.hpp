// Where a command that writes files puts its results: -o FILE for one, -O DIR for many.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>
#include <gonio/plot/drawing.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

inline constexpr std::array picture_format_options{
    Option{"--to", "FORMAT", "picture format, if the file name does not show it", "images"},
};

inline constexpr OptionGroup picture_format_group{"picture", picture_format_options};

inline constexpr Option durable_option{
    "--durable", "", "flush files to disk before they are renamed: a power cut leaves the old or the new file"};

inline constexpr Option mirror_option{
    "--mirror", "", "with -O: keep the folders of the inputs below the one that they share, and make them"};

inline constexpr std::array output_options{
    Option{"-o,--output", "FILE", "write one output; '-' is stdout (with --to)"},
    Option{"-O,--output-dir", "DIR", "write one output per input into an existing folder"},
    mirror_option,
    Option{"-u,--update", "", "with -O: write only outdated files"},
    Option{"--overwrite", "", "with -O: replace existing files"},
    Option{"-n,--dry-run", "", "print what would be written, but write nothing"},
    durable_option,
};

inline constexpr OptionGroup output_group{"output", output_options};

bool has_pixel(const media::ImageFormat& format, media::Pixel pixel);

// The format named by --to, else the one that the output's name implies. Fails (usage) if neither gives a format.
Result<const media::ImageFormat*> picture_format(const std::optional<std::string>& named, const std::string& output);

// A picture of three display-encoded channels as bytes of a format with 8 bits per channel. `dither`: for pictures of
// light, not for drawings and scales.
Result<std::string> encode_for_display(const Image& image, const media::ImageFormat& format, bool dither);

// The format of a diagram, named by --to or by the output's name; nullptr is SVG. Fails (usage) if neither gives one,
// and on formats for light.
Result<const media::ImageFormat*> diagram_format(const std::optional<std::string>& named, const std::string& output);

// Draws a diagram to the file, or to stdout for "-".
Result<void> write_diagram(const Drawing& drawing, const media::ImageFormat* format, const std::string& output);

// --durable: whether files written from now on are flushed to the disk before they get their names.
void set_durable_outputs(bool durable);

// To the file, or to stdout for "-".
Result<void> write_output(const std::string& output, std::string_view bytes);

struct OutputFile {
    std::string name; // "-" is stdout
    std::string bytes;
};

// Writes all of them or none (FileSet): after a failure every file is as it was before.
Result<void> write_outputs(const std::vector<OutputFile>& files);

// A warning for every two outputs with names that are the same on a file system that ignores case.
Diagnostics names_that_differ_by_case(std::span<const std::string> outputs);

// The error for an output (a "picture", a "profile") and a report that would both go to stdout.
Unexpected both_to_standard_output(std::string_view what = "picture");

// One input and the output made from it.
struct Job {
    std::string input;
    std::string output; // "-" is stdout
    std::string name;   // the name in reports: as given to -o, or within the folder of -O
    bool skip = false;  // -u: the output is up to date
};

// Every step-th input, starting at `first`.
struct Share {
    std::size_t first = 0;
    std::size_t step = 1;
};

// The names of the outputs of several inputs below -O, without their endings: "lamp". With --mirror below the folder
// that all share, "office/lamp", and with the input's ending where that tells two apart: "office/lamp.ies".
std::vector<std::string> names_in_folder(const std::vector<std::string>& inputs, bool mirror);

// Pairs the inputs of a share with outputs; `extension` names the files of -O, or of its `subfolder`. With --mirror,
// inputs in one folder that differ in their endings only keep them ("lamp.ies.exr", "lamp.ldt.exr"). Folders in that of
// -O are made, except for a dry run. Fails (usage) if both or neither of -o and -O are given, if -o is given with
// several inputs, if two inputs (of all) would write the same output, with an error for each of them, if an output is
// one of the inputs, or if an output exists and may not be replaced; (io) if -O is not a folder.
Result<std::vector<Job>> plan_outputs(const Arguments& arguments, const std::vector<std::string>& inputs,
                                      std::string_view extension, Share share = {}, const std::string& subfolder = {});

} // namespace gonio::cli
