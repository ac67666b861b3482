// Calls on the vector units: most are over before a person could press Ctrl-C.
#pragma once

#include "binding.hpp"

#include <cstddef>

namespace gonio::python {

// Without Python's lock; on a thread of its own, which can be interrupted, only if there is work for longer than some
// tenths of a second.
template<class Work>
void short_or_interruptible(std::size_t evaluations, const Work& work) {
    constexpr std::size_t most = 10'000'000;
    if (evaluations > most) {
        interruptible([&] {
            work();
            return true;
        });
        return;
    }
    const py::gil_scoped_release released;
    work();
}

} // namespace gonio::python
