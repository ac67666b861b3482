// The factors of a tilted lamp: TILT=INCLUDE and TILT=<name>.
#include <gonio/base/file.hpp>
#include <gonio/profile/parse.hpp>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

namespace gonio {

namespace profile_detail {

namespace {

constexpr double largest_count = 2147483647.0;

Result<void> header_number(NumberScanner& numbers, double& value, std::size_t end, Report& report) {
    const Token token = numbers.next(value);
    if (token == Token::end)
        return report.fail("IES0114", end, "the text ends before the lamp geometry and the number of tilt angles");
    if (token != Token::number) return not_a_number(numbers, token, report);
    return {};
}

// A name that can only mean a file in the current folder.
bool is_plain_name(std::string_view name) {
    constexpr std::size_t longest = 255;
    return !name.empty() && name.size() <= longest && name != "." && name != ".." &&
           name.find_first_of("/\\:") == std::string_view::npos;
}

} // namespace

Unexpected not_a_number(const NumberScanner& numbers, Token token, Report& report) {
    const std::string shown = quoted(numbers.token());
    if (token == Token::not_finite)
        return report.fail("IES0202", numbers.token_offset(), shown + " is not a finite number up to 1e30");
    const std::string_view text = numbers.token();
    const std::size_t sign = text.find_first_of("+-", 1);
    const bool glued = sign != std::string_view::npos && text[sign - 1] >= '0' && text[sign - 1] <= '9';
    return report.fail("IES0201", numbers.token_offset(), "expected a number, found " + shown,
                       glued ? "if these are two numbers, put a blank between them" : "");
}

Result<IesTilt> parse_tilt(NumberScanner& numbers, std::size_t end, Report& report) {
    IesTilt tilt;
    double geometry = 0.0;
    if (Result<void> read = header_number(numbers, geometry, end, report); !read) return pass_on(read);
    if (geometry != 1.0 && geometry != 2.0 && geometry != 3.0)
        return report.fail("IES0113", numbers.token_offset(),
                           fmt::format("lamp-to-luminaire geometry {}, expected 1, 2 or 3", geometry));
    double announced = 0.0;
    if (Result<void> read = header_number(numbers, announced, end, report); !read) return pass_on(read);
    if (!(announced >= 1.0 && announced <= largest_count) || announced != std::floor(announced))
        return report.fail("IES0114", numbers.token_offset(),
                           fmt::format("{} is not a number of tilt angles", announced));
    tilt.lamp_to_luminaire_geometry = static_cast<int>(geometry);
    const auto count = static_cast<std::size_t>(announced);
    for (std::vector<double>* list : {&tilt.angles_deg, &tilt.factors}) {
        while (list->size() < count) {
            double value = 0.0;
            const Token token = numbers.next(value);
            if (token == Token::end)
                return report.fail("IES0114", end,
                                   fmt::format("{} tilt {} announced, {} found", count,
                                               list == &tilt.factors ? "factors" : "angles", list->size()));
            if (token != Token::number) return not_a_number(numbers, token, report);
            if (list == &tilt.angles_deg && !list->empty() && value <= list->back())
                return report.fail("IES0114", numbers.token_offset(),
                                   fmt::format("tilt angle {} follows {}", value, list->back()));
            list->push_back(value);
        }
    }
    return tilt;
}

Result<IesTilt> read_tilt_beside(std::string_view name, std::size_t offset, const ReadBeside& read_beside,
                                 Report& report) {
    const char* const hint = "write the factors into this file, as TILT=INCLUDE";
    const std::string shown = quoted(name.substr(0, 80));
    if (!is_plain_name(name)) {
        report.add("IES0111", offset, fmt::format("TILT factors in {}: only a file in the same folder is read", shown),
                   hint);
        return IesTilt{};
    }
    if (!read_beside) {
        report.add("IES0111", offset, fmt::format("TILT factors in the file {} are not read", shown), hint);
        return IesTilt{};
    }
    Result<std::string> bytes = read_beside(std::string(name));
    if (!bytes) {
        const Diagnostics& said = bytes.error().diagnostics;
        report.add("IES0111", offset,
                   fmt::format("TILT factors in the file {}: {}", shown,
                               said.empty() ? "it could not be read" : said.back().message),
                   hint);
        return IesTilt{};
    }
    // Named like the profile: a path next to its path.
    const std::size_t folder = report.source().find_last_of('/') + 1; // 0 if there is none
    Report of_tilt(*bytes, report.source().substr(0, folder) + std::string(name), report.strict());
    Result<TextRange> text = find_text(*bytes, of_tilt);
    if (!text) return report.fail_of_other(std::move(text.error().diagnostics));
    // Any file may have this name: do not report the content of one that does not begin like factors.
    NumberScanner head(*bytes, text->begin, text->end);
    double ignored = 0.0;
    const Token first = head.next(ignored);
    const Token second = first == Token::number ? head.next(ignored) : first;
    if (second == Token::not_number || second == Token::not_finite)
        return report.fail_of_other(
            of_tilt.fail("IES0201", head.token_offset(), "not a file of TILT factors").value().diagnostics);
    NumberScanner numbers(*bytes, text->begin, text->end);
    Result<IesTilt> tilt = parse_tilt(numbers, text->end, of_tilt);
    if (!tilt) return report.fail_of_other(std::move(tilt.error().diagnostics));
    if (!numbers.at_end())
        of_tilt.add("IES0214", numbers.token_offset(),
                    fmt::format("{} follows the {} factors announced", quoted(numbers.token()), tilt->factors.size()));
    report.add_of_other(of_tilt.take());
    return tilt;
}

} // namespace profile_detail

namespace {

std::string in_letters(std::string name, char first, char last, int shift) {
    for (char& c : name)
        if (c >= first && c <= last) c = static_cast<char>(c + shift);
    return name;
}

} // namespace

ReadBeside reader_beside(const std::string& path) {
    return [path](const std::string& name) -> Result<std::string> {
        namespace fs = std::filesystem;
        fs::path folder = fs::path(path).parent_path();
        if (folder.empty()) folder = ".";
        std::error_code failed;
        for (const std::string& spelling :
             {name, in_letters(name, 'A', 'Z', 'a' - 'A'), in_letters(name, 'a', 'z', 'A' - 'a')}) {
            const fs::path file = folder / spelling;
            if (!fs::is_regular_file(file, failed)) continue;
            const fs::path real_folder = fs::canonical(folder, failed);
            const fs::path real_file = fs::canonical(file, failed);
            if (failed || real_file.parent_path() != real_folder)
                return fail("FIL0105", "the link leads out of the folder", {}, file.string());
            return read_file(file.string(), limit("tilt-bytes"));
        }
        return fail(Failure::io, "there is no such file in the same folder", {}, (folder / name).string());
    };
}

} // namespace gonio
