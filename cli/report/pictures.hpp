// The preview pictures of a report: PNG, exposed and through the display transform, as `gonio preview` makes them.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>

#include "../arguments.hpp"
#include "../console.hpp"
#include "../options/values.hpp"
#include "../preview/profile_stages.hpp"
#include "../preview/request.hpp"

#include <memory>
#include <span>
#include <string>

namespace gonio::cli {

inline constexpr PixelSize profile_picture_size{480, 320};
inline constexpr PixelSize rig_picture_size{720, 480};

// What pictures share: threads, bounces, the display transform. The stage is left as it is.
Result<PreviewRequest> picture_request(const Arguments& arguments, unsigned threads);

// Whether pictures can be made: develops and encodes one pixel. Fails (unsupported, UNS0102) without the modules, and
// on a colour configuration that cannot be used.
Result<void> try_pictures(const PreviewRequest& request, const Console& console);

// An <img> element of these pixels. Fails as render() and encode_picture() do.
Result<std::string> profile_picture(const std::string& file, ProfileShape profile, const PreviewRequest& request,
                                    ProfileStages& stages, const Console& console, Diagnostics& diagnostics);
Result<std::string> rig_picture(const std::string& rig, std::span<const Light> lights, const PreviewRequest& request,
                                const Console& console);

} // namespace gonio::cli
