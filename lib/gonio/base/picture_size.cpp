#include <gonio/base/picture_size.hpp>

#include <fmt/format.h>

#include <string>

namespace gonio {

Result<void> check_picture_size(std::int64_t width, std::int64_t height, const Limit& side, std::string_view what,
                                std::string_view unit) {
    const auto refuse = [&](const std::string& reason) {
        return fail("USE0106", fmt::format("{} of {}x{} {} is out of range: {}", what, width, height, unit, reason),
                    std::string(limits_hint));
    };
    const auto longest = static_cast<std::int64_t>(side.value);
    const auto most = static_cast<std::int64_t>(limit("picture-pixels").value);
    if (width < 1 || height < 1 || width > longest || height > longest)
        return refuse(fmt::format("a side may have 1 to {}", to_text(side)));
    if (width > most / height) return refuse(fmt::format("it may have up to {}", to_text(limit("picture-pixels"))));
    return {};
}

} // namespace gonio
