// Ctrl-C as a question: long work asks whether to end and says what is done. A second Ctrl-C ends the program at once.
#pragma once

namespace gonio::cli {

// The exit status that shells give what a Ctrl-C ended.
inline constexpr int interrupted_status = 130;

// From now on Ctrl-C does not end the program.
void listen_for_interrupt();

// Whether there was one.
bool interrupted();

} // namespace gonio::cli
