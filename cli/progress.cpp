#include "progress.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>

namespace gonio::cli {

namespace {

constexpr double patience_ms = 1000.0; // shorter work needs no bar
constexpr double redraw_ms = 100.0;
constexpr std::size_t bar_width = 24;
constexpr std::size_t name_width = 40;

} // namespace

void Progress::show(std::size_t done, std::string_view latest) {
    if (!wanted_ || done >= total_) return;
    const double now_ms = since_start_.milliseconds();
    if (now_ms < patience_ms || now_ms - last_ms_ < redraw_ms) return;
    last_ms_ = now_ms;
    drawn_ = true;
    const std::size_t filled = bar_width * done / total_;
    // The end of a path distinguishes files; its beginning rarely does.
    if (latest.size() > name_width) latest.remove_prefix(latest.size() - name_width);
    const std::string line = fmt::format("\r\x1b[K[{}{}] {}/{} {}", std::string(filled, '#'),
                                         std::string(bar_width - filled, '.'), done, total_, latest);
    (void)std::fputs(line.c_str(), stderr);
    (void)std::fflush(stderr);
}

void Progress::clear() {
    if (!drawn_) return;
    (void)std::fputs("\r\x1b[K", stderr);
    (void)std::fflush(stderr);
    drawn_ = false;
}

} // namespace gonio::cli
