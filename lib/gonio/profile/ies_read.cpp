// LM-63, all editions from 1986 to 2019: a version line, keyword lines, TILT, and then numbers in a free layout.
#include <gonio/base/text.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/scanner.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace gonio::profile_detail {

namespace {

constexpr double largest_count = 2147483647.0;

std::string capitals(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (!is_blank(c)) result += to_upper(c);
    return result;
}

std::optional<IesVersion> version_of_year(std::string_view two_digits) {
    if (two_digits == "86") return IesVersion::lm63_1986;
    if (two_digits == "91") return IesVersion::lm63_1991;
    if (two_digits == "94" || two_digits == "95") return IesVersion::lm63_1995; // 94: drafts of 1995
    if (two_digits == "02") return IesVersion::lm63_2002;
    if (two_digits == "19") return IesVersion::lm63_2019;
    return std::nullopt;
}

// The year at the end of "IESNA:LM-63-2002", "IESNA91", "iesna: lm-63-95", or anywhere in a longer line.
std::optional<IesVersion> version_in(std::string_view line) {
    const std::string text = capitals(line);
    for (const std::string_view year : {"1986", "1991", "1995", "2002", "2019"})
        if (text.find(year) != std::string::npos) return version_of_year(year.substr(2));
    if (text.size() < 2) return std::nullopt;
    return version_of_year(std::string_view(text).substr(text.size() - 2));
}

bool is_standard_spelling(std::string_view line) {
    return line == "IESNA91" || line == "IESNA:LM-63-1995" || line == "IESNA:LM-63-2002" || line == "IES:LM-63-2019";
}

bool is_version_line(std::string_view line) {
    const std::string_view text = trim_left(line);
    return starts_with_any_case(text, "IESNA") || starts_with_any_case(text, "IES:");
}

// "TILT=NONE", " tilt = NONE": the text after the equals sign.
std::optional<std::string_view> tilt_of(std::string_view line) {
    std::string_view text = trim_left(line);
    if (!starts_with_any_case(text, "TILT")) return std::nullopt;
    text = trim_left(text.substr(4));
    if (text.empty() || text.front() != '=') return std::nullopt;
    return text.substr(1);
}

std::size_t longest_line(IesVersion version) { // characters, CR LF included
    if (version == IesVersion::lm63_2019) return std::string_view::npos;
    return version == IesVersion::lm63_2002 ? 256 : 132;
}

class IesParser {
public:
    IesParser(TextRange text, Report& report, const ReadBeside& read_beside)
        : report_(report),
          read_beside_(read_beside),
          lines_(report.bytes(), text.begin, text.end),
          numbers_(report.bytes(), 0, 0),
          text_(text) {}

    Result<IesFile> parse() {
        read_version();
        if (Result<void> read = read_keywords(); !read) return pass_on(read);
        check_keywords();
        check_line_lengths();
        numbers_ = NumberScanner(report_.bytes(), lines_.offset(), text_.end);
        if (file_.tilt_keyword == "INCLUDE") {
            Result<IesTilt> tilt = parse_tilt(numbers_, text_.end, report_);
            if (!tilt) return pass_on(tilt);
            file_.tilt = std::move(*tilt);
        }
        if (Result<void> read = read_header(); !read) return pass_on(read);
        if (Result<void> read = read_angles(); !read) return pass_on(read);
        if (Result<void> read = read_candela(); !read) return pass_on(read);
        check_ies(file_, places_, report_);
        mark_table(places_, report_);
        if (report_.has_error()) return report_.failure();
        return std::move(file_);
    }

private:
    void read_version() {
        LineScanner ahead = lines_;
        while (!ahead.at_end()) {
            const std::size_t before = ahead.offset();
            const Line line = ahead.next();
            if (trim(line.text).empty()) continue;
            if (!is_version_line(line.text)) break;
            set_version(line, before != text_.begin);
            lines_ = ahead;
            return;
        }
        file_.version = IesVersion::lm63_1986;
        report_.add("IES0103", text_.begin, "no version line, read as LM-63-1986",
                    "begin the file with IESNA:LM-63-2002 if it is of that version");
    }

