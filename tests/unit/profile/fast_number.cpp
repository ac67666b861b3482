// The fast ways to read a number give exactly the double that std::from_chars gives.
#include <gonio/base/charconv.hpp>
#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/scanner.hpp>
#include <gonio/profile/token_kernels.hpp>
#include <gonio/profile/token_scan.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace gonio::profile_detail;

// The number at the start of `text`, followed by enough bytes that are not part of it.
bool read(std::string text, double& value, std::size_t& length) {
    text += " ";
    text.append(static_cast<std::size_t>(decimal_lookahead), '7');
    const char* const behind = read_decimal(text.data(), text.data() + text.size(), value);
    if (behind == nullptr) return false;
    length = static_cast<std::size_t>(behind - text.data());
    return true;
}

void expect_same(const std::string& text) {
    double value = 0.0;
    std::size_t length = 0;
    if (!read(text, value, length)) {
        ADD_FAILURE() << text << " was not taken";
        return;
    }
    double expected = 0.0;
    const auto [end, error] = gonio::from_chars(text.data(), text.data() + text.size(), expected);
    const std::string padded = "99999999 " + text + " " + std::string(static_cast<std::size_t>(decimal_lookahead), '7');
    double converted = 0.0;
    if (!convert_token(padded.data() + 9, padded.data() + 9 + text.size(), converted) ||
        __builtin_bit_cast(std::uint64_t, converted) != __builtin_bit_cast(std::uint64_t, expected))
        ADD_FAILURE() << text << " as a token gave " << converted;
    if (end != text.data() + text.size() || length != text.size() ||
        __builtin_bit_cast(std::uint64_t, value) != __builtin_bit_cast(std::uint64_t, expected))
        ADD_FAILURE() << text << " gave " << value;
}

TEST(FastNumber, TakesWhatFilesWrite) {
    for (const std::string text : {"0",
                                   "1",
                                   "-1",
                                   "0.0",
                                   "-0",
                                   "-0.5",
                                   ".5",
                                   "5.",
                                   "12345678",
                                   "1234567.",
                                   "123456.7",
                                   "0.123456",
                                   "0.1234567",
                                   "00012.500",
                                   "9999999",
                                   "99999999",
                                   "9007199254740992",
                                   "9007199254740993",
                                   "9007199254740991",
                                   "0.30000000000000004",
                                   "123456789012345678",
                                   "1234567890123456789",
                                   "9999999999999999999",
                                   "0.1",
                                   "100000.25",
                                   "0.0000000000000000001",
                                   "0.9999999999999999999",
                                   "1.7976931348623157",
                                   "4503599627370496.5",
                                   "4503599627370497.5",
                                   "9007199254740992.5",
                                   "9007199254740993.5",
                                   "18014398509481985",
                                   "2.5",
                                   "0.000",
                                   "-.5"})
        expect_same(text);
}

TEST(FastNumber, LeavesTheRestAlone) {
    for (const std::string text :
         {"", "-", ".", "-.", "+1", "--1", "1e5", "1E5", "1.5e-3", "1.2.3", "1-2", "0x10", "inf", "nan", "1;",
          "12345678901234567890", "1.23456789012345678901", "12_3", "1.5d0"}) {
        double value = 42.0;
        std::size_t length = 0;
        EXPECT_FALSE(read(text, value, length)) << text;
        const std::string padded =
            "99999999 " + text + " " + std::string(static_cast<std::size_t>(decimal_lookahead), '7');
        const bool classified = text.find_first_not_of("-./0123456789") == std::string::npos && !text.empty();
        EXPECT_FALSE(classified && convert_token(padded.data() + 9, padded.data() + 9 + text.size(), value)) << text;
        EXPECT_EQ(value, 42.0) << text;
    }
}

