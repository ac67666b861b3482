// A profile's facts in words: what `gonio info` prints, and a report shows.
#pragma once

#include <gonio/light/profile_facts.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

struct FactLine {
    std::string_view name; // "beam"
    std::string value;     // "35.0° in C0–C180, none in C90–C270"
};

// In the order in which they are read.
std::vector<FactLine> fact_lines(const ProfileFacts& facts);

// What `gonio info --all` adds; the facts are all of them.
std::vector<FactLine> more_fact_lines(const ProfileFacts& facts);

// Three digits or the whole number, never an exponent below a million: "6.25", "12345".
std::string amount_text(double value);

// "35.0°" or "none".
std::string degrees_or_none(const std::optional<double>& angle);

} // namespace gonio::cli
