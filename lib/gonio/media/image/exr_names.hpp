// What OpenEXR calls the attributes that OpenImageIO has other names for. Private to media.
#pragma once

#include <string_view>

namespace gonio::media::detail {

inline std::string_view exr_name(std::string_view name) {
    if (name == "ImageDescription") return "comments";
    if (name == "DateTime") return "capDate";
    if (name == "Copyright") return "owner";
    return name;
}

} // namespace gonio::media::detail
