// The JSON record of a profile's facts, schema gonio.info/1: what `gonio info --json` prints.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/base/json.hpp>
#include <gonio/light/profile_facts.hpp>

#include <string>

namespace gonio {

// Keys in a fixed order, two spaces of indentation, a newline at the end; numbers read back as the same doubles. `file`
// is the name as the user gave it; the facts are all of them.
std::string facts_record(const std::string& file, const ProfileFacts& facts, const Diagnostics& diagnostics);

namespace detail {

// The same as a value, for a report of many profiles.
Json facts_json(const std::string& file, const ProfileFacts& facts, const Diagnostics& diagnostics);

} // namespace detail

} // namespace gonio
