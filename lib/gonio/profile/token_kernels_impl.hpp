// The kernels of token_kernels.hpp as templates on the set's scalar; only kernels_tokens.cpp.in includes this.
// Internal.
//
// Everything is a template on S, whose name contains the instruction set, and calls no function of std::.
#pragma once

#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/token_kernels.hpp>
#include <gonio/profile/token_words.hpp>
#include <gonio/profile/token_words_avx2.hpp>
#include <gonio/profile/token_words_avx512.hpp>

#include <cstdint>

namespace gonio::profile_detail {

// Tokens of one piece of a text, as offsets from its first byte. What lies between them separates numbers.
template<class S>
struct Tokens {
    static constexpr unsigned blocks = 16;                            // of 64 bytes, at most
    static constexpr std::size_t most = std::size_t{blocks} * 64 / 2; // a token and what ends it are two bytes
    static constexpr std::size_t overrun = 64;                        // entries that may be written behind the last
    std::uint32_t bounds[2 * most + overrun];                         // where each begins and ends, in turn
    std::size_t ended; // one may have begun after them, which goes on behind the piece

    std::uint32_t begin(std::size_t k) const { return bounds[2 * k]; }
    std::uint32_t end(std::size_t k) const { return bounds[2 * k + 1]; }
};

// Lists the tokens of the text from `text` on that are surely whole, `wanted` of them or more. Returns whether more may
// follow in this way: not after a byte that no number or separator has, and not near the end of the text.
template<class S, Separators separators>
bool find_tokens(const char* text, const char* end, std::size_t wanted, unsigned blocks, Tokens<S>& tokens) {
    std::uint64_t before = 0;    // whether the byte before is numeric
    std::uint64_t cr_before = 0; // whether it is CR
    std::uint64_t wrong = 0;
    std::uint32_t* to = tokens.bounds;
    const auto ended = [&] { return static_cast<std::size_t>(to - tokens.bounds) / 2; };
    std::uint32_t offset = 0;
    for (; offset < blocks * 64 && ended() < wanted; offset += 64) {
        if (end - text < static_cast<std::ptrdiff_t>(offset) + 64 + decimal_lookahead) break;
        const ByteMasks<S> masks = TokenWords<S>::template classify<separators>(text + offset);
        const std::uint64_t numeric = masks.numeric;
        const std::uint64_t after_numeric = numeric << 1U | before;
        if constexpr (separators == Separators::lines) {
            const std::uint64_t after_cr = masks.cr << 1U | cr_before;
            wrong = ~(numeric | masks.cr | masks.lf) | (masks.cr & ~after_numeric) |
                    (masks.lf & ~(after_numeric | after_cr));
            cr_before = masks.cr >> 63U;
        } else {
            wrong = ~(numeric | masks.ends);
        }
        before = numeric >> 63U;
        const std::uint64_t right = (wrong & (0 - wrong)) - 1; // the bytes before the first wrong one
        to = TokenWords<S>::list((numeric ^ after_numeric) & right, offset, to);
        if (wrong != 0) break;
    }
    tokens.ended = ended();
    return wrong == 0 && end - text >= static_cast<std::ptrdiff_t>(offset) + 64 + decimal_lookahead;
}

// From the begin of the text to the end of a token, at least, for methods that read words from 24 bytes before that end
// on: eight bytes lie before the text.
inline constexpr std::uint32_t most_before = 16;

// Repeats the first of `count` tokens until a pack is full.
template<class S>
void fill_pack(std::uint32_t* bounds, std::size_t count) {
    for (std::size_t k = count; k < TokenWords<S>::lanes; ++k) {
        bounds[2 * k] = bounds[0];
        bounds[2 * k + 1] = bounds[1];
    }
}

// Tokens of one kind, of a pack or less.
template<class S>
struct TokenGroup {
    std::uint16_t tokens[TokenWords<S>::lanes];
    std::uint32_t bounds[2 * TokenWords<S>::lanes];
    std::size_t count = 0;

