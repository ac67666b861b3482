#include "memory.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace gonio::cli {

void keep_freed_memory() {
#if defined(__GLIBC__)
    constexpr int largest_kept = 4 << 20; // bytes; pictures and whole files go back to the system
    constexpr int most_kept = 64 << 20;
    mallopt(M_MMAP_THRESHOLD, largest_kept);
    mallopt(M_TRIM_THRESHOLD, most_kept);
#endif
}

} // namespace gonio::cli
