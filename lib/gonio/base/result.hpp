// Result<T>: failure is a value. Nothing in gonio throws across its public interface.
//
// An Error states the kind of failure, which decides the tool's exit status, and carries every diagnostic that
// was collected up to it; the last one of severity `error` is the reason.
#pragma once

#include <gonio/base/codes/failure.hpp>
#include <gonio/base/diagnostics.hpp>

#include <tl/expected.hpp>

#include <array>
#include <string>
#include <string_view>
#include <utility>

#pragma GCC visibility push(default)
namespace gonio {

// The values are the exit statuses of the command-line tool.
enum class Failure {
    usage = 2,       // the request is invalid: a lamp of -3 m, nits of a point
    io = 3,          // the system refused: no such file, disk full
    malformed = 4,   // the input is malformed
    unsupported = 5, // the input is valid, but gonio cannot do this with it
    internal = 70    // an internal error: a bug
};

// Its members are compiled once: every Result has them.
struct Error {
    Failure failure = Failure::internal;
    Diagnostics diagnostics;

    Error() noexcept;
    Error(Failure failure, Diagnostics diagnostics) noexcept;
    Error(const Error& other);
    Error(Error&& other) noexcept;
    Error& operator=(const Error& other);
    Error& operator=(Error&& other) noexcept;
    ~Error();
};

// The family of codes/failure.hpp for each failure.
struct FailureFamily {
    Failure failure;
    std::string_view family;
};
// The family of codes that each class of failure has.
inline constexpr std::array failure_families{
    FailureFamily{Failure::usage, "USE"},     FailureFamily{Failure::io, "FIL"},
    FailureFamily{Failure::malformed, "INP"}, FailureFamily{Failure::unsupported, "UNS"},
    FailureFamily{Failure::internal, "INT"},
};

// Why something fails: a code of codes/failure.hpp, written as its text, or a Failure, which has the general code of
// its family.
class Cause {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a code is written as its text
    consteval Cause(const char* code) : row_(&*CodeOf<failure_codes>(code)) {}
    // NOLINTNEXTLINE(google-explicit-constructor): a failure without a class of its own
    constexpr Cause(Failure failure) {
        for (const FailureFamily& of : failure_families)
            for (const DiagnosticCode& row : failure_codes)
                if (of.failure == failure && code_family(row.code) == of.family && row_ == nullptr) row_ = &row;
    }

    [[nodiscard]] constexpr Failure failure() const {
        for (const FailureFamily& of : failure_families)
            if (code_family(row_->code) == of.family) return of.failure;
        return Failure::internal;
    }
    [[nodiscard]] constexpr std::string_view code() const { return row_->code; }

private:
    const DiagnosticCode* row_ = nullptr; // one pointer, which costs nothing to pass
};

// A value, or the error that prevented it.
template<class T>
using Result = tl::expected<T, Error>;

// An error that converts to any Result.
using Unexpected = tl::unexpected<Error>;

// An error at a place in an input, described in one sentence.
Error error_at(Cause cause, Location location, std::string message, std::string hint = {});

// return fail("USE0104", "a sphere needs a radius", "write sphere:r=3cm");
// Text of the source is passed as it is: strings made of it at a thousand places are much code.
Unexpected fail(Cause cause, const char* message, const char* hint = "");
Unexpected fail(Cause cause, const std::string& message, const char* hint = "");
Unexpected fail(Cause cause, const std::string& message, const std::string& hint, const std::string& file = {});

// Replaces the hint of the diagnostic that is the reason of the error.
void error_hint(Error& error, std::string hint);

// return pass_on(result); passes the error of one Result on as the error of another.
template<class T>
Unexpected pass_on(Result<T>& result) {
    return Unexpected(std::move(result.error()));
}

} // namespace gonio
#pragma GCC visibility pop
