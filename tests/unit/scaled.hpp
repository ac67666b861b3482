// Counts of cases, scaled down where a sanitizer slows everything: it looks for faults of memory, which the first cases
// show, and not for the accuracy of many.
#pragma once

#include <cstddef>

namespace gonio::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif
#else
inline constexpr bool is_sanitized = false;
#endif

constexpr int scaled(int count) {
    return is_sanitized ? count / 20 : count;
}
constexpr std::size_t scaled(std::size_t count) {
    return is_sanitized ? count / 20 : count;
}

} // namespace gonio::test