TEST(FastNumber, EveryByteBehindANumberEndsItOrNot) {
    for (int c = 0; c < 256; ++c)
        for (const std::string digits :
             {"7", "1234567", "12345678", "1.5", "123456.7", "1234567.8", "0.12345678901234567"}) {
            const char byte = static_cast<char>(c);
            const std::string text = digits + byte + std::string(static_cast<std::size_t>(decimal_lookahead), '\n');
            double value = 0.0;
            const char* const behind = read_decimal(text.data(), text.data() + text.size(), value);
            const bool more = (c >= '0' && c <= '9') || (c == '.' && digits.find('.') == std::string::npos);
            if (!more) {
                EXPECT_EQ(behind == text.data() + digits.size(), ends_number(byte)) << digits << " " << c;
            }
        }
}

// Every byte in every position of a word that otherwise has only digits.
TEST(FastNumber, AStrangeByteInATokenIsNeverADigit) {
    for (int c = 0; c < 256; ++c)
        for (std::size_t length = 1; length <= 8; ++length)
            for (std::size_t at = 0; at < length; ++at) {
                std::string text(length, '5');
                text[at] = static_cast<char>(c);
                const std::string padded = "1234567 " + text + std::string(40, ' ');
                double value = 0.0;
                if (c < '-' || c > '9') continue; // excluded by the character classes
                const bool taken = convert_token(padded.data() + 8, padded.data() + 8 + length, value);
                double expected = 0.0;
                bool plain = true;
                const bool number = scan_number(text, expected, plain) == Token::number && plain && text[0] != '+';
                EXPECT_EQ(taken, number) << text;
                if (number) {
                    EXPECT_EQ(value, expected) << text;
                }
            }
}

// What the kernels of `set` take from `text` behind its first eight bytes.
NumberRun taken_by(gonio::simd::InstructionSet set, const std::string& text, Separators separators,
                   std::vector<double>& numbers) {
    NumberRun run;
    run.at = text.data() + 8;
    run.end = text.data() + text.size();
    run.numbers = numbers.data();
    run.wanted = numbers.size();
    run.convert = convert_token;
    token_kernels(set).read(run, separators);
    return run;
}

TEST(TokenKernels, StopAtAnyByteThatIsNeitherOfANumberNorASeparator) {
    const auto is_numeric = [](char c) { return c >= '-' && c <= '9'; };
    for (const gonio::simd::InstructionSet set : gonio::simd::available_sets())
        for (int c = 0; c < 256; ++c)
            for (std::size_t at = 0; at < 64; ++at) {
                std::string text(8, ' ');
                while (text.size() < 400)
                    text += "12 ";
                text[8 + at] = static_cast<char>(c);
                std::vector<double> numbers(64);
                const NumberRun run = taken_by(set, text, Separators::any, numbers);
                const bool known = is_numeric(text[8 + at]) || ends_number(text[8 + at]);
                // A byte of numbers may make one that is left, too.
                if (!known) {
                    ASSERT_EQ(run.taken, at / 3) << c << " " << at;
                } else if (c >= '0' || ends_number(text[8 + at])) {
                    ASSERT_EQ(run.taken, numbers.size()) << c << " " << at;
                }
            }
}

TEST(TokenKernels, TakeNumbersOfAnyLengthBetweenAnySeparators) {
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        std::string text(8, '\n');
        std::vector<std::pair<std::size_t, std::size_t>> expected;
        while (text.size() < 3000) {
            const std::size_t begin = text.size();
            text.append(1 + random() % (i % 7 == 0 ? 19 : 9), '1');
            expected.emplace_back(begin, text.size());
            for (std::size_t k = 0; k <= random() % (i % 5 == 0 ? 90 : 3); ++k)
                text += " ,\t\r\n"[random() % 5];
        }
        // A byte of another kind ends the run, and the number before it is left.
        const std::size_t stop = i % 3 == 0 ? 8 + random() % (text.size() - 8) : text.size();
        if (stop < text.size()) text[stop] = 'E';
        std::size_t whole = 0;
        while (whole < expected.size() && expected[whole].second < std::min(stop, text.size() - 8))
            ++whole;
        for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
            std::vector<double> numbers(expected.size());
            const NumberRun run = taken_by(set, text, Separators::any, numbers);
            ASSERT_LE(run.taken, whole) << i;
            for (std::size_t k = 0; k < run.taken; ++k) {
                const std::string one = text.substr(expected[k].first, expected[k].second - expected[k].first);
                ASSERT_EQ(numbers[k], std::strtod(one.c_str(), nullptr)) << one;
            }
            if (run.taken > 0) {
                EXPECT_EQ(static_cast<std::size_t>(run.last - text.data()), expected[run.taken - 1].first);
                EXPECT_EQ(static_cast<std::size_t>(run.at - text.data()), expected[run.taken - 1].second);
            }
            // Nothing but the end of the text, the strange byte and a long run of separators stops it.
            const std::size_t next = run.taken < expected.size() ? expected[run.taken].second : text.size();
            if (i % 5 != 0) {
                EXPECT_GE(next + 64 + static_cast<std::size_t>(decimal_lookahead), std::min(stop, text.size())) << i;
            }
        }
    }
}

