// The nearest of a list of names to a mistyped one, for "did you mean …?".
#pragma once

#include <span>
#include <string_view>

namespace gonio {

// By edit distance with transpositions (optimal string alignment), ignoring case. Empty when nothing is near: more than
// a third of the letters (at least one, at most three) would have to change. The first one of equals.
std::string_view nearest(std::string_view name, std::span<const std::string_view> candidates);

} // namespace gonio
