#include <gonio/base/file.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/version.hpp>
#include <gonio/measure/machine.hpp>
#include <gonio/simd/dispatch.hpp>

#include <string_view>

namespace gonio::measure {

namespace {

// Linux, x86 and most arm64 systems: "model name : AMD EPYC".
std::string processor_name() {
    const Result<std::string> start = read_file_start("/proc/cpuinfo", 4096);
    if (!start) return "unknown";
    constexpr std::string_view key = "model name";
    const std::size_t line = start->find(key);
    if (line == std::string::npos) return "unknown";
    const std::size_t begin = start->find_first_not_of(" \t:", line + key.size());
    const std::size_t end = start->find('\n', line);
    if (begin == std::string::npos || end == std::string::npos || begin >= end) return "unknown";
    return start->substr(begin, end - begin);
}

} // namespace

Machine this_machine() {
    return {processor_name(), available_threads(), simd::to_text(simd::best_available())};
}

Build this_build() {
    Build build;
    build.version = gonio::version;
#if defined(__clang__)
    build.compiler = "clang " __clang_version__;
    while (build.compiler.ends_with(' '))
        build.compiler.pop_back();
#else
    build.compiler = "g++ " __VERSION__;
#endif
#if defined(__OPTIMIZE__)
    build.optimized = true;
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    build.checked = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    build.checked = true;
#endif
#endif
    return build;
}

} // namespace gonio::measure
