// Counts of cases, scaled down where a sanitizer slows everything.
#pragma once

namespace poses {

constexpr int scaled(int count) {
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    return count / 20;
#endif
#endif
    return count;
}

} // namespace poses
