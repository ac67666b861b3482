// One texture to make: from where, to which files, whether it is there already, and the making.
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
    Job files;
    const media::ImageFormat* format = nullptr;
    media::Pixel pixel = media::Pixel::float32;
    std::vector<std::string> pictures;  // the output, or the six faces of a cube
    std::optional<std::string> sidecar; // nothing: none is written
    std::string recipe;                 // all that the texels depend on but the input's bytes
};

// Fails (usage, unsupported) before any work is done: on outputs that collide, exist or are inputs, on a folder that is
// none, and on what the format cannot hold or the layout cannot have.
Result<std::vector<TextureJob>> plan_textures(const Arguments& arguments, const BakeRequest& request,
                                              const std::vector<std::string>& inputs);

// Whether the files are there, hold what the sidecar says, and were made of the same bytes by the same recipe: what -u
// asks.
bool is_up_to_date(const TextureJob& job);

// Bakes and writes; where one of the files cannot be written, all are what they were.
Result<Made> make_texture(const TextureJob& job, const BakeRequest& request, ReportKind kind);

// What is there already, for a report and a manifest.
Result<Made> found_texture(const TextureJob& job, const BakeRequest& request, ReportKind kind);

} // namespace gonio::cli
