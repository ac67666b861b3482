// The requirements of every fuzz target on a reader.
#pragma once

#include <gonio/base/result.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace gonio::fuzz {

inline void require(bool holds) {
    if (!holds) std::abort();
}

// A refusal has one reason: a message with severity error, reported last. An internal error is never a valid answer.
inline void require_reason(const Error& error) {
    const Diagnostics& said = error.diagnostics;
    const auto is_error = [](const Diagnostic& one) { return one.severity == Severity::error; };
    require(error.failure != Failure::internal);
    require(std::count_if(said.begin(), said.end(), is_error) == 1 && is_error(said.back()));
    require(!said.back().message.empty());
}

inline bool same_words(const Error& a, const Error& b) {
    return a.failure == b.failure && a.diagnostics.size() == b.diagnostics.size() &&
           std::equal(a.diagnostics.begin(), a.diagnostics.end(), b.diagnostics.begin(),
                      [](const Diagnostic& x, const Diagnostic& y) { return to_text(x) == to_text(y); });
}

// Reads twice and checks that both agree: in their errors, or in what `same` compares. Returns the first result.
template<class Read, class Same>
auto read_twice(const Read& read, const Same& same) {
    auto first = read();
    const auto second = read();
    require(first.has_value() == second.has_value());
    if (first) {
        require(same(*first, *second));
    } else {
        require_reason(first.error());
        require(same_words(first.error(), second.error()));
    }
    return first;
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as text
    return {reinterpret_cast<const char*>(data), size};
}

// Removes the first byte of `text`: the choice among `count` readers. Letters from 'a' on, so that seeds are readable.
inline std::size_t take_choice(std::string_view& text, std::size_t count) {
    const auto byte = static_cast<unsigned char>(text.front());
    text.remove_prefix(1);
    return (byte + std::size_t{256} - 'a') % 256 % count;
}

} // namespace gonio::fuzz
