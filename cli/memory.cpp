#include "memory.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace gonio::cli {

void keep_freed_memory() {
#if defined(__GLIBC__)
    // Bytes. Large pictures go back to the system; with a quarter of it, a million lights took a fifth longer to read.
    constexpr int largest_kept = 16 << 20;
    constexpr int most_kept = 128 << 20;
    mallopt(M_MMAP_THRESHOLD, largest_kept);
    mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

} // namespace gonio::cli
