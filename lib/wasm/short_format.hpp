// fmt::format with less code where it is called: what is formatted is handed on as it is, and one function for each
// list of types makes fmt's arguments of it. fmt itself makes them in each place, and passes them and the text by
// value, which are two copies more in WebAssembly. The precompiled headers include this.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#if FMT_VERSION >= 90000 && FMT_VERSION < 100000
FMT_BEGIN_NAMESPACE

namespace detail {

template<class T>
using HandedOn = std::conditional_t<std::is_scalar_v<T>, T, const T&>;

template<class... T>
std::string format_of(const char* text, std::size_t size, HandedOn<T>... what) {
    return vformat({text, size}, fmt::make_format_args(what...));
}

} // namespace detail

// The constraint makes it the better choice of two that take the same.
template<class... T>
requires(sizeof...(T) > 0) std::string format(format_string<T...> text, T&&... what) {
    const string_view view = text;
    return detail::format_of<std::decay_t<T>...>(view.data(), view.size(), what...);
}

FMT_END_NAMESPACE
#endif
