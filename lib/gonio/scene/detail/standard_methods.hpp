// What is compiled where nobody can choose a method.
#pragma once

namespace gonio::detail {

// With GONIO_STANDARD_METHODS nothing is compiled for the luminance by named methods or by the reference: they give no
// number.
#ifdef GONIO_STANDARD_METHODS
inline constexpr bool has_named_luminance = false;
#else
inline constexpr bool has_named_luminance = true;
#endif

} // namespace gonio::detail
