#include "unexpected.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace gonio::cli {

namespace {

Error out_of_memory(std::string input) {
    return fail("UNS0103", "out of memory",
                "give it more memory (ulimit -v shows the limit), fewer threads (-j 1), or less to do at once",
                std::move(input))
        .value();
}

} // namespace

Error unexpected_error(std::string input) {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return out_of_memory(std::move(input));
    } catch (const std::length_error&) { // more elements than a container can address
        return out_of_memory(std::move(input));
    } catch (const std::exception& error) {
        return fail(Failure::internal, fmt::format("internal error: {}", error.what()), {}, std::move(input)).value();
    } catch (...) {
        return fail(Failure::internal, "internal error: an unknown exception", {}, std::move(input)).value();
    }
}

} // namespace gonio::cli
