// EULUMDAT: one value per line, identified by its position.
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
constexpr std::size_t direct_ratio_count = 10;

// The whole line is one number, with a point or a comma as the decimal sign.
Token number_in(std::string_view line, double& value, bool& comma) {
    const std::string_view text = trim(line);
    NumberScanner scanner(text, 0, text.size());
    double read = 0.0;
    if (scanner.next(read) == Token::number && scanner.at_end() && !text.empty() &&
        text.find(',') == std::string_view::npos) {
        value = read;
        return Token::number;
    }
    bool plain = true;
    const std::size_t at = text.find(',');
    if (at == std::string_view::npos || text.find('.') != std::string_view::npos)
        return scan_number(text, value, plain);
    std::string with_point(text);
    with_point[at] = '.';
    const Token token = scan_number(with_point, value, plain);
    comma = comma || token == Token::number;
    return token;
}

// A line with a single number that can be read quickly: returns where the next line begins and sets `number` to where
// the number begins, or returns nullptr.
const char* quick_line(const char* line, const char* end, const char*& number, double& value) {
    while (line != end && is_blank(*line))
        ++line;
    number = line;
    const char* p = read_decimal(line, end, value);
    if (p == nullptr) return nullptr;
    while (p != end && is_blank(*p))
        ++p;
    if (p == end || (*p != '\r' && *p != '\n')) return nullptr; // a decimal comma, a remark
    return p + (*p == '\r' && p + 1 != end && p[1] == '\n' ? 2 : 1);
}

class LdtParser {
public:
    LdtParser(TextRange text, Report& report)
        : report_(report), lines_(report.bytes(), text.begin, text.end), text_(text), last_text_(text.end) {
        const std::string_view bytes = report.bytes();
        while (last_text_ > text.begin &&
               (is_blank(bytes[last_text_ - 1]) || bytes[last_text_ - 1] == '\n' || bytes[last_text_ - 1] == '\r'))
            --last_text_;
    }

    Result<LdtFile> parse() {
        if (Result<void> read = read_head(); !read) return pass_on(read);
        if (Result<void> read = read_lamp_sets(); !read) return pass_on(read);
        for (std::size_t i = 0; i < direct_ratio_count; ++i) {
            double ratio = 0.0;
            if (Result<void> read = number(ratio, "direct ratio"); !read) return pass_on(read);
            if (i == 0) places_.direct_ratios = number_offset_;
            file_.direct_ratios.push_back(ratio);
        }
        if (Result<void> read = read_planes(); !read) return pass_on(read);
        if (Result<void> read = read_gammas(); !read) return pass_on(read);
        if (Result<void> read = read_intensities(); !read) return pass_on(read);
        check_ldt(file_, places_, report_);
        mark_table(places_, report_);
        report_.mark(ProfileField::light_output_ratio, places_.light_output_ratio);
        report_.mark(ProfileField::multiplier, places_.conversion_factor);
        report_.mark(ProfileField::direct_ratios, places_.direct_ratios);
        if (report_.has_error()) return report_.failure();
        return std::move(file_);
    }

private:
    Result<void> next_line(Line& line, std::string_view what) {
        if (lines_.at_end())
            return report_.fail("LDT0101", text_.end, fmt::format("the file ends where the {} is expected", what));
        line = lines_.next();
        return {};
    }

    Result<void> text(std::string& field, std::string_view what, std::size_t longest) {
        Line line;
        if (Result<void> read = next_line(line, what); !read) return read;
        field = line.text;
        text_offset_ = line.offset;
        if (field.size() > longest && trim(field).size() > longest)
            report_.add("LDT0106", line.offset + longest,
                        fmt::format("the {} has {} characters, but {} are allowed", what, field.size(), longest));
        return {};
    }

    // Read as text, without the blanks around it: users treat it as a number.
    Result<void> word(std::string& field, std::string_view what, std::size_t longest) {
        if (Result<void> read = text(field, what, longest); !read) return read;
        field = std::string(trim(field));
        return {};
    }

