#include "to_js.hpp"

#include <string>

namespace gonio::wasm {

using emscripten::val;

val to_js(const Diagnostics& diagnostics) {
    val list = val::array();
    for (const Diagnostic& diagnostic : diagnostics) {
        val entry = val::object();
        entry.set("code", diagnostic.code);
        entry.set("severity", std::string(to_text(diagnostic.severity)));
        entry.set("file", diagnostic.location.file);
        entry.set("line", diagnostic.location.line);
        entry.set("column", diagnostic.location.column);
        entry.set("message", diagnostic.message);
        entry.set("hint", diagnostic.hint);
        list.call<void>("push", entry);
    }
    return list;
}

void throw_js(const Error& error) {
    const Diagnostic& last = error.diagnostics.back();
    val thrown = val::global("Error").new_(to_text(last));
    thrown.set("code", last.code);
    thrown.set("hint", last.hint);
    thrown.set("diagnostics", to_js(error.diagnostics));
    thrown.throw_();
}

} // namespace gonio::wasm
