// What every file of the module needs: diagnostics and failures as JavaScript has them.
#pragma once

#include <gonio/base/result.hpp>

#include <emscripten/val.h>
#include <utility>

namespace gonio::wasm {

// [{code, severity, file, line, column, message, hint}, …]
emscripten::val to_js(const Diagnostics& diagnostics);

// Throws an Error of JavaScript with the message of the tool, `code` and all `diagnostics`.
[[noreturn]] void throw_js(const Error& error);

template<class T>
T value_of(Result<T>&& result) {
    if (!result) throw_js(result.error());
    return std::move(*result);
}

} // namespace gonio::wasm
