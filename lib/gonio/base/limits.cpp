#include <gonio/base/limits.hpp>

#include <fmt/format.h>

namespace gonio {

std::string amount_of(const Limit& limit) {
    if (limit.unit == "bytes" && limit.value % mebibyte == 0) return fmt::format("{} MiB", limit.value / mebibyte);
    if (limit.unit == "bytes" && limit.value % kibibyte == 0) return fmt::format("{} KiB", limit.value / kibibyte);
    return fmt::format("{} {}", limit.value, limit.unit);
}

std::string to_text(const Limit& limit) {
    return fmt::format("{}, the limit '{}'", amount_of(limit), limit.name);
}

} // namespace gonio
