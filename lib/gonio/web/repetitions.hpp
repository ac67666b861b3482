// A report of one file in which nothing is said twice.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/web/resolve.hpp>

namespace gonio {

// What there is to say about a profile: `read`, by its reader, then by resolving and check_plausibility().
Diagnostics report_of(Diagnostics read, const Profile& profile, const ResolvedWeb& resolved,
                      const ResolveOptions& options = {});

// Removes the diagnostics of resolving (WEB01…) that repeat one of the reader's, which has a place in the file.
void drop_repetitions(Diagnostics& diagnostics);

} // namespace gonio
