#include <gonio/profile/number_text.hpp>
#include <gonio/profile/parse.hpp>
#include <gonio/profile/write.hpp>

#include <algorithm>
#include <span>
#include <string_view>

namespace gonio {

namespace {

constexpr std::string_view line_end = "\r\n";

// Numbers separated by single blanks; a line is broken where the next number would exceed `longest` characters.
class NumberLines {
public:
    NumberLines(std::string& text, std::size_t longest) : text_(text), longest_(longest) {}

    void add(double value) {
        const std::size_t before = text_.size();
        if (before > line_) text_ += ' ';
        number_.append(text_, value);
        if (before == line_ || text_.size() - line_ + line_end.size() <= longest_) return;
        text_.replace(before, 1, line_end);
        line_ = before + line_end.size();
    }

    void add(std::span<const double> values) {
        for (const double value : values)
            add(value);
    }

    void end() {
        text_ += line_end;
        line_ = text_.size();
    }

private:
    std::string& text_;
    profile_detail::NumberText number_;
    std::size_t longest_;
    std::size_t line_ = text_.size(); // where the line begins
};

std::string_view standard_line(IesVersion version) {
    switch (version) {
    case IesVersion::lm63_1986:
        return {};
    case IesVersion::lm63_1991:
        return "IESNA91";
    case IesVersion::lm63_1995:
        return "IESNA:LM-63-1995";
    case IesVersion::lm63_2002:
        return "IESNA:LM-63-2002";
    case IesVersion::lm63_2019:
        break;
    }
    return "IES:LM-63-2019";
}

void write_keyword(std::string& text, const IesKeyword& keyword) {
    std::string_view rest = keyword.text;
    if (!keyword.name.empty()) {
        text += '[' + keyword.name + ']';
        if (!rest.empty() && rest.front() != '\n') text += ' ';
    }
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
        text += rest.substr(0, end);
        text += line_end;
        text += "[MORE]";
        rest.remove_prefix(end + 1);
        if (!rest.empty() && rest.front() != '\n') text += ' ';
    }
    text += rest;
    text += line_end;
}

} // namespace

std::string write_ies(const IesFile& file, std::size_t longest_line) {
    const bool since_2002 = file.version == IesVersion::lm63_2002 || file.version == IesVersion::lm63_2019;
    const std::size_t longest = longest_line != 0 ? longest_line : since_2002 ? 256 : 132;
    std::string text;
    text.reserve(1024 + 8 * file.candela.size());
    const std::string_view version = file.version_line.empty() ? standard_line(file.version) : file.version_line;
    if (!version.empty()) {
        text += version;
        text += line_end;
    }
    for (const IesKeyword& keyword : file.keywords)
        write_keyword(text, keyword);
    // Blanks before a label have no meaning.
    if (profile_detail::begins_as_other_file(text)) text.insert(text.begin(), ' ');
    text += "TILT=" + file.tilt_keyword;
    text += line_end;

    NumberLines lines(text, longest);
    if (file.tilt_keyword == "INCLUDE") {
        lines.add(file.tilt.lamp_to_luminaire_geometry);
        lines.end();
        lines.add(static_cast<double>(file.tilt.angles_deg.size()));
        lines.end();
        lines.add(file.tilt.angles_deg);
        lines.end();
        lines.add(file.tilt.factors);
        lines.end();
    }
    const double type = file.photometry == Photometry::c ? 1.0 : file.photometry == Photometry::b ? 2.0 : 3.0;
    NumberLines unbroken(text, std::string::npos);
    for (const double value :
         {static_cast<double>(file.lamp_count), file.lumens_per_lamp, file.candela_multiplier,
          static_cast<double>(file.vertical_deg.size()), static_cast<double>(file.horizontal_deg.size()), type,
          file.feet ? 1.0 : 2.0, file.width, file.length, file.height})
        unbroken.add(value);
    unbroken.end();
    for (const double value : {file.ballast_factor, file.field_12, file.input_watts})
        unbroken.add(value);
    unbroken.end();

    NumberLines table(text, longest);
    table.add(file.vertical_deg);
    table.end();
    table.add(file.horizontal_deg);
    table.end();
    const std::size_t count = std::max<std::size_t>(file.vertical_deg.size(), 1);
    for (std::size_t i = 0; i < file.candela.size(); i += count) {
        table.add(std::span(file.candela).subspan(i, std::min(count, file.candela.size() - i)));
        table.end();
    }
    return text;
}

} // namespace gonio
