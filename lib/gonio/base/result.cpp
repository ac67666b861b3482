#include <gonio/base/result.hpp>

namespace gonio {

Error::Error() noexcept = default;
Error::Error(Failure why, Diagnostics what) noexcept : failure(why), diagnostics(std::move(what)) {}
Error::Error(const Error& other) = default;
Error::Error(Error&& other) noexcept = default;
Error& Error::operator=(const Error& other) = default;
Error& Error::operator=(Error&& other) noexcept = default;
Error::~Error() = default;

Error error_at(Cause cause, Location location, std::string message, std::string hint) {
    Diagnostics diagnostics;
    diagnostics.push_back(
        {std::string(cause.code()), Severity::error, std::move(location), std::move(message), std::move(hint)});
    return {cause.failure(), std::move(diagnostics)};
}

Unexpected fail(Cause cause, const char* message, const char* hint) {
    return Unexpected(error_at(cause, {}, message, hint));
}

Unexpected fail(Cause cause, const std::string& message, const char* hint) {
    return Unexpected(error_at(cause, {}, message, hint));
}

Unexpected fail(Cause cause, const std::string& message, const std::string& hint, const std::string& file) {
    return Unexpected(error_at(cause, {file, 0, 0}, message, hint));
}

void error_hint(Error& error, std::string hint) {
    if (!error.diagnostics.empty()) error.diagnostics.back().hint = std::move(hint);
}

} // namespace gonio
