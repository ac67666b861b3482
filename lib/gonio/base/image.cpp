#include <gonio/base/image.hpp>

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace gonio {

namespace {

// Asks for large pages: a picture's memory comes page by page when it is first written, and each costs more than
// writing it. A wish, which fails where the system has none.
void ask_for_large_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t size) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
    constexpr std::uintptr_t page = 2 << 20;
    const auto from = reinterpret_cast<std::uintptr_t>(data);
    const std::uintptr_t first = (from + page - 1) / page * page;
    const std::uintptr_t end = (from + size) / page * page;
    if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

} // namespace

Image::Image(int w, int h, int c) : width(w), height(h), channels(c) {
    const std::size_t count = static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c);
    pixels.reserve(count);
    ask_for_large_pages(pixels.data(), count * sizeof(float));
    pixels.resize(count);
}

} // namespace gonio
