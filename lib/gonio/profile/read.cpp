#include <gonio/base/archive.hpp>
#include <gonio/base/archive_xml.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/gldf.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/scanner.hpp>
#include <gonio/profile/text_encoding.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio {

namespace {

using profile_detail::LineScanner;
using profile_detail::Report;
using profile_detail::TextRange;

// A first line that names LM-63, or a line "TILT=…" anywhere: found by its equals sign, which hardly any other line
// has.
bool looks_like_ies(std::string_view bytes, TextRange text) {
    LineScanner lines(bytes, text.begin, text.end);
    while (!lines.at_end()) {
        const std::string_view line = profile_detail::trim_left(lines.next().text);
        if (line.empty()) continue;
        if (starts_with_any_case(line, "IESNA") || starts_with_any_case(line, "IES:")) return true;
        break;
    }
    const std::string_view all = bytes.substr(0, text.end);
    for (std::size_t sign = all.find('=', text.begin); sign != std::string_view::npos; sign = all.find('=', sign + 1)) {
        const std::string_view before = profile_detail::trim_right(all.substr(text.begin, sign - text.begin));
        if (!ends_with_any_case(before, "TILT")) continue;
        const std::string_view indent = profile_detail::trim_right(before.substr(0, before.size() - 4));
        if (indent.empty() || indent.back() == '\n' || indent.back() == '\r') return true;
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
    const std::string_view extension = extension_of(name);
    if (equals_any_case(extension, "IES")) return ProfileFormat::ies;
    if (equals_any_case(extension, "LDT")) return ProfileFormat::ldt;
    if (equals_any_case(extension, "XML") || equals_any_case(extension, "TM33")) return ProfileFormat::tm33;
    return std::nullopt;
}

// XML that names an outermost element of TM-33 near its beginning.
bool looks_like_tm33(std::string_view text) {
    constexpr std::size_t looked_at = 4096;
    while (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text[first] != '<') return false;
    text = text.substr(first, looked_at);
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
        const std::string_view rest = text.substr(at + 1);
        std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
        if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos) name.remove_prefix(colon + 1);
        if (profile_detail::is_tm33_root(name)) return true;
    }
    return false;
}

Result<ProfileFormat> recognise(std::string_view bytes, TextRange text, const std::string& source, Report& report) {
    const std::string_view all = bytes.substr(text.begin, text.end - text.begin);
    if (looks_like_tm33(all)) return ProfileFormat::tm33;
    const bool ies = looks_like_ies(bytes, text);
    const bool ldt = looks_like_ldt(bytes, text);
    if (ies != ldt) return ies ? ProfileFormat::ies : ProfileFormat::ldt;
    if (const std::optional<ProfileFormat> named = format_of_name(source)) return *named;
    if (ies) return ProfileFormat::ies;
    return report.fail("PRF0103", text.begin, "neither IES, EULUMDAT nor TM-33",
                       "name the format if the file is one of them");
}

// One of the photometric files of a GLDF; the factors of TILT are read from the archive, too.
Result<Profile> read_gldf_profile(std::string_view bytes, const std::string& source, const ReadOptions& options) {
    Result<Archive> archive = Archive::open(bytes, source);
    if (!archive) return pass_on(archive);
    Result<GldfProfile> chosen = gldf_profile(*archive, options.choice, options.strict);
    if (!chosen) return pass_on(chosen);
    if (is_archive(chosen->bytes))
        return archive_error("GLD0101", {chosen->name, 0, 0}, "the photometric file is an archive itself");
    ReadOptions inside = options;
    inside.read_beside = reader_in(*archive, chosen->name.substr(source.size() + 1));
    Result<Profile> profile = read_profile(chosen->bytes, chosen->name, inside);
    if (!profile) return profile;
    profile->diagnostics.insert(profile->diagnostics.begin(), chosen->diagnostics.begin(), chosen->diagnostics.end());
    return profile;
}

} // namespace

const char* to_text(ProfileFormat format) {
    return format == ProfileFormat::ies ? "IES" : format == ProfileFormat::ldt ? "LDT" : "TM-33";
}

bool begins_as_tm33(std::string_view bytes) {
    const profile_detail::Utf16 utf16 = profile_detail::utf16_of(bytes);
    if (utf16 == profile_detail::Utf16::no) return looks_like_tm33(bytes);
    return looks_like_tm33(utf16_to_utf8(bytes.substr(0, 8192), utf16 == profile_detail::Utf16::big_endian));
}

Result<Profile> read_profile(std::string_view bytes, const std::string& source, const ReadOptions& options) {
    if (is_archive(bytes)) return read_gldf_profile(bytes, source, options);
    if (bytes.size() > limit("profile-bytes").value)
        return fail("FIL0104", fmt::format("larger than {}", to_text(limit("profile-bytes"))), std::string(limits_hint),
                    source);
    std::string converted; // the result of the conversion from UTF-16
    const profile_detail::Utf16 utf16 = profile_detail::utf16_of(bytes);
    if (utf16 != profile_detail::Utf16::no) {
        converted = utf16_to_utf8(bytes, utf16 == profile_detail::Utf16::big_endian);
        bytes = converted;
    }
    // XML is UTF-8 by definition; LM-63 and EULUMDAT keep their bytes unchanged.
    const bool foreign_xml =
        (options.format == ProfileFormat::tm33 || (!options.format && looks_like_tm33(bytes))) && !is_utf8(bytes);
    if (foreign_xml) {
        converted = to_utf8(bytes);
        bytes = converted;
    }
    Report report(bytes, source, options.strict);
    if (foreign_xml) report.add("PRF0108", 0, "the XML is not UTF-8, read as Windows-1252");
    if (utf16 != profile_detail::Utf16::no)
        report.add("PRF0106", 0, "the text is UTF-16", "save it as UTF-8; few programs read this");
    Result<TextRange> text = profile_detail::find_text(bytes, report);
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
        Result<IesFile> file = profile_detail::parse_ies(*text, report, options.read_beside);
        if (!file) return pass_on(file);
        profile.file = std::move(*file);
    } else if (format == ProfileFormat::tm33) {
        Result<Tm33File> file = profile_detail::parse_tm33(*text, report);
        if (!file) return pass_on(file);
        profile.file = std::move(*file);
    } else {
        Result<LdtFile> file = profile_detail::parse_ldt(*text, report);
        if (!file) return pass_on(file);
        profile.file = std::move(*file);
    }
    profile.diagnostics = report.take();
    profile.places = report.places();
    return profile;
}

const Limit& limit_of_profile(std::string_view path) {
    return ends_with_any_case(path, ".gldf") ? limit("archive-bytes") : limit("profile-bytes");
}

Result<Profile> read_profile_file(const std::string& path, const ReadOptions& options) {
    Result<std::string> bytes = read_file(path, limit_of_profile(path));
    if (!bytes) return pass_on(bytes);
    if (options.read_beside) return read_profile(*bytes, path, options);
    ReadOptions with_folder = options;
    with_folder.read_beside = reader_beside(path);
    return read_profile(*bytes, path, with_folder);
}

} // namespace gonio
