// The machine and the build of a measurement.
#pragma once

#include <string>

namespace gonio::measure {

struct Machine {
    std::string processor; // "AMD EPYC 7B13"; "unknown" if the system does not report it
    unsigned threads = 1;  // that this process may run on
    std::string widest;    // instruction set: "avx512"
};
Machine this_machine();

struct Build {
    std::string version;    // of gonio
    std::string compiler;   // "g++ 12.2.0"
    bool optimized = false; // if false, times mean little
    bool checked = false;   // by a sanitizer: times mean little then too
};
Build this_build();

} // namespace gonio::measure
