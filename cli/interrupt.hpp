// What signals do to the tool.
//
// One that ends it removes its temporary files first. Ctrl-C can be a question instead: long work asks whether to end
// and says what is done; a second Ctrl-C ends the program at once.
#pragma once

namespace gonio::cli {

// The exit status that shells give what a Ctrl-C ended.
inline constexpr int interrupted_status = 130;

// From now on no signal that asks the tool to end leaves a temporary file.
void clean_up_after_signals();

// From now on the first Ctrl-C does not end the program.
void listen_for_interrupt();

// Whether there was one.
bool interrupted();

} // namespace gonio::cli
