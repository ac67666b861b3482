// Numbers as photometric files write them. Internal.
#pragma once

#include <string>

namespace gonio::profile_detail {

// Appends the shortest decimal text that reads back as the same double. From 1e-30 to 1e15 it has no exponent, because
// some readers reject exponents and others stop at them. `value` must be finite.
void append_number(std::string& text, double value);

// The same for numbers one after another: those of a table mostly have as many decimals as the ones before.
class NumberText {
public:
    void append(std::string& text, double value);

private:
    int decimals_ = 0; // tried first
};

} // namespace gonio::profile_detail
