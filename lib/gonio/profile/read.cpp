#include <gonio/base/atomic_file.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/scanner.hpp>

#include <algorithm>
#include <utility>

namespace gonio {

namespace {

using profile_detail::Line;
using profile_detail::LineScanner;
using profile_detail::Report;
using profile_detail::TextRange;

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

// Takes marks, Ctrl-Z and NUL padding away from both ends; fails on what is no text.
Result<TextRange> find_text(std::string_view bytes, Report& report) {
    TextRange text{0, bytes.size()};
    if (bytes.starts_with("\xFE\xFF") || bytes.starts_with("\xFF\xFE"))
        return report.fail("PRF0106", 0, "the text is UTF-16", "save it as UTF-8");
    if (bytes.starts_with(utf8_mark)) report.add("PRF0104", 0, "the file begins with a byte order mark");
    while (bytes.substr(text.begin).starts_with(utf8_mark))
        text.begin += utf8_mark.size();
    while (text.end > text.begin && bytes[text.end - 1] == '\0')
        --text.end;
    const bool nothing =
        std::all_of(bytes.begin(), bytes.end(), [](char c) { return profile_detail::is_blank(c) || is_line_end(c); });
    if (nothing) return report.fail("PRF0101", profile_detail::no_place, "the file is empty");
    // Bytes that no text has; Ctrl-Z only counts as an end where what stands before it is text.
    const std::size_t ctrl_z = std::min(bytes.substr(0, text.end).find('\x1A', text.begin), text.end);
    for (std::size_t i = text.begin; i < ctrl_z; ++i) {
        const auto c = static_cast<unsigned char>(bytes[i]);
        if (c >= ' ' || (c >= '\t' && c <= '\r')) continue;
        const bool head = i < 4096;
        if (c == 0 || head)
            return report.fail("PRF0102", i, "not a photometric file, a text has no control bytes such as this");
    }
    if (bytes.starts_with("\x89PNG")) return report.fail("PRF0102", 0, "not a photometric file, but a PNG picture");
    const auto is_data = [](char c) {
        return !profile_detail::is_blank(c) && !is_line_end(c) && c != '\0' && c != '\x1A';
    };
    const auto* const after = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(ctrl_z), bytes.end(), is_data);
    if (text.end == text.begin || ctrl_z == text.begin)
        return report.fail("PRF0102", text.begin, "not a photometric file, there is no text in it");
    if (after != bytes.end())
        report.add("PRF0105", static_cast<std::size_t>(after - bytes.begin()), "data behind Ctrl-Z, the end of text");
    text.end = ctrl_z;
    return text;
}

bool looks_like_ies(std::string_view bytes, TextRange text) {
    LineScanner lines(bytes, text.begin, text.end);
    bool first = true;
    while (!lines.at_end()) {
        const std::string_view line = profile_detail::trim_left(lines.next().text);
        if (line.empty()) continue;
        if (first &&
            (profile_detail::starts_with_any_case(line, "IESNA") || profile_detail::starts_with_any_case(line, "IES:")))
            return true;
        first = false;
        if (!profile_detail::starts_with_any_case(line, "TILT")) continue;
        const std::string_view rest = profile_detail::trim_left(line.substr(4));
        if (!rest.empty() && rest.front() == '=') return true;
    }
    return false;
}

// Lines 2 to 7 of EULUMDAT are numbers: type, symmetry, planes, step, angles, step.
bool looks_like_ldt(std::string_view bytes, TextRange text) {
    LineScanner lines(bytes, text.begin, text.end);
    lines.next();
    for (int i = 2; i <= 7; ++i) {
        if (lines.at_end()) return false;
        std::string line(profile_detail::trim(lines.next().text));
        std::replace(line.begin(), line.end(), ',', '.');
        double value = 0.0;
        bool plain = true;
        if (profile_detail::scan_number(line, value, plain) != profile_detail::Token::number) return false;
    }
    return true;
}

std::optional<ProfileFormat> format_of_name(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos) return std::nullopt;
    const std::string_view extension = std::string_view(name).substr(dot + 1);
    if (profile_detail::equals_any_case(extension, "IES")) return ProfileFormat::ies;
    if (profile_detail::equals_any_case(extension, "LDT")) return ProfileFormat::ldt;
    return std::nullopt;
}

Result<ProfileFormat> recognise(std::string_view bytes, TextRange text, const std::string& source, Report& report) {
    const std::string_view all = bytes.substr(text.begin, text.end - text.begin);
    const std::size_t first = all.find_first_not_of(" \t\r\n");
    if (first != std::string_view::npos && all[first] == '<' && all.find("IESTM33") != std::string_view::npos)
        return report.fail("PRF0107", text.begin + first, "TM-33 is not read yet",
                           "convert the file to IES LM-63 or EULUMDAT", Failure::unsupported);
    const bool ies = looks_like_ies(bytes, text);
    const bool ldt = looks_like_ldt(bytes, text);
    if (ies != ldt) return ies ? ProfileFormat::ies : ProfileFormat::ldt;
    if (const std::optional<ProfileFormat> named = format_of_name(source)) return *named;
    if (ies) return ProfileFormat::ies;
    return report.fail("PRF0103", text.begin, "neither IES nor EULUMDAT",
                       "name the format if the file is of one of them");
}

} // namespace

const char* to_text(ProfileFormat format) {
    return format == ProfileFormat::ies ? "IES" : "LDT";
}

const char* to_text(IesVersion version) {
    switch (version) {
    case IesVersion::lm63_1986:
        return "LM-63-1986";
    case IesVersion::lm63_1991:
        return "LM-63-1991";
    case IesVersion::lm63_1995:
        return "LM-63-1995";
    case IesVersion::lm63_2002:
        return "LM-63-2002";
    case IesVersion::lm63_2019:
        break;
    }
    return "LM-63-2019";
}

Result<Profile> read_profile(std::string_view bytes, const std::string& source, const ReadOptions& options) {
    Report report(bytes, source, options.strict);
    Result<TextRange> text = find_text(bytes, report);
    if (!text) return pass_on(text);
    ProfileFormat format = options.format.value_or(ProfileFormat::ies);
    if (!options.format) {
        Result<ProfileFormat> recognised = recognise(bytes, *text, source, report);
        if (!recognised) return pass_on(recognised);
        format = *recognised;
    }
    Profile profile;
    profile.source = source;
    if (format == ProfileFormat::ies) {
        Result<IesFile> file = profile_detail::parse_ies(*text, report);
        if (!file) return pass_on(file);
        profile.file = std::move(*file);
    } else {
        Result<LdtFile> file = profile_detail::parse_ldt(*text, report);
        if (!file) return pass_on(file);
        profile.file = std::move(*file);
    }
    profile.diagnostics = report.take();
    return profile;
}

Result<Profile> read_profile_file(const std::string& path, const ReadOptions& options) {
    Result<std::string> bytes = read_file(path);
    if (!bytes) return pass_on(bytes);
    return read_profile(*bytes, path, options);
}

} // namespace gonio