    void set_version(const Line& line, bool behind_blank_lines) {
        file_.version_line = line.text;
        const std::optional<IesVersion> version = version_in(line.text);
        file_.version = version.value_or(IesVersion::lm63_2002);
        version_known_ = version.has_value();
        if (!version)
            report_.add("IES0102", line.offset, "the first line does not name a version of LM-63, read as LM-63-2002");
        else if (!is_standard_spelling(line.text) || behind_blank_lines)
            report_.add("IES0101", line.offset,
                        fmt::format("unusual version line, read as {}", to_text(file_.version)));
    }

    Result<void> read_keywords() {
        while (!lines_.at_end()) {
            const Line line = lines_.next();
            if (const std::optional<std::string_view> tilt = tilt_of(line.text)) return read_tilt_line(line, *tilt);
            read_keyword(line);
        }
        return report_.fail("IES0108", text_.end, "the text ends without a line TILT=NONE or TILT=INCLUDE");
    }

    void read_keyword(const Line& line) {
        const std::string_view text = trim_left(line.text);
        const std::size_t offset = line.offset + (line.text.size() - text.size());
        const std::size_t close = text.find(']');
        if (text.empty() || text.front() != '[' || close == std::string_view::npos || close == 1) {
            if (file_.version != IesVersion::lm63_1986)
                report_.add("IES0104", offset, "a line before TILT= that does not begin with a [KEYWORD]");
            file_.keywords.push_back({"", std::string(text)});
            return;
        }
        const std::string_view name = text.substr(1, close - 1);
        const std::string_view value = trim_left(text.substr(close + 1));
        if (!equals_any_case(name, "MORE")) {
            if (equals_any_case(name, "_CCT")) report_.mark(ProfileField::color_temperature, offset);
            if (equals_any_case(name, "_CRI")) report_.mark(ProfileField::color_rendering, offset);
            file_.keywords.push_back({std::string(name), std::string(value)});
        } else if (file_.keywords.empty()) {
            report_.add("IES0105", offset, "[MORE] comes before any keyword");
            file_.keywords.push_back({std::string(name), std::string(value)});
        } else {
            std::string& continued = file_.keywords.back().text;
            continued += '\n';
            continued += value;
        }
    }

    Result<void> read_tilt_line(const Line& line, std::string_view written) {
        const std::string_view value = trim(written);
        const std::size_t sign = line.text.size() - written.size();
        const bool none = equals_any_case(value, "NONE");
        const bool include = equals_any_case(value, "INCLUDE");
        if (sign != 5 || (!written.empty() && is_blank(written.front())))
            report_.add("IES0109", line.offset, "blanks before, within or after TILT=");
        if (trim_left(line.text).substr(0, 4) != "TILT" || (none && value != "NONE") || (include && value != "INCLUDE"))
            report_.add("IES0110", line.offset, "the TILT line is not in capitals");
        if (none || include) {
            file_.tilt_keyword = none ? "NONE" : "INCLUDE";
            return {};
        }
        const std::size_t offset = line.offset + sign + (written.size() - trim_left(written).size());
        if (value.empty()) return report_.fail("IES0108", offset, "nothing follows TILT=", "write TILT=NONE");
        if (file_.version == IesVersion::lm63_2019)
            report_.add("IES0112", offset, "LM-63-2019 does not allow TILT factors in another file",
                        "write the factors into this file, as TILT=INCLUDE");
        file_.tilt_keyword = value;
        Result<IesTilt> tilt = read_tilt_beside(value, offset, read_beside_, report_);
        if (!tilt) return pass_on(tilt);
        file_.tilt = std::move(*tilt);
        return {};
    }