    // The next line as a number, if it can be read quickly.
    bool next_quickly(double& value) {
        const char* const first = report_.bytes().data();
        const char* number = nullptr;
        const char* const next = quick_line(first + lines_.offset(), first + text_.end, number, value);
        if (next == nullptr) return false;
        number_offset_ = static_cast<std::size_t>(number - first);
        lines_.go_to(static_cast<std::size_t>(next - first));
        return true;
    }

    // Reads as many lines as can be read quickly: each is one number followed directly by the line end. `lowest` and
    // `highest` are widened to include the numbers.
    std::size_t next_quickly(std::span<double> numbers, double& lowest, double& highest) {
        const char* const first = report_.bytes().data();
        NumberRun run;
        run.at = first + lines_.offset();
        run.end = first + text_.end;
        run.numbers = numbers.data();
        run.wanted = numbers.size();
        run.lowest = lowest;
        run.highest = highest;
        take_numbers(run, first, Separators::lines);
        if (run.taken == 0) return 0;
        lowest = run.lowest;
        highest = run.highest;
        number_offset_ = static_cast<std::size_t>(run.last - first);
        lines_.go_to(static_cast<std::size_t>(run.at - first));
        return run.taken;
    }

    // The same for the table.
    std::size_t next_intensities(std::span<double> numbers) {
        const std::size_t begin = lines_.offset();
        const std::size_t taken = next_quickly(numbers, lowest_, highest_);
        if (taken > 0 && lowest_ < 0.0 && places_.first_negative == no_place) {
            const char* const first = report_.bytes().data();
            places_.first_negative =
                static_cast<std::size_t>(first_negative(first + begin, numbers.first(taken)) - first);
        }
        return taken;
    }

    // Adds the angles of the list that can be read quickly, ascend and are within 0 to `most`; false if the next one
    // does not. `count` are announced; the list is not allocated for more angles than were seen.
    bool ascend_quickly(std::vector<double>& list, std::size_t count, double most) {
        std::array<double, 64> angles;
        const LineScanner begin = lines_;
        double lowest = 0.0;
        double highest = 0.0;
        const std::size_t wanted = std::min(angles.size(), count - list.size());
        const std::size_t read = next_quickly(std::span(angles).first(wanted), lowest, highest);
        std::size_t ascend = 0;
        for (double before = list.empty() ? -HUGE_VAL : list.back();
             ascend < read && angles[ascend] > before && angles[ascend] >= 0.0 && angles[ascend] <= most; ++ascend)
            before = angles[ascend];
        if (ascend < read) {
            lines_ = begin;
            if (ascend > 0) next_quickly(std::span(angles).first(ascend), lowest, highest);
        }
        list.insert(list.end(), angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(ascend));
        return ascend > 0;
    }

    // Where the first negative one of `numbers` begins, which were read from the lines at `line`.
    static const char* first_negative(const char* line, std::span<const double> numbers) {
        for (const double number : numbers) {
            if (number < 0.0) break;
            while (*line != '\r' && *line != '\n')
                ++line;
            line += line[0] == '\r' && line[1] == '\n' ? 2 : 1;
        }
        return line;
    }

    Result<void> number(double& value, std::string_view what) {
        if (next_quickly(value)) return {};
        Line line;
        if (Result<void> read = next_line(line, what); !read) return read;
        return number_of(line, value, what);
    }

    Result<void> number_of(const Line& line, double& value, std::string_view what) {
        const std::string_view written = trim(line.text);
        number_offset_ = line.offset + (line.text.size() - trim_left(line.text).size());
        value = 0.0;
        if (written.empty()) {
            report_.add("LDT0104", line.offset, fmt::format("a blank line instead of the {}, read as 0", what));
            return {};
        }
        bool comma = false;
        const Token token = number_in(line.text, value, comma);
        if (comma)
            report_.add("LDT0105", number_offset_, fmt::format("{} has a decimal comma", quoted(written.substr(0, 40))),
                        "write a point");
        if (token == Token::number) return {};
        const std::string shown = quoted(written.substr(0, 40));
        if (token == Token::not_finite)
            return report_.fail("LDT0103", number_offset_, shown + " is not a finite number up to 1e30");
        // Before the first numbers of the head this may be any file: do not report its content.
        const bool known = file_.plane_count > 0;
        return report_.fail(
            "LDT0102", number_offset_,
            fmt::format("expected the {1}, found {0}", known ? shown : "a text that is not a number", what));
    }