// Numbers with every count of digits, the point at every place, with and without a sign, and what is not a number.
TEST(TokenKernels, GiveTheNearestDoubleForEveryShape) {
    std::mt19937_64 random(11);
    std::vector<std::string> shapes;
    for (std::size_t length = 1; length <= 25; ++length)
        for (std::size_t point = 0; point <= length; ++point)
            for (const bool negative : {false, true})
                for (int i = 0; i < 4; ++i) {
                    std::string text;
                    for (std::size_t k = 0; k < length; ++k)
                        text += i == 0 ? '9' : static_cast<char>('0' + random() % 10);
                    if (point < length) text.insert(point, ".");
                    if (i == 3 && point == 0) text += '.';
                    shapes.push_back((negative ? "-" : "") + text);
                }
    for (const char* const odd : {"-",
                                  ".",
                                  "-.",
                                  "1-2",
                                  "1/2",
                                  "--1",
                                  "1.2.3",
                                  "123456.78.9",
                                  "12345678-9",
                                  "1234567/9",
                                  "-12345678-",
                                  ".123456789.",
                                  "9007199254740993",
                                  "4503599627370497",
                                  "1234.5678901.2345678",
                                  "12345678.1234567.1",
                                  "-1234567890.1-",
                                  "1234-5678901",
                                  "12345.678901234567.89",
                                  "12345678901234567/8",
                                  "123456/8901234567890",
                                  "--12345678901234567.5",
                                  "-123456789012-45678901",
                                  "123456789012345-7890",
                                  "0.0000012345678901234567",
                                  "-.0000000000000000000000",
                                  "00000000000000000000.125"})
        shapes.emplace_back(odd);
    // After few short numbers, and after many that need two words and so are taken in packs of such.
    for (const auto& [before, word] : {std::pair<std::size_t, std::string>{5, "17.5 "}, {20, "17.500000000 "}})
        for (const std::string& shape : shapes) {
            std::string text = "IESNA91\n";
            for (std::size_t i = 0; i < before; ++i)
                text += word;
            text += shape + " ";
            for (std::size_t i = 0; i < 12; ++i)
                text += word;
            text += std::string(200, ' ');
            double expected = 0.0;
            bool plain = true;
            const bool number = scan_number(shape, expected, plain) == Token::number;
            const std::size_t all = before + 13;
            for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
                std::vector<double> numbers(all);
                const NumberRun run = taken_by(set, text, Separators::any, numbers);
                ASSERT_TRUE(run.taken == all ? number : run.taken == before) << shape;
                // Up to 19 digits are not left to others.
                if (number && shape.size() <= 19) {
                    ASSERT_EQ(run.taken, all) << shape;
                }
                if (run.taken < all) continue;
                EXPECT_EQ(__builtin_bit_cast(std::uint64_t, numbers[before]),
                          __builtin_bit_cast(std::uint64_t, expected))
                    << shape << " " << gonio::simd::to_text(set);
                numbers[before] = 17.5;
                EXPECT_EQ(numbers, std::vector<double>(all, 17.5)) << shape;
                EXPECT_EQ(run.lowest, std::min(0.0, expected)) << shape;
                EXPECT_EQ(run.highest, std::max(17.5, expected)) << shape;
            }
        }
}