    void check_keywords() {
        if (!version_known_) return; // what an edition requires holds for files that name it
        if (file_.version != IesVersion::lm63_2002 && file_.version != IesVersion::lm63_2019) return;
        if (report_.strict()) check_keyword_names();
        std::string missing;
        for (const std::string_view name : {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"}) {
            const bool found = std::any_of(file_.keywords.begin(), file_.keywords.end(),
                                           [&](const IesKeyword& k) { return equals_any_case(k.name, name); });
            if (!found) missing += fmt::format("{}[{}]", missing.empty() ? "" : ", ", name);
        }
        if (!missing.empty())
            report_.add("IES0106", text_.begin, fmt::format("required by {}: {}", to_text(file_.version), missing));
    }

    // From 2002 on, names that the standard does not define begin with an underscore.
    void check_keyword_names() {
        static constexpr std::array<std::string_view, 20> defined{
            "TEST",          "TESTLAB",      "TESTDATE",   "ISSUEDATE", "MANUFAC",  "LUMCAT",       "LUMINAIRE",
            "LAMPCAT",       "LAMP",         "BALLASTCAT", "BALLAST",   "MAINTCAT", "DISTRIBUTION", "FLASHAREA",
            "COLORCONSTANT", "LAMPPOSITION", "NEARFIELD",  "OTHER",     "SEARCH",   "FILEGENINFO"};
        std::string unknown;
        for (const IesKeyword& keyword : file_.keywords) {
            const bool known = std::any_of(defined.begin(), defined.end(),
                                           [&](std::string_view name) { return equals_any_case(keyword.name, name); });
            if (!known && !keyword.name.empty() && keyword.name.front() != '_')
                unknown += fmt::format("{}[{}]", unknown.empty() ? "" : ", ", keyword.name);
        }
        if (!unknown.empty())
            report_.add("IES0115", text_.begin,
                        fmt::format("not defined in {}: {}", to_text(file_.version), quoted(unknown.substr(0, 80))));
    }

    void check_line_lengths() {
        if (!report_.strict()) return;
        const std::size_t longest = longest_line(file_.version);
        LineScanner lines(report_.bytes(), text_.begin, text_.end);
        while (!lines.at_end()) {
            const Line line = lines.next();
            if (line.text.size() + 2 > longest)
                report_.add("IES0107", line.offset + longest - 2,
                            fmt::format("a line of {} characters; {} allows {}", line.text.size() + 2,
                                        to_text(file_.version), longest));
        }
    }

    Unexpected bad_token(Token token) { return not_a_number(numbers_, token, report_); }

    static constexpr std::array<std::string_view, 13> header_numbers{"the number of lamps",
                                                                     "the lumens per lamp",
                                                                     "the candela multiplier",
                                                                     "the number of vertical angles",
                                                                     "the number of horizontal angles",
                                                                     "the photometric type",
                                                                     "the unit of length",
                                                                     "the width",
                                                                     "the length",
                                                                     "the height",
                                                                     "the ballast factor",
                                                                     "field 12",
                                                                     "the input watts"};

    std::string header_cut_off(std::size_t found) const {
        const bool include = file_.tilt_keyword == "INCLUDE";
        return fmt::format("13 numbers must follow {}, but {} found",
                           include ? std::string("the TILT table") : "TILT=" + file_.tilt_keyword,
                           found == 1 ? std::string("1 is") : fmt::format("{} are", found));
    }

    // In the order of the standard.
    Result<void> read_header() {
        std::array<double, header_numbers.size()> value{};
        std::array<std::size_t, header_numbers.size()> place{};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const Token token = numbers_.next(value[i]);
            if (token == Token::end)
                return report_.fail("IES0207", text_.end, header_cut_off(i),
                                    fmt::format("the file is cut off; next would be {}", header_numbers[i]));
            if (token != Token::number) return bad_token(token);
            place[i] = numbers_.token_offset();
            if (i == 10) ballast_begins_line_ = numbers_.token_begins_line();
            const bool whole_expected = i == 0 || (i >= 3 && i <= 6);
            if (whole_expected && file_.version != IesVersion::lm63_1986 &&
                numbers_.token().find('.') != std::string_view::npos)
                report_.add("IES0217", place[i], fmt::format("{} instead of a whole number", quoted(numbers_.token())),
                            "write it without a point");
        }
        const auto whole = [&](std::size_t i, double lowest, std::string_view what) -> Result<void> {
            if (value[i] == std::floor(value[i]) && value[i] >= lowest && value[i] <= largest_count) return {};
            return report_.fail("IES0203", place[i], fmt::format("{} is not a {}", value[i], what));
        };
        if (Result<void> ok = whole(0, -largest_count, "number of lamps"); !ok) return ok;
        if (Result<void> ok = whole(3, 1.0, "number of vertical angles"); !ok) return ok;
        if (Result<void> ok = whole(4, 1.0, "number of horizontal angles"); !ok) return ok;
        if (value[5] != 1.0 && value[5] != 2.0 && value[5] != 3.0)
            return report_.fail("IES0208", place[5], fmt::format("photometric type {}, expected 1, 2 or 3", value[5]));
        if (value[6] != 1.0 && value[6] != 2.0)
            return report_.fail("IES0209", place[6], fmt::format("unit {}, expected 1 (feet) or 2 (metres)", value[6]));
        if (value[2] <= 0.0)
            return report_.fail("IES0211", place[2], fmt::format("candela multiplier {}", value[2]),
                                "it is a factor greater than 0, and 1 if there is none");
        file_.lamp_count = static_cast<int>(value[0]);
        file_.lumens_per_lamp = value[1];
        file_.candela_multiplier = value[2];
        vertical_count_ = static_cast<std::size_t>(value[3]);
        horizontal_count_ = static_cast<std::size_t>(value[4]);
        constexpr std::array photometries{Photometry::c, Photometry::b, Photometry::a};
        file_.photometry = photometries[static_cast<std::size_t>(value[5]) - 1];
        file_.feet = value[6] == 1.0;
        file_.width = value[7];
        file_.length = value[8];
        file_.height = value[9];
        file_.ballast_factor = value[10];
        file_.field_12 = value[11];
        file_.input_watts = value[12];
        places_.header = place[0];
        places_.shape = place[7];
        ballast_place_ = place[10];
        report_.mark(ProfileField::lamp_flux, place[1]);
        report_.mark(ProfileField::opening, place[7]);
        report_.mark(ProfileField::multiplier, place[2]);
        report_.mark(ProfileField::ballast_factor, place[10]);
        report_.mark(ProfileField::field_12, place[11]);
        report_.mark(ProfileField::input_watts, place[12]);
        check_header(value, place);
        return {};
    }

