// How the tool handles signals.
//
// A signal that ends the tool removes its temporary files first. Long work can use Ctrl-C as a request: it checks
// whether to end and reports what is done; a second Ctrl-C ends the program at once.
#pragma once

namespace gonio::cli {

// The exit status that shells report for a program ended by Ctrl-C.
inline constexpr int interrupted_status = 130;

// From now on no signal that ends the tool leaves a temporary file behind.
void clean_up_after_signals();

// From now on the first Ctrl-C does not end the program.
void listen_for_interrupt();

// Whether Ctrl-C was pressed.
bool interrupted();

} // namespace gonio::cli
