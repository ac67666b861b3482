// What reading a profile takes from the heap: at most eight bytes for each number and 64 KiB beside the bytes of the
// file, and no allocation for each number. Counts by replacing operator new, so it is a program of its own.
#include <gonio/profile/read.hpp>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>

namespace {

std::size_t held = 0;
std::size_t most_held = 0;
std::size_t allocations = 0;

constexpr std::size_t header = alignof(std::max_align_t); // in front of each block: its size

} // namespace

void* operator new(std::size_t size) {
    void* const block = std::malloc(size + header);
    if (block == nullptr) std::abort();
    *static_cast<std::size_t*>(block) = size;
    held += size;
    most_held = held > most_held ? held : most_held;
    ++allocations;
    return static_cast<std::byte*>(block) + header;
}

void operator delete(void* p) noexcept {
    if (p == nullptr) return;
    void* const block = static_cast<std::byte*>(p) - header;
    held -= *static_cast<std::size_t*>(block);
    std::free(block);
}

void operator delete(void* p, std::size_t) noexcept {
    operator delete(p);
}

namespace {

using namespace gonio;

std::string angles(int count, double step, const char* separator) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += std::to_string(i * step) + separator;
    return text;
}

std::string ies(int planes, int rows) {
    std::string text =
        "IESNA:LM-63-2002\r\n[TEST] 1\r\n[TESTLAB] l\r\n[ISSUEDATE] d\r\n[MANUFAC] m\r\nTILT=NONE\r\n1 -1 1 " +
        std::to_string(rows) + " " + std::to_string(planes) + " 1 2 0 0 0\r\n1 1 1\r\n";
    text += angles(rows, 180.0 / (rows - 1), " ") + "\r\n" + angles(planes, 360.0 / (planes - 1), "\r\n");
    for (int i = 0; i < planes * rows; ++i)
        text += std::to_string(i % 1000) + (i % 12 == 11 ? "\r\n" : " ");
    return text;
}

std::string ldt(int planes, int rows) {
    std::string text = "company\r\n1\r\n0\r\n" + std::to_string(planes) + "\r\n" + std::to_string(360.0 / planes) +
                       "\r\n" + std::to_string(rows) + "\r\n" + std::to_string(180.0 / (rows - 1)) +
                       "\r\nr\r\nn\r\nu\r\nf\r\nd\r\n";
    for (int i = 0; i < 13; ++i)
        text += "1\r\n";
    text += "1\r\n1\r\nLED\r\n1000\r\n3000\r\n80\r\n10\r\n";
    for (int i = 0; i < 10; ++i)
        text += "0.5\r\n";
    text += angles(planes, 360.0 / planes, "\r\n") + angles(rows, 180.0 / (rows - 1), "\r\n");
    for (int i = 0; i < planes * rows; ++i)
        text += std::to_string(i % 1000) + ".5\r\n";
    return text;
}

bool fits(const char* name, const std::string& bytes, std::size_t numbers) {
    const std::size_t before = held;
    most_held = held;
    allocations = 0;
    bool read = false;
    {
        const Result<Profile> profile = read_profile(bytes, name);
        read = profile.has_value();
    }
    const std::size_t taken = most_held - before;
    const std::size_t allowed = 8 * numbers + 64 * 1024;
    std::printf("%-12s %9zu bytes, %8zu numbers: %9zu bytes taken, %9zu allowed, %zu allocations\n", name, bytes.size(),
                numbers, taken, allowed, allocations);
    constexpr std::size_t most_allocations = 300;
    return read && taken <= allowed && allocations <= most_allocations && held == before;
}

} // namespace

int main() {
    bool good = true;
    for (const int size : {2, 37, 361, 1001}) {
        const auto n = static_cast<std::size_t>(size);
        good = fits("ies", ies(size, size), n * n + 2 * n + 13) && good;
        good = fits("ldt", ldt(size, size), n * n + 2 * n + 32) && good;
    }
    // A count that is only announced is not allocated: each number takes a separator and a digit.
    std::string announced = ies(3, 3);
    announced.replace(announced.find(" 3 3 1 2"), 8, " 3 2147483647 1 2");
    const std::size_t before = held;
    most_held = held;
    static_cast<void>(read_profile(announced, "announced"));
    std::printf("%-12s %9zu bytes: %zu bytes taken\n", "announced", announced.size(), most_held - before);
    good = good && most_held - before <= 4 * announced.size() + 64 * 1024;
    if (!good) std::puts("more than that was taken, or not read, or not given back");
    return good ? 0 : 1;
}
