// Text of photometric files: bytes, kept unchanged, and their form for display.
//
// LM-63 and EULUMDAT do not name an encoding. Recent files are UTF-8, older ones mostly Windows-1252. A Profile keeps
// the bytes, so that writing restores them. Reports must be UTF-8 and convert the text they show.
#pragma once

#include <string>
#include <string_view>

namespace gonio {

// Whether `bytes` is well-formed UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF.
bool is_utf8(std::string_view bytes);

// The text of `bytes` in UTF-8: unchanged if it is well-formed, otherwise read as Windows-1252, in which every byte has
// a meaning (the five undefined ones become the control codes of the same number).
std::string to_utf8(std::string_view bytes);

// UTF-16 code units, low byte first unless `big_endian`, as UTF-8. Unpaired surrogates and a left-over byte become
// U+FFFD.
std::string utf16_to_utf8(std::string_view bytes, bool big_endian);

} // namespace gonio
