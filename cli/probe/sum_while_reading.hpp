// The light of a large rig summed up while the rig is read, so that its lights need not be kept.
#pragma once

#include "request.hpp"

namespace gonio::cli {

// Fills `summed` of the request, whose points and options are complete, and returns whether it did: only for a rig of
// many lights on its own of which nothing but the sums is asked. All else is left to the usual way. Fails on a mistake
// in the text of the rig.
Result<bool> sum_while_reading(const Arguments& arguments, ProbeRequest& request);

} // namespace gonio::cli
