// Numbers as photometric files write them. Internal.
#pragma once

#include <string>

namespace gonio::profile_detail {

// Appends the shortest decimal text that reads back as the same double: without an exponent, which some readers do not
// take and others stop before, from 1e-30 to 1e15. `value` must be finite.
void append_number(std::string& text, double value);

} // namespace gonio::profile_detail
