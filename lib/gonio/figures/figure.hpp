// Figure: a figure of a luminaire, or the reason why its profile does not give it.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

#pragma GCC visibility push(default)
namespace gonio {

// The reason reads on from the figure's name: "the file states no luminous opening".
template<class T>
using Figure = tl::expected<T, std::string>;

// A figure that there is not.
inline tl::unexpected<std::string> no_figure(std::string reason) {
    return tl::unexpected<std::string>(std::move(reason));
}

} // namespace gonio
#pragma GCC visibility pop
