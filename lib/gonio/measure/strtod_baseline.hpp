// The baseline for readers of text: the C library's conversion over the same bytes and nothing else.
#pragma once

#include <cstdlib>
#include <string>

namespace gonio::measure {

// The sum of all numbers in the text; anything that is not a number is skipped byte by byte.
inline double sum_by_strtod(const std::string& text) {
    const char* at = text.c_str();
    const char* const end = at + text.size();
    double sum = 0.0;
    while (at < end) {
        char* stop = nullptr;
        sum += std::strtod(at, &stop);
        at = stop == at ? at + 1 : stop;
    }
    return sum;
}

} // namespace gonio::measure