    void check_header(const std::array<double, 13>& value, const std::array<std::size_t, 13>& place) {
        if (value[0] < 1.0) report_.add("IES0215", place[0], fmt::format("{} lamps", value[0]), "write at least 1");
        if (value[1] <= 0.0 && value[1] != -1.0)
            report_.add("IES0210", place[1], fmt::format("{} lumens per lamp, read as absolute photometry", value[1]),
                        "write -1 for absolute photometry");
        if (value[10] <= 0.0)
            report_.add("IES0212", place[10], fmt::format("ballast factor {}", value[10]), "it is a factor near 1");
        if (value[12] < 0.0)
            report_.add("IES0218", place[12], fmt::format("{} input watts", value[12]),
                        "write 0 if they are not known");
        const double x = value[11];
        const bool factor = file_.version == IesVersion::lm63_1986 || file_.version == IesVersion::lm63_1991;
        const bool generation_type = file_.version == IesVersion::lm63_2019 && x >= 1.0 && x < 1.2;
        if (factor ? x <= 0.0 : x != 1.0 && !generation_type)
            report_.add("IES0213", place[11], fmt::format("field 12 is {} in {}", x, to_text(file_.version)),
                        factor ? "it is a factor greater than 0" : "write 1");
    }

    Result<void> read_angles() {
        std::size_t last = 0;
        places_.vertical = numbers_.at_end() ? text_.end : numbers_.token_offset();
        if (Result<void> read = read_angle_list(file_.vertical_deg, vertical_count_, true, last); !read) return read;
        places_.last_vertical = last;
        places_.horizontal = numbers_.at_end() ? text_.end : numbers_.token_offset();
        horizontal_begins_line_ = numbers_.token_begins_line();
        if (Result<void> read = read_angle_list(file_.horizontal_deg, horizontal_count_, false, last); !read)
            return read;
        places_.last_horizontal = last;
        return {};
    }

