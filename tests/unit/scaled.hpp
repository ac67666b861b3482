// Counts of cases, scaled down where a sanitizer slows everything: it looks for faults of memory, which the first cases
// show, and not for the accuracy of many. A test that is only about numbers, and runs no line that a smaller one does
// not run, is skipped there: `if (test::is_sanitized) GTEST_SKIP() << "which one";`.
#pragma once

#include <array>
#include <cstddef>
#include <span>

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

// Long cases: the first alone.
template<class T, std::size_t n>
constexpr std::span<const T> scaled(const std::array<T, n>& cases) {
    return std::span<const T>(cases).first(is_sanitized ? 1 : n);
}

} // namespace gonio::test
