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
    const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(data) % page) % page;
    if (size < before + page) return;
    (void)madvise(static_cast<char*>(data) + before, (size - before) / page * page, MADV_HUGEPAGE);
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