    Result<void> read_angle_list(std::vector<double>& list, std::size_t count, bool vertical, std::size_t& last) {
        list.reserve(std::min(count, numbers_.remaining_bytes() / 2 + 1));
        const auto missing = [&](std::size_t offset) {
            if (lacks_ballast_line()) return ballast_line_missing();
            const std::string message = fmt::format("{} {} angles announced, {} found", count,
                                                    vertical ? "vertical" : "horizontal", list.size());
            return vertical ? report_.fail("IES0204", offset, message) : report_.fail("IES0205", offset, message);
        };
        while (list.size() < count) {
            if (ascend_quickly(list, count)) {
                last = numbers_.token_offset();
                continue;
            }
            double value = 0.0;
            const Token token = numbers_.next(value);
            if (token == Token::end) return missing(text_.end);
            if (token != Token::number) return bad_token(token);
            last = numbers_.token_offset();
            if (!list.empty() && value <= list.back()) {
                if (value < list.back()) {
                    if (!vertical && vertical_goes_on()) return more_vertical();
                    // A list that is one value short runs into the next list, which begins on a new line: the
                    // horizontal angles at one of their usual starts, the candela anywhere.
                    const bool next_list = !vertical || value == 0.0 || value == -90.0 || value == 90.0;
                    if (next_list && numbers_.token_begins_line()) return missing(last);
                    return unsorted(list.back(), value, vertical);
                }
                const std::string message = fmt::format("angle {} is listed twice", value);
                if (vertical)
                    report_.add("IES0303", last, message);
                else
                    report_.add("IES0304", last, message);
            }
            list.push_back(value);
        }
        return {};
    }

    // Adds the angles that can be read quickly and ascend; false if the next one does not. The list is not allocated
    // for more angles than were seen.
    bool ascend_quickly(std::vector<double>& list, std::size_t count) {
        std::array<double, 64> angles;
        const NumberScanner begin = numbers_;
        double lowest = 0.0;
        double highest = 0.0;
        const std::size_t most = std::min(angles.size(), count - list.size());
        const std::size_t read = numbers_.next_quickly(std::span(angles).first(most), lowest, highest);
        std::size_t ascend = 0;
        for (double before = list.empty() ? -HUGE_VAL : list.back(); ascend < read && angles[ascend] > before; ++ascend)
            before = angles[ascend];
        if (ascend < read) {
            numbers_ = begin;
            if (ascend > 0) numbers_.next_quickly(std::span(angles).first(ascend), lowest, highest);
        }
        list.insert(list.end(), angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(ascend));
        return ascend > 0;
    }

    // Whether the horizontal list seems to begin with the rest of a vertical list that is longer than its count. Called
    // only if the file is otherwise inconsistent.
    [[nodiscard]] bool vertical_goes_on() const {
        return !horizontal_begins_line_ && !file_.horizontal_deg.empty() &&
               file_.horizontal_deg.front() > file_.vertical_deg.back();
    }

    Unexpected more_vertical() {
        return report_.fail("IES0311", places_.horizontal,
                            fmt::format("{} vertical angles announced, but the list continues with {}", vertical_count_,
                                        file_.horizontal_deg.front()));
    }

    // Whether the ballast factor, field 12 and input watts read like the first three vertical angles, on a line of
    // their own: the line was left out, and three angles were taken for it. Called only if the counts do not fit.
    [[nodiscard]] bool lacks_ballast_line() const {
        const double first = file_.ballast_factor;
        return ballast_begins_line_ && (first == 0.0 || first == 90.0 || first == -90.0) && file_.field_12 > first &&
               file_.input_watts > file_.field_12 && !file_.vertical_deg.empty() &&
               file_.vertical_deg.front() > file_.input_watts;
    }