    // Returns whether it is full.
    bool add(std::uint16_t token, const Tokens<S>& all) {
        tokens[count] = token;
        bounds[2 * count] = all.begin(token);
        bounds[2 * count + 1] = all.end(token);
        return ++count == TokenWords<S>::lanes;
    }
};

// Converts the tokens of the list `left`, which convert() could not; returns the first that no method converts, or
// `count`.
template<class S>
std::size_t convert_left(const char* text, const Tokens<S>& tokens, const std::uint16_t* left, std::size_t left_count,
                         std::size_t count, const NumberRun& run, double* numbers) {
    using Words = TokenWords<S>;
    const auto slowly = [&](std::size_t k) {
        return run.convert(text + tokens.begin(k), text + tokens.end(k), numbers[k]);
    };
    if constexpr (Words::converts_wide) {
        std::size_t converted = count; // before the first that is not
        const auto close = [&](TokenGroup<S>& group, const auto& convert) {
            if (group.count == 0) return;
            fill_pack<S>(group.bounds, group.count);
            double some[Words::lanes];
            const unsigned bad = convert(text, group.bounds, some);
            for (std::size_t k = 0; k < group.count; ++k) {
                if ((bad >> k & 1U) == 0)
                    numbers[group.tokens[k]] = some[k];
                else if (!slowly(group.tokens[k]) && group.tokens[k] < converted)
                    converted = group.tokens[k];
            }
            group.count = 0;
        };
        TokenGroup<S> two_words;
        TokenGroup<S> three_words;
        for (std::size_t i = 0; i < left_count && converted == count; ++i) {
            const std::uint16_t token = left[i];
            const std::uint32_t length = tokens.end(token) - tokens.begin(token);
            // Shorter ones were refused for another reason.
            if (length <= 8 || length > 24 || tokens.end(token) < most_before) {
                if (!slowly(token)) converted = token;
            } else if (length <= 16) {
                if (two_words.add(token, tokens)) close(two_words, Words::convert_wide);
            } else {
                if (three_words.add(token, tokens)) close(three_words, Words::convert_long);
            }
        }
        close(two_words, Words::convert_wide);
        close(three_words, Words::convert_long);
        return converted;
    } else {
        for (std::size_t i = 0; i < left_count; ++i)
            if (!slowly(left[i])) return left[i];
    }
    return count;
}

// Whether half of the lanes or more are set.
template<class S>
bool is_half(unsigned bits) {
    return 2 * static_cast<std::size_t>(__builtin_popcount(bits)) >= TokenWords<S>::lanes;
}

// Converts tokens from token `from` on as long as half of them need two words, or three; fewer are gathered by
// convert_left(). Returns how many: whole packs. `leave` takes those that are left. Inlined it would take registers
// from its caller.
template<class S, class Leave>
[[gnu::noinline]] std::size_t convert_longer(const char* text, const Tokens<S>& tokens, std::size_t from,
                                             std::size_t count, double* numbers, const Leave& leave) {
    using Words = TokenWords<S>;
    std::size_t i = from;
    for (; i + Words::lanes <= count; i += Words::lanes) {
        const std::uint32_t* const bounds = tokens.bounds + 2 * i;
        if (tokens.end(i) < most_before) break;
        if (is_half<S>(Words::wide(bounds)))
            leave(Words::convert_wide(text, bounds, numbers + i), i);
        else if (is_half<S>(Words::wider(bounds)))
            leave(Words::convert_long(text, bounds, numbers + i), i);
        else
            break;
    }
    return i - from;
}

// Converts the first `count` tokens; returns how many could be.
template<class S>
std::size_t convert_tokens(const char* text, Tokens<S>& tokens, std::size_t count, const NumberRun& run,
                           double* numbers) {
    using Words = TokenWords<S>;
    constexpr std::size_t lanes = Words::lanes;
    std::uint16_t left[Tokens<S>::most + lanes];
    std::size_t left_count = 0;
    const auto leave = [&](unsigned bad, std::size_t i) {
        for (; bad != 0; bad &= bad - 1)
            left[left_count++] = static_cast<std::uint16_t>(i + static_cast<unsigned>(__builtin_ctz(bad)));
    };
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        const unsigned bad = Words::convert(text, tokens.bounds + 2 * i, numbers + i);
        leave(bad, i);
        if constexpr (Words::converts_wide)
            if (is_half<S>(bad)) i += convert_longer<S>(text, tokens, i + lanes, count, numbers, leave);
    }
    if (i < count) {
        fill_pack<S>(tokens.bounds + 2 * i, count - i);
        double some[lanes] = {};
        const unsigned bad = Words::convert(text, tokens.bounds + 2 * i, some);
        for (std::size_t k = i; k < count; ++k)
            numbers[k] = some[k - i];
        leave(bad & ((1U << (count - i)) - 1), i);
    }
    return left_count == 0 ? count : convert_left(text, tokens, left, left_count, count, run, numbers);
}

template<class S, Separators separators>
void read_run(NumberRun& run) {
    Tokens<S> tokens;
    bool more = true;
    // Small pieces first: where every second number needs another method, much would be looked at in vain.
    for (unsigned blocks = 2; more && run.taken < run.wanted; blocks = Tokens<S>::blocks) {
        const char* const text = run.at;
        const std::size_t wanted = run.wanted - run.taken;
        more = find_tokens<S, separators>(text, run.end, wanted, blocks, tokens);
        const std::size_t found = tokens.ended < wanted ? tokens.ended : wanted;
        double* const numbers = run.numbers + run.taken;
        const std::size_t count = convert_tokens<S>(text, tokens, found, run, numbers);
        if (count == 0) return;
        TokenWords<S>::widen(numbers, count, run.lowest, run.highest);
        run.taken += count;
        run.last = text + tokens.begin(count - 1);
        run.at = text + tokens.end(count - 1);
        if constexpr (separators == Separators::lines) run.at += run.at[0] == '\r' && run.at[1] == '\n' ? 2 : 1;
        more = more && count == found;
    }
}

template<class S>
void read_any(NumberRun& run, Separators separators) {
    if (separators == Separators::lines)
        read_run<S, Separators::lines>(run);
    else
        read_run<S, Separators::any>(run);
}

} // namespace gonio::profile_detail