    Result<void> whole(int& value, std::string_view what, double lowest) {
        double number_read = 0.0;
        if (Result<void> read = number(number_read, what); !read) return read;
        if (number_read != std::floor(number_read) || number_read < lowest || number_read > largest_count)
            return report_.fail("LDT0201", number_offset_, fmt::format("{} is not a {}", number_read, what));
        value = static_cast<int>(number_read);
        return {};
    }

    Result<void> read_head() {
        constexpr std::size_t long_text = 78;
        if (Result<void> read = text(file_.company, "company", long_text); !read) return read;
        if (Result<void> read = whole(file_.type_indicator, "type of luminaire", -largest_count); !read) return read;
        if (file_.type_indicator < 0 || file_.type_indicator > 3)
            report_.add("LDT0203", number_offset_, fmt::format("type of luminaire {}", file_.type_indicator),
                        "expected 1, 2 or 3");
        if (Result<void> read = whole(file_.symmetry, "symmetry", -largest_count); !read) return read;
        if (file_.symmetry < 0 || file_.symmetry > 4)
            return report_.fail("LDT0202", number_offset_, fmt::format("symmetry {}, expected 0 to 4", file_.symmetry));
        if (Result<void> read = whole(file_.plane_count, "number of C-planes", 1.0); !read) return read;
        places_.header = number_offset_;
        if (Result<void> read = number(file_.plane_step_deg, "distance between C-planes"); !read) return read;
        plane_step_ = number_offset_;
        if (Result<void> read = whole(file_.gamma_count, "number of gamma angles", 1.0); !read) return read;
        if (Result<void> read = number(file_.gamma_step_deg, "distance between gamma angles"); !read) return read;
        gamma_step_ = number_offset_;
        if (Result<void> read = text(file_.report_number, "report number", long_text); !read) return read;
        if (Result<void> read = text(file_.luminaire_name, "luminaire's name", long_text); !read) return read;
        if (Result<void> read = text(file_.luminaire_number, "luminaire's number", long_text); !read) return read;
        if (Result<void> read = read_file_name(); !read) return read;
        if (Result<void> read = text(file_.date_user, "date and user", long_text); !read) return read;
        return read_dimensions();
    }

    Result<void> read_file_name() {
        constexpr std::size_t longest = 8;
        if (Result<void> read = text(file_.file_name, "file name", std::string_view::npos); !read) return read;
        std::string_view name = trim(file_.file_name);
        if (name.size() > 4 && equals_any_case(name.substr(name.size() - 4), ".LDT")) name.remove_suffix(4);
        if (name.size() > longest)
            report_.add("LDT0107", text_offset_ + longest,
                        fmt::format("the file name has {} characters, but {} are allowed", name.size(), longest));
        return {};
    }

    Result<void> read_dimensions() {
        struct Field {
            double* value;
            std::string_view what;
            std::size_t* place = nullptr;
        };
        std::size_t opening = no_place;
        std::size_t downward_flux = no_place;
        const Field fields[] = {
            {&file_.length_mm, "length"},
            {&file_.width_mm, "width"},
            {&file_.height_mm, "height"},
            {&file_.luminous_length_mm, "length of the luminous area", &opening},
            {&file_.luminous_width_mm, "width of the luminous area"},
            {&file_.luminous_height_c0_mm, "luminous height in C0"},
            {&file_.luminous_height_c90_mm, "luminous height in C90"},
            {&file_.luminous_height_c180_mm, "luminous height in C180"},
            {&file_.luminous_height_c270_mm, "luminous height in C270"},
            {&file_.downward_flux_percent, "downward flux fraction", &downward_flux},
            {&file_.light_output_ratio_percent, "light output ratio", &places_.light_output_ratio},
            {&file_.conversion_factor, "conversion factor", &places_.conversion_factor},
            {&file_.tilt_deg, "tilt", &places_.tilt},
        };
        for (const Field& field : fields) {
            if (Result<void> read = number(*field.value, field.what); !read) return read;
            if (field.place != nullptr) *field.place = number_offset_;
        }
        report_.mark(ProfileField::opening, opening);
        report_.mark(ProfileField::downward_flux, downward_flux);
        return {};
    }

