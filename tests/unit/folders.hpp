// Where the tests find what is not compiled into them. One source file has the paths, so that the others are the same
// for every checkout and a compiler cache knows them again.
#pragma once

namespace gonio::test {

extern const char* const source_folder;  // this project's tree
extern const char* const modules_folder; // where the media modules are built
extern const char* const fakes_folder;   // modules that are wrong in one way each
extern const char* const corpus_folder;  // real profiles; empty where there are none: skip those tests and say so

} // namespace gonio::test
