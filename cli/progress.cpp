#include "progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace gonio::cli {

namespace {

constexpr double patience_ms = 1000.0; // shorter work needs no bar
constexpr double redraw_ms = 100.0;
constexpr std::size_t bar_width = 24;
constexpr std::size_t name_width = 40;

// "8 s left", "12 min left", "3 h 20 min left".
std::string time_left(double seconds) {
    if (seconds < 99.5) return fmt::format("{:.0f} s left", std::ceil(seconds));
    const auto minutes = static_cast<long long>(std::ceil(seconds / 60.0));
    if (minutes < 100) return fmt::format("{} min left", minutes);
    return fmt::format("{} h {} min left", minutes / 60, minutes % 60);
}

// How fast it goes, if that is worth a number, and how long it will take: as the items before, on average.
std::string pace(std::size_t done, std::size_t total, double elapsed_ms) {
    if (done == 0) return "";
    const double per_s = static_cast<double>(done) / elapsed_ms * 1000.0;
    const std::string left = time_left(static_cast<double>(total - done) / per_s);
    return per_s < 1.0 ? left : fmt::format("{:.0f}/s, {}", per_s, left);
}

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
    const std::string line =
        fmt::format("\r\x1b[K[{}{}] {}/{}, {} {}", std::string(filled, '#'), std::string(bar_width - filled, '.'), done,
                    total_, pace(done, total_, now_ms), latest);
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