    Result<void> read_lamp_sets() {
        int count = 0;
        if (Result<void> read = whole(count, "number of lamp sets", 1.0); !read) return read;
        for (int i = 0; i < count; ++i) { // not reserved: a set takes six lines of the file, the count only promises
            LdtLampSet set;
            if (Result<void> read = whole(set.lamp_count, "number of lamps", -largest_count); !read) return read;
            if (set.lamp_count == 0)
                report_.add("LDT0210", number_offset_, "a set without lamps",
                            "write at least 1, or a negative number for absolute photometry");
            if (Result<void> read = text(set.lamp_type, "type of lamps", 24); !read) return read;
            const auto mark = [&](ProfileField field, std::size_t offset) {
                if (i == 0) report_.mark(field, offset);
            };
            if (Result<void> read = number(set.flux_lm, "luminous flux"); !read) return read;
            mark(ProfileField::lamp_flux, number_offset_);
            if (Result<void> read = word(set.color_temperature, "colour temperature", 16); !read) return read;
            mark(ProfileField::color_temperature, text_offset_);
            if (Result<void> read = word(set.color_rendering, "colour rendering", 6); !read) return read;
            mark(ProfileField::color_rendering, text_offset_);
            if (Result<void> read = number(set.input_watts, "input power"); !read) return read;
            mark(ProfileField::input_watts, number_offset_);
            file_.lamp_sets.push_back(std::move(set));
        }
        return {};
    }

    // The next line of the table; false when only blank lines are left.
    bool table_line(Line& line) {
        if (lines_.offset() >= last_text_) return false;
        line = lines_.next();
        return true;
    }

    // A blank angle does not count as 0: every value of the table would belong to another direction.
    Result<void> angle_of(const Line& line, double& value, std::string_view what) {
        if (trim(line.text).empty())
            return report_.fail("LDT0102", line.offset, fmt::format("a blank line where the {} is expected", what));
        return number_of(line, value, what);
    }

    Result<void> read_planes() {
        const auto count = static_cast<std::size_t>(file_.plane_count);
        const auto missing = [&](std::size_t offset) {
            return report_.fail("LDT0204", offset,
                                fmt::format("{} C-planes announced, {} found", count, file_.planes_deg.size()));
        };
        while (file_.planes_deg.size() < count) {
            const std::size_t begin = lines_.offset();
            const bool is_first = file_.planes_deg.empty();
            if (ascend_quickly(file_.planes_deg, count, 360.0)) {
                if (is_first) places_.horizontal = begin;
                places_.last_horizontal = number_offset_;
                continue;
            }
            double value = 0.0;
            if (!next_quickly(value)) {
                Line line;
                if (!table_line(line)) return missing(text_.end);
                if (Result<void> read = angle_of(line, value, "angle of a C-plane"); !read) return read;
            }
            if (file_.planes_deg.empty()) places_.horizontal = number_offset_;
            places_.last_horizontal = number_offset_;
            if (!file_.planes_deg.empty() && value <= file_.planes_deg.back()) {
                if (value == 0.0 || (value == 90.0 && file_.planes_deg.back() != 90.0)) return missing(number_offset_);
                if (value < file_.planes_deg.back())
                    return report_.fail("LDT0301", number_offset_,
                                        fmt::format("C-plane {} follows {}", value, file_.planes_deg.back()));
                report_.add("LDT0303", number_offset_, fmt::format("C-plane {} is listed twice", value));
            }
            if (value < 0.0 || value > 360.0)
                return report_.fail("LDT0307", number_offset_, fmt::format("C-plane {} is outside 0 to 360", value));
            file_.planes_deg.push_back(value);
        }
        return {};
    }