// Packs of numbers of three words. Ties between two doubles and their neighbours are among them, which need more digits
// than a quotient of doubles has, and leading zeros, which leave fewer than its first double has.
TEST(TokenKernels, GiveTheNearestDoubleForLongNumbers) {
    std::mt19937_64 random(17);
    for (int i = 0; i < 4000; ++i) {
        std::vector<std::string> expected;
        std::string text = "IESNA91\n";
        while (expected.size() < 40) {
            const std::uint64_t mantissa = (std::uint64_t{1} << 53U) + (random() >> 11U);
            const std::uint64_t shift = random() % 8;
            const std::uint64_t middle = (mantissa << (shift + 1) | std::uint64_t{1} << shift) + random() % 3 - 1;
            std::string number = std::to_string(i % 2 == 0 ? middle : random() % 10'000'000'000'000'000'000U);
            number.insert(random() % (number.size() + 1), ".");
            if (random() % 4 == 0) number.insert(0, std::string(random() % 5, '0'));
            if (random() % 4 == 0) number.insert(0, "-");
            text += number + ' ';
            expected.push_back(number);
        }
        text += std::string(200, ' ');
        for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
            std::vector<double> numbers(expected.size());
            const NumberRun run = taken_by(set, text, Separators::any, numbers);
            for (std::size_t k = 0; k < run.taken; ++k)
                ASSERT_EQ(numbers[k], std::strtod(expected[k].c_str(), nullptr))
                    << expected[k] << ' ' << gonio::simd::to_text(set);
            ASSERT_TRUE(run.taken == expected.size() || expected[run.taken].size() > 20) << expected[run.taken];
        }
    }
}

TEST(TokenKernels, TakeLinesOfOneNumberEachAndNoOthers) {
    std::mt19937 random(7);
    const char* const ends[] = {"\r\n", "\n", "\r"};
    const char* const odd[] = {"\n\n", " \n", "\n ", ",5\n", "\r\r", "\n\r", " 7\n", "E\n"};
    for (int i = 0; i < 3000; ++i) {
        std::string text = "company\n";
        std::vector<std::size_t> lines;
        const std::size_t strange = 1 + random() % 200;
        while (text.size() < 3000) {
            lines.push_back(text.size());
            text += std::to_string(random() % 10000) + (random() % 2 != 0 ? ".25" : "");
            text += lines.size() == strange ? odd[random() % std::size(odd)]
                                            : ends[i % 4 == 3 ? random() % 3 : static_cast<std::size_t>(i % 4)];
        }
        for (const gonio::simd::InstructionSet set : gonio::simd::available_sets()) {
            std::vector<double> numbers(lines.size());
            const NumberRun run = taken_by(set, text, Separators::lines, numbers);
            ASSERT_LE(run.taken, strange) << i;
            for (std::size_t k = 0; k < run.taken; ++k)
                ASSERT_EQ(numbers[k], std::strtod(text.c_str() + lines[k], nullptr)) << i;
            if (run.taken < strange && run.taken > 0) {
                EXPECT_EQ(static_cast<std::size_t>(run.at - text.data()), lines[run.taken]) << i;
            }
            EXPECT_GE(run.taken + 1, strange) << i << " " << strange;
        }
    }
}

TEST(TokenScan, QuickAndSlowReadingAgreeOnAnyTable) {
    std::mt19937_64 random(5);
    for (int run = 0; run < 300; ++run) {
        std::string text = "TILT=NONE\r\n";
        const std::size_t begin = text.size();
        for (int i = 0; i < 700; ++i) {
            static constexpr const char* odd[] = {
                "1e3", "-2.5E-1", "+4", "12345678901234567890.5", "-0.0", "0.12345678901234567"};
            if (random() % 50 == 0)
                text += odd[random() % std::size(odd)];
            else
                text += std::to_string(random() % 100000) +
                        (random() % 2 != 0 ? "." + std::to_string(random() % 1000) : "");
            text += random() % 20 == 0 ? "\r\n" : random() % 10 == 0 ? " , " : " ";
        }
        std::vector<double> slow;
        NumberScanner one_by_one(text, begin, text.size());
        for (double value = 0.0; one_by_one.next(value) == Token::number;)
            slow.push_back(value);
        std::vector<double> quick(slow.size());
        std::size_t count = 0;
        NumberScanner scanner(text, begin, text.size());
        double lowest = 0.0;
        double highest = 0.0;
        while (count < quick.size()) {
            count += scanner.next_quickly(std::span(quick).subspan(count), lowest, highest);
            if (count == quick.size()) break;
            ASSERT_EQ(scanner.next(quick[count]), Token::number);
            lowest = std::min(lowest, quick[count]);
            highest = std::max(highest, quick[count]);
            ++count;
        }
        ASSERT_EQ(slow.size(), 700U);
        EXPECT_EQ(quick, slow);
        EXPECT_EQ(lowest, std::min(0.0, *std::min_element(slow.begin(), slow.end())));
        EXPECT_EQ(highest, *std::max_element(slow.begin(), slow.end()));
        EXPECT_TRUE(scanner.at_end());
    }
}

