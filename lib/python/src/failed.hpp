// How an error of the library leaves a function of the module.
#pragma once

#include <gonio/base/result.hpp>

namespace gonio::python {

// Becomes a gonio.Error of Python.
struct Failed {
    Error error;
};

} // namespace gonio::python