    Result<void> read_gammas() {
        const auto count = static_cast<std::size_t>(file_.gamma_count);
        const auto missing = [&](std::size_t offset) {
            return report_.fail("LDT0205", offset,
                                fmt::format("{} gamma angles announced, {} found", count, file_.gammas_deg.size()));
        };
        while (file_.gammas_deg.size() < count) {
            const std::size_t begin = lines_.offset();
            const bool is_first = file_.gammas_deg.empty();
            if (ascend_quickly(file_.gammas_deg, count, 180.0)) {
                if (is_first) places_.vertical = begin;
                places_.last_vertical = number_offset_;
                continue;
            }
            double value = 0.0;
            if (!next_quickly(value)) {
                Line line;
                if (!table_line(line)) return missing(text_.end);
                if (Result<void> read = angle_of(line, value, "gamma angle"); !read) return read;
            }
            if (file_.gammas_deg.empty()) places_.vertical = number_offset_;
            places_.last_vertical = number_offset_;
            const double before = file_.gammas_deg.empty() ? -1.0 : file_.gammas_deg.back();
            // The list ended early if it has reached a usual end and does not continue as angles do.
            if ((before == 90.0 || before == 180.0) && (value < before || value > 180.0))
                return missing(number_offset_);
            if (value < 0.0 || value > 180.0)
                return report_.fail("LDT0307", number_offset_,
                                    fmt::format("gamma angle {} is outside 0 to 180", value));
            if (value < before)
                return report_.fail("LDT0302", number_offset_, fmt::format("gamma angle {} follows {}", value, before));
            if (value == before)
                report_.add("LDT0304", number_offset_, fmt::format("gamma angle {} is listed twice", value));
            file_.gammas_deg.push_back(value);
        }
        return {};
    }