    Unexpected ballast_line_missing() {
        return report_.fail("IES0220", ballast_place_,
                            fmt::format("the line with ballast factor, field 12 and input watts is missing: {}, {} and "
                                        "{} are vertical angles",
                                        file_.ballast_factor, file_.field_12, file_.input_watts),
                            "insert a line with these three numbers before the vertical angles: 1 1 0");
    }

    Unexpected unsorted(double before, double value, bool vertical) {
        if (lacks_ballast_line()) return ballast_line_missing();
        const std::string message =
            fmt::format("{} angle {} follows {}", vertical ? "vertical" : "horizontal", value, before);
        const std::string hint = fmt::format("angles ascend; compare the counts, {} vertical and {} horizontal angles, "
                                             "with the lists",
                                             vertical_count_, horizontal_count_);
        return vertical ? report_.fail("IES0301", numbers_.token_offset(), message, hint)
                        : report_.fail("IES0302", numbers_.token_offset(), message, hint);
    }

    Result<void> read_candela() {
        // Both counts are below 2^31, so the product fits.
        const std::uint64_t count = std::uint64_t{vertical_count_} * horizontal_count_;
        std::vector<double>& table = file_.candela;
        table.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, numbers_.remaining_bytes() / 2 + 1)));
        places_.candela = numbers_.at_end() ? text_.end : numbers_.token_offset();
        constexpr std::size_t block = 4096;
        std::size_t found = 0; // in the table, which may be longer
        while (found < count) {
            if (found == table.size())
                table.resize(found + static_cast<std::size_t>(std::min<std::uint64_t>(block, count - found)));
            const NumberScanner block_begin = numbers_;
            found += numbers_.next_quickly(std::span(table).subspan(found), lowest_, highest_);
            if (lowest_ < 0.0 && places_.first_negative == no_place) find_negative(block_begin);
            if (found == table.size()) continue;
            double value = 0.0;
            const Token token = numbers_.next(value);
            if (token == Token::end)
                return report_.fail("IES0206", text_.end,
                                    fmt::format("{} candela values announced ({} vertical times {} horizontal angles), "
                                                "{} found",
                                                count, vertical_count_, horizontal_count_, found));
            if (token != Token::number) return bad_token(token);
            if (value < 0.0 && places_.first_negative == no_place) places_.first_negative = numbers_.token_offset();
            lowest_ = std::min(lowest_, value);
            highest_ = std::max(highest_, value);
            table[found] = value;
            ++found;
        }
        places_.peak = std::max(-lowest_, highest_);
        if (numbers_.exponent_offset() != no_place)
            report_.add("IES0216", numbers_.exponent_offset(), "a number with an exponent");
        if (numbers_.at_end()) return {};
        const std::size_t rest = numbers_.token_offset();
        double value = 0.0;
        if (vertical_goes_on() && numbers_.next(value) == Token::number) return more_vertical();
        report_.add("IES0214", rest,
                    fmt::format("{} follows the {} candela values announced", quoted(numbers_.token()), count));
        return {};
    }

    // The first negative number from `numbers` on; the numbers there are known to be readable quickly.
    void find_negative(NumberScanner numbers) {
        double value = 0.0;
        while (value >= 0.0 && numbers.next(value) == Token::number)
            places_.first_negative = numbers.token_offset();
    }

    Report& report_;
    const ReadBeside& read_beside_;
    LineScanner lines_;
    NumberScanner numbers_;
    TextRange text_;
    IesFile file_;
    TablePlaces places_;
    bool version_known_ = false;
    bool horizontal_begins_line_ = true;
    bool ballast_begins_line_ = false;
    std::size_t ballast_place_ = 0;
    std::size_t vertical_count_ = 0;
    std::size_t horizontal_count_ = 0;
    double lowest_ = 0.0; // of the candela, and 0
    double highest_ = 0.0;
};

} // namespace

Result<IesFile> parse_ies(TextRange text, Report& report, const ReadBeside& read_beside) {
    return IesParser(text, report, read_beside).parse();
}

} // namespace gonio::profile_detail
