// Numbers as photometric files write them. Internal.
#pragma once

#include <string>

namespace gonio::profile_detail {

// Appends the shortest decimal text that reads back as the same double. From 1e-30 to 1e15 it has no exponent, because
// some readers reject exponents and others stop at them. `value` must be finite.
void append_number(std::string& text, double value);

} // namespace gonio::profile_detail
