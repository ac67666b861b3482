#include "unexpected.hpp"

#include <gonio/base/file_set.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::string_view no_memory = "out of memory";
constexpr std::string_view no_memory_hint =
    "give it more memory (ulimit -v shows the limit), fewer threads (-j 1), or less to do at once";

Error out_of_memory(std::string input) {
    return fail("UNS0103", std::string(no_memory), std::string(no_memory_hint), std::move(input)).value();
}

// Whether the program ends because of missing memory: without memory not even an exception can be made, and then the
// program ends without one.
bool lacks_memory() {
    if (!std::current_exception()) {
        void* const probe = std::malloc(2048); // more than any exception
        std::free(probe);
        return probe == nullptr;
    }
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return true;
    } catch (const std::length_error&) {
        return true;
    } catch (...) {
        return false;
    }
}

std::terminate_handler end_otherwise = std::abort;

// How the program ends from now on if an exception cannot be thrown. Allocates nothing.
[[noreturn]] void end() {
    remove_temporary_files();
    if (!lacks_memory()) {
        end_otherwise();
        std::abort();
    }
    for (const std::string_view part : {std::string_view("error[UNS0103]: "), no_memory, std::string_view("\nhint: "),
                                        no_memory_hint, std::string_view("\n")})
        (void)!::write(STDERR_FILENO, part.data(), part.size());
    ::_exit(static_cast<int>(Failure::unsupported));
}

// Before the initialisation of other static objects, which may allocate.
[[gnu::constructor(101)]] void explain_lack_of_memory() {
    end_otherwise = std::set_terminate(end);
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
