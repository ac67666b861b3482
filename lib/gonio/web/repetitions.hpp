// A report of one file in which nothing is said twice.
#pragma once

#include <gonio/base/diagnostics.hpp>

namespace gonio {

// Removes the diagnostics of resolving (WEB01…) that repeat one of the reader's, which has a place in the file.
void drop_repetitions(Diagnostics& diagnostics);

} // namespace gonio
