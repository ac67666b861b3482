// One texture to make: its input, its files, whether they are up to date, and how it is made.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/media/image_file.hpp>

#include "../batch.hpp"
#include "../catalogue.hpp"
#include "../options/output.hpp"
#include "request.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

struct TextureJob {
    const BakeRequest* request = nullptr;
    Job files;
    const media::ImageFormat* format = nullptr;
    media::Pixel pixel = media::Pixel::float32;
    std::vector<std::string> pictures;  // the output, or the six faces of a cube
    std::optional<std::string> sidecar; // empty: none is written
    std::string recipe;                 // everything except the input's bytes that the texels depend on
};

// Fails (usage, unsupported) before any work is done: on outputs that collide, exist or are inputs, on a folder that is
// not one, and on anything the format cannot store or the layout does not support. The request must outlive the jobs.
Result<std::vector<TextureJob>> plan_textures(const Arguments& arguments, const BakeRequest& request,
                                              const std::vector<std::string>& inputs);

// Whether the files exist, match the sidecar, and were made from the same bytes by the same recipe (for -u).
bool is_up_to_date(const TextureJob& job);

// Bakes and writes. If one of the files cannot be written, all files stay as they were.
Result<Made> make_texture(const TextureJob& job, ReportKind kind);

// Describes the existing files, for a report and a manifest.
Result<Made> found_texture(const TextureJob& job, ReportKind kind);

} // namespace gonio::cli
