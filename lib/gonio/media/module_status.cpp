#include <gonio/media/detail/open_module.hpp>

namespace gonio::media::detail {

Cause cause_of(int status) {
    switch (static_cast<abi::Status>(status)) {
    case abi::io:
        return Failure::io;
    case abi::malformed:
        return Failure::malformed;
    case abi::unsupported:
        return Failure::unsupported;
    case abi::out_of_memory:
        return "UNS0103";
    case abi::no_threads:
        return "FIL0106";
    case abi::done:
    case abi::internal:
        break;
    }
    return Failure::internal;
}

} // namespace gonio::media::detail
