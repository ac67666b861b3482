// Result<T>: failure is a value. Nothing in gonio throws across its public interface.
//
// An Error states the kind of failure, which decides the tool's exit status, and carries every diagnostic that
// was collected up to it; the last one of severity `error` is the reason.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace gonio {

// The values are the exit statuses of the command-line tool.
enum class Failure {
    usage = 2,       // the request is invalid: a lamp of -3 m, nits of a point
    io = 3,          // the system refused: no such file, disk full
    malformed = 4,   // the input is malformed
    unsupported = 5, // the input is valid, but gonio cannot do this with it
    internal = 70    // an internal error: a bug
};

struct Error {
    Failure failure = Failure::internal;
    Diagnostics diagnostics;
};

template<class T>
using Result = tl::expected<T, Error>;

using Unexpected = tl::unexpected<Error>;

// return fail(Failure::usage, "a sphere needs a radius", "write sphere:r=3cm");
inline Unexpected fail(Failure failure, std::string message, std::string hint = {}, std::string file = {}) {
    Error error{failure, {}};
    error.diagnostics.push_back({{}, Severity::error, {std::move(file), 0, 0}, std::move(message), std::move(hint)});
    return Unexpected(std::move(error));
}

// Replaces the hint of the diagnostic that is the reason of the error.
inline void error_hint(Error& error, std::string hint) {
    if (!error.diagnostics.empty()) error.diagnostics.back().hint = std::move(hint);
}

// return pass_on(result); hands the error of one Result on as that of another.
template<class T>
Unexpected pass_on(Result<T>& result) {
    return Unexpected(std::move(result.error()));
}

} // namespace gonio
