// From what was rendered to the bytes of a picture file.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>

#include "../console.hpp"
#include "request.hpp"

#include <string>

namespace gonio::cli {

struct EncodedPicture {
    std::string bytes;
    Ev100 exposure; // which it was exposed by; of a linear picture the one that would be
};

// Integer formats: exposed and through the display transform; float formats: linear Rec.709 in cd/m².
Result<EncodedPicture> encode_picture(Rendering rendering, const PreviewRequest& request, const Console& console);

} // namespace gonio::cli
