// The size that a picture or texture may have: one limit for all that make one.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstdint>
#include <string_view>

namespace gonio {

// Fails (usage) on a side below 1 or above the limit `side`, and on more pixels than the limit picture-pixels. `what`
// and `unit` name it in the message: "a picture of 30000x30000 pixels".
Result<void> check_picture_size(std::int64_t width, std::int64_t height, const Limit& side = limit("picture-side"),
                                std::string_view what = "a picture", std::string_view unit = "pixels");

} // namespace gonio
