// Where results of a file-writing command go: -o FILE for one, -O DIR for many.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>

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

inline constexpr std::array output_options{
    Option{"-o,--output", "FILE", "write one output; '-' is stdout (with --to)"},
    Option{"-O,--output-dir", "DIR", "write one output per input into an existing folder"},
    Option{"-u,--update", "", "with -O: write only outdated files"},
    Option{"--overwrite", "", "with -O: replace existing files"},
    Option{"-n,--dry-run", "", "print what would be written, but write nothing"},
    durable_option,
};

inline constexpr OptionGroup output_group{"output", output_options};

bool has_pixel(const media::ImageFormat& format, media::Pixel pixel);

// The format that --to names, else the one that the output's name tells. Fails (usage) when neither does.
Result<const media::ImageFormat*> picture_format(const std::optional<std::string>& named, const std::string& output);

// A picture of three display-encoded channels as bytes of a format that has 8 bits a channel.
Result<std::string> encode_for_display(const Image& image, const media::ImageFormat& format);

// --durable: whether what is written from now on is flushed to the disk before it takes its name.
void set_durable_outputs(bool durable);

// To the file, or to standard output for "-".
Result<void> write_output(const std::string& output, std::string_view bytes);

struct OutputFile {
    std::string name; // "-" is standard output
    std::string bytes;
};

// All of them or none (FileSet): after a failure every file is what it was.
Result<void> write_outputs(const std::vector<OutputFile>& files);

// A warning for every two outputs whose names are one on a file system that does not tell upper from lower case.
Diagnostics names_that_differ_by_case(std::span<const std::string> outputs);

// The refusal of an output (a "picture", a "profile") and a report that would both go to standard output.
Unexpected both_to_standard_output(std::string_view what = "picture");

// One input and the output that is made of it.
struct Job {
    std::string input;
    std::string output; // "-" is standard output
    std::string name;   // as reports name it: as -o does, or within the folder of -O
    bool skip = false;  // -u: the output is up to date
};

// Of all inputs every step-th, from `first` on.
struct Share {
    std::size_t first = 0;
    std::size_t step = 1;
};

// Pairs the inputs of a share with outputs; `extension` names the files of -O. Fails (usage) when -o and -O are both or
// neither given, -o stands beside several inputs, two inputs (of all) would write the same output, an output is one of
// the inputs, or an output exists and may not be replaced; (io) when -O names no folder.
Result<std::vector<Job>> plan_outputs(const Arguments& arguments, const std::vector<std::string>& inputs,
                                      std::string_view extension, Share share = {});

} // namespace gonio::cli