    Result<void> read_intensities() {
        const auto planes = static_cast<std::size_t>(stored_plane_count(file_.symmetry, file_.plane_count));
        const std::size_t gammas = file_.gammas_deg.size();
        const std::uint64_t count = std::uint64_t{planes} * gammas; // neither exceeds the lines of the file
        std::vector<double>& table = file_.candela_per_klm;
        table.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(count, (text_.end - lines_.offset()) / 2 + 1)));
        places_.candela = lines_.offset();
        constexpr std::size_t block = 4096;
        std::size_t found = 0; // in the table, which may be longer
        while (found < count) {
            if (found == table.size())
                table.resize(found + static_cast<std::size_t>(std::min<std::uint64_t>(block, count - found)));
            found += next_intensities(std::span(table).subspan(found));
            if (found == table.size()) continue;
            double value = 0.0;
            if (!next_quickly(value)) {
                Line line;
                if (!table_line(line))
                    return report_.fail("LDT0206", text_.end,
                                        fmt::format("{} intensities announced ({} gamma angles in {} stored planes), "
                                                    "{} found",
                                                    count, gammas, planes, found));
                if (Result<void> read = number_of(line, value, "intensity"); !read) return read;
            }
            if (value < 0.0 && places_.first_negative == no_place) places_.first_negative = number_offset_;
            lowest_ = std::min(lowest_, value);
            highest_ = std::max(highest_, value);
            table[found] = value;
            ++found;
        }
        read_rest();
        places_.peak = std::max(-lowest_, highest_);
        const LdtFile& f = file_;
        const int symmetric = f.symmetry == 4 ? 4 : f.symmetry == 2 || f.symmetry == 3 ? 2 : 1;
        if (f.plane_count > 1 && f.plane_count % symmetric != 0)
            report_.add("LDT0209", places_.header,
                        fmt::format("{} C-planes with symmetry {}", f.plane_count, f.symmetry),
                        fmt::format("expected a multiple of {} over the full turn", symmetric));
        check_step(f.planes_deg, f.plane_step_deg, true);
        check_step(f.gammas_deg, f.gamma_step_deg, false);
        return {};
    }

    // After the table: nothing, a remark, or the planes that the symmetry should have left out.
    void read_rest() {
        if (lines_.offset() >= last_text_) return;
        const std::size_t rest_offset = lines_.offset();
        const std::size_t all = file_.planes_deg.size() * file_.gammas_deg.size();
        std::vector<double> table = file_.candela_per_klm;
        bool numbers_only = true;
        Line line;
        while (numbers_only && table.size() <= all && table_line(line)) {
            double value = 0.0;
            bool comma = false;
            numbers_only = number_in(line.text, value, comma) == Token::number;
            lowest_ = std::min(lowest_, value);
            highest_ = std::max(highest_, value);
            table.push_back(value);
        }
        if (!numbers_only || table.size() != all) {
            LineScanner again(report_.bytes(), rest_offset, last_text_);
            Line rest = again.next();
            while (trim(rest.text).empty())
                rest = again.next();
            report_.add("LDT0207", rest.offset + (rest.text.size() - trim_left(rest.text).size()),
                        fmt::format("{} follows the {} intensities announced", quoted(trim(rest.text).substr(0, 40)),
                                    file_.candela_per_klm.size()));
            return;
        }
        report_.add(
            "LDT0208", rest_offset,
            fmt::format("symmetry {} announced, but the table holds all {} planes", file_.symmetry, file_.plane_count));
        file_.candela_per_klm = std::move(table);
        if (!complete_planes()) file_.symmetry = 0;
    }

    // Some programs count and list only the stored planes: 0–180 under symmetry 2, 0–90 under 4. The table then matches
    // the symmetry, and the planes over the full turn follow from it.
    bool complete_planes() {
        std::vector<double>& planes = file_.planes_deg;
        if (planes.size() < 2 || planes.front() != 0.0) return false;
        const double span = file_.symmetry == 2 ? 180.0 : 90.0;
        if ((file_.symmetry != 2 && file_.symmetry != 4) || planes.back() != span) return false;
        const auto mirror = [&](double about) {
            for (std::size_t i = planes.size() - 1; i-- > 0;)
                planes.push_back(2.0 * about - planes[i]);
        };
        if (file_.symmetry == 4) mirror(90.0);
        mirror(180.0);
        planes.pop_back(); // 360 is the same as 0
        file_.plane_count = static_cast<int>(planes.size());
        return true;
    }

    void check_step(const std::vector<double>& angles, double announced, bool planes) {
        if (angles.size() < 2) return;
        const double step = angles[1] - angles[0];
        bool even = true;
        for (std::size_t i = 1; i < angles.size(); ++i)
            even = even && std::abs(angles[i] - angles[i - 1] - step) < 1e-3;
        if (even ? std::abs(announced - step) < 1e-3 : announced == 0.0) return;
        const std::string message = even
                                        ? fmt::format("{} announced between the {}, but the angles are {} apart",
                                                      announced, planes ? "C-planes" : "gamma angles", step)
                                        : fmt::format("{} announced between the {}, but the angles are not equidistant",
                                                      announced, planes ? "C-planes" : "gamma angles");
        if (planes)
            report_.add("LDT0305", plane_step_, message);
        else
            report_.add("LDT0306", gamma_step_, message);
    }

    Report& report_;
    LineScanner lines_;
    TextRange text_;
    std::size_t last_text_; // after the last byte that is neither blank nor line end
    LdtFile file_;
    LdtPlaces places_;
    std::size_t number_offset_ = 0; // of the number read last
    std::size_t text_offset_ = 0;   // of the text read last
    double lowest_ = 0.0;           // of the table, and 0
    double highest_ = 0.0;
    std::size_t plane_step_ = 0;
    std::size_t gamma_step_ = 0;
};

} // namespace

Result<LdtFile> parse_ldt(TextRange text, Report& report) {
    return LdtParser(text, report).parse();
}

} // namespace gonio::profile_detail
