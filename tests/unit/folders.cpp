#include "folders.hpp"

namespace gonio::test {

const char* const source_folder = GONIO_TEST_SOURCE;
const char* const modules_folder = GONIO_TEST_MODULES;
const char* const fakes_folder = GONIO_TEST_FAKE_MODULES;
const char* const corpus_folder = GONIO_TEST_CORPUS;

} // namespace gonio::test
