// The allowed size of a picture or texture: one limit for all code that makes one.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstdint>
#include <string_view>

namespace gonio {

// For pictures other than textures. (clang 14 does not accept a consteval call as a default argument.)
inline constexpr const Limit& longest_picture_side = limit("picture-side");

// Fails (usage) on a side below 1 or above the limit `side`, and on more pixels than the limit picture-pixels. `what`
// and `unit` name it in the message: "a picture of 30000x30000 pixels".
Result<void> check_picture_size(std::int64_t width, std::int64_t height, const Limit& side = longest_picture_side,
                                std::string_view what = "a picture", std::string_view unit = "pixels");

} // namespace gonio