// Blocks of exactly the size of the text, so that AddressSanitizer detects a read of the first byte after it.
TEST(FastNumber, NeverReadsBehindTheEnd) {
    for (std::size_t size = 1; size < 80; ++size)
        for (std::size_t point = 0; point <= size; ++point)
            for (const bool negative : {false, true})
                for (const char last : {'1', '\n'}) {
                    const std::unique_ptr<char[]> text(new char[size]);
                    std::fill_n(text.get(), size, '1');
                    text[size - 1] = last;
                    if (point < size) text[point] = '.';
                    if (negative) text[0] = '-';
                    const char* const end = text.get() + size;
                    double value = 0.0;
                    // The reader may decline (nullptr); otherwise it returns the value and the length of the standard
                    // library.
                    if (const char* const behind = read_decimal(text.get(), end, value)) {
                        double expected = 0.0;
                        ASSERT_EQ(behind, gonio::from_chars(text.get(), end, expected).ptr);
                        ASSERT_EQ(value, expected);
                    }
                    NumberScanner scanner({text.get(), size}, 0, size);
                    static_cast<void>(scanner.next(value));
                    ASSERT_NE(scanner.next(value), Token::number) << std::string_view(text.get(), size);
                }
}

TEST(FastNumber, MillionsOfNumbersAsFromChars) {
    std::mt19937_64 random(7);
    const auto digits = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += static_cast<char>('0' + random() % 10);
        return text;
    };
    for (int i = 0; i < 2'000'000; ++i) {
        // At most 19 significant digits, with the point anywhere or absent.
        const int count = 1 + static_cast<int>(random() % 19);
        std::string text = digits(count);
        if (random() % 4 != 0) text.insert(random() % (text.size() + 1), ".");
        if (random() % 8 == 0) text.insert(0, "-");
        expect_same(text);
        if (HasFailure()) return;
    }
}

// Halfway between two doubles, and next to it: where wrong rounding shows.
TEST(FastNumber, TiesAndTheirNeighbours) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 300'000; ++i) {
        const std::uint64_t mantissa = (std::uint64_t{1} << 53U) + (random() >> 11U);
        const unsigned shift = static_cast<unsigned>(random() % 10);
        const std::uint64_t middle = (mantissa << (shift + 1)) | (std::uint64_t{1} << shift); // 54 + shift bits + 1
        for (const std::int64_t off : {-1, 0, 1}) {
            std::string text = std::to_string(middle + static_cast<std::uint64_t>(off));
            if (text.size() <= 19) expect_same(text);
            if (text.size() < 19) expect_same(text.insert(text.size() - random() % text.size(), "."));
        }
        if (HasFailure()) return;
    }
}

TEST(FastNumber, ShortestTextOfRandomDoublesReadsBack) {
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> candela(0.0, 1e5);
    for (int i = 0; i < 500'000; ++i) {
        const double number = candela(random) * (i % 3 == 0 ? 1e-4 : 1.0);
        std::array<char, 40> buffer{};
        const auto [end, error] =
            gonio::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::fixed);
        const std::string text(buffer.data(), end);
        double value = 0.0;
        NumberScanner scanner(text, 0, text.size());
        ASSERT_EQ(scanner.next(value), Token::number);
        ASSERT_EQ(value, number) << text;
    }
}

} // namespace
