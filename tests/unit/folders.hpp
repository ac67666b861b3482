// The locations of files that are not compiled into the tests. Only one source file contains the paths, so that all
// others are the same in every checkout and a compiler cache recognises them.
#pragma once

namespace gonio::test {

extern const char* const source_folder;  // this project's tree
extern const char* const modules_folder; // where the media modules are built
extern const char* const fakes_folder;   // modules with one defect each
extern const char* const corpus_folder;  // real profiles; empty if there are none: skip those tests and report it

} // namespace gonio::test
