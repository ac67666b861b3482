// The photometric type of LM-63: how the goniometer turned the luminaire.
#pragma once

#pragma GCC visibility push(default)
namespace gonio {

// The three goniometer geometries of LM-63 (LM-75). EULUMDAT is always C.
enum class Photometry { a, b, c };

} // namespace gonio
#pragma GCC visibility pop
