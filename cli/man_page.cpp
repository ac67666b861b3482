#include "man_page.hpp"

#include <gonio/base/version.hpp>

#include "arguments.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::size_t line_length = 78; // mandoc's lint reports longer lines

// In mandoc's count, which takes a character that is not ASCII as \[u2026].
std::size_t length(std::string_view text) {
    std::size_t sum = 0;
    for (const char c : text)
        if (const auto byte = static_cast<unsigned char>(c); byte < 0x80)
            sum += 1;
        else if (byte >= 0xc0)
            sum += 8;
    return sum;
}

// Text as roff prints it unchanged. An unescaped hyphen or quotation mark may come out as a typographic one, which
// nobody can paste into a shell.
std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '\\':
            out += "\\e";
            break;
        case '-':
            out += "\\-";
            break;
        case '\'':
            out += "\\(aq";
            break;
        case '`':
            out += "\\(ga";
            break;
        case '^':
            out += "\\(ha";
            break;
        case '~':
            out += "\\(ti";
            break;
        default:
            out += c;
        }
    }
    return out;
}

// A full stop at the start of a line would be a request.
std::string guarded(std::string line) {
    if (line.starts_with('.')) line.insert(0, "\\&");
    return line;
}

// Escaped text as lines of a limited length, which the formatter fills.
std::string lines(std::string_view text) {
    std::string out;
    std::string line;
    const auto end_line = [&] {
        if (!line.empty()) out += guarded(std::exchange(line, {})) + '\n';
    };
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
        const std::string_view word = text.substr(begin, end - begin);
        if (!line.empty() && length(line) + 1 + length(word) > line_length) end_line();
        if (!word.empty()) line += (line.empty() ? "" : " ") + std::string(word);
        begin = end + 1;
    }
    end_line();
    return out;
}

std::string filled(std::string_view text) {
    return lines(escaped(text));
}

// Lines of help text: those that are indented are a table or a program and stay as they are, the others are filled.
std::string paragraphs(std::string_view text) {
    std::string out;
    std::string prose;
    bool verbatim = false;
    const auto end_prose = [&] {
        if (!prose.empty()) out += ".PP\n" + filled(std::exchange(prose, {}));
    };
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool indented = line.starts_with(' ');
        if (indented && !verbatim) {
            end_prose();
            out += ".PP\n.EX\n";
        }
        if (!indented && verbatim) out += ".EE\n";
        verbatim = indented;
        if (indented)
            out += escaped(line) + '\n';
        else if (line.empty())
            end_prose();
        else
            prose += std::string(line) + '\n';
    }
    if (verbatim) out += ".EE\n";
    end_prose();
    return out;
}

std::string capital(std::string_view text) {
    std::string out(text);
    if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
    return out;
}

std::string upper(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
}

std::string head(std::string_view name, std::string_view summary) {
    return fmt::format(".TH {} 1 {} \"gonio {}\" \"gonio manual\"\n.SH NAME\n{}", escaped(upper(name)), version_date,
                       version, lines(fmt::format("{} \\- {}", escaped(name), escaped(summary))));
}

// "-o, --output FILE" with the names in bold and the value in italics.
std::string tag(const Option& option) {
    std::string out;
    for (const std::string_view name : spellings(option))
        out += fmt::format("{}\\fB{}\\fR", out.empty() ? "" : ", ", escaped(name));
    if (!option.value.empty()) out += fmt::format(" \\fI{}\\fR", escaped(option.value));
    return out;
}

std::string examples(std::span<const Example> all) {
    std::string out = all.empty() ? "" : ".SH EXAMPLES\n";
    for (const Example& example : all)
        out += fmt::format(".TP\n\\fB{}\\fR\n{}", escaped(example.command), filled(example.says));
    return out;
}

struct Described {
    std::string_view name;
    std::string_view says;
};

std::string tagged(std::string_view title, std::span<const Described> all) {
    std::string out = fmt::format(".SH {}\n", title);
    for (const Described& entry : all)
        out += fmt::format(".TP\n\\fB{}\\fR\n{}", escaped(entry.name), filled(entry.says));
    return out;
}

constexpr std::array environment{
    Described{"OCIO", "The OpenColorIO configuration, if --ocio names none."},
    Described{"NO_COLOR", "If it is set and not empty, diagnostics have no colour (--color=always wins)."},
};

constexpr std::array exit_statuses{
    Described{"0", "Success."},
    Described{"1", "A check failed, or profiles differ."},
    Described{"2", "Wrong usage: an unknown option or name, a value that is not possible."},
    Described{"3", "A file could not be read or written."},
    Described{"4", "An input is malformed."},
    Described{"5", "The input is valid, but gonio cannot do this with it; or a module is not installed."},
    Described{"70", "An internal error, which is a bug."},
};

} // namespace

std::string man_page_name(const Command& command) {
    return fmt::format("gonio-{}", command.name);
}

std::string man_page() {
    std::string text = head("gonio", "photometric lights: units, measured profiles, textures, previews");
    text += ".SH SYNOPSIS\n\\fBgonio\\fR \\fICOMMAND\\fR [arguments]\n.SH DESCRIPTION\n";
    text +=
        filled("Converts between lumens, candela, lux and nits for the shape of a light. Reads, checks, creates and "
               "converts measured IES, EULUMDAT and TM-33 profiles, bakes them into textures, exports them to "
               "engines and renderers, and previews how a light falls on a stage.");
    text += ".PP\n" + filled("The result goes to stdout, or into the files that are named; diagnostics and progress go "
                             "to stderr. The name '-' is stdin or stdout, and @LIST reads file names from a file.");
    text += ".SH COMMANDS\n";
    for (const Command* command : commands())
        text += fmt::format(".TP\n\\fB{}\\fR(1)\n{}", escaped(man_page_name(*command)),
                            filled(fmt::format("{}.", capital(command->summary))));
    text +=
        ".PP\n" + filled("'gonio help COMMAND' prints the options and examples of a command, 'gonio list' the names "
                         "that options take, and 'gonio explain CODE' what a diagnostic means.");
    text += tagged("ENVIRONMENT", environment);
    text += tagged("\"EXIT STATUS\"", exit_statuses);
    text += ".PP\n" + filled("If a command has several inputs, every input is tried and the highest status counts.");
    text += ".SH \"SEE ALSO\"\n";
    for (const Command* command : commands())
        text +=
            fmt::format(".BR {} (1){}\n", escaped(man_page_name(*command)), command == commands().back() ? "" : ",");
    return text;
}

std::string man_page(const Command& command) {
    std::string text = head(man_page_name(command), command.summary);
    text += fmt::format(".SH SYNOPSIS\n\\fBgonio {}\\fR\n{}.SH DESCRIPTION\n", escaped(command.name),
                        filled(command.usage));
    text += filled(fmt::format("{}.", capital(command.summary)));
    text += paragraphs(command.arguments);
    text += ".SH OPTIONS\n";
    for (const OptionGroup& group : command.groups) {
        text += fmt::format(".SS {}\n", escaped(capital(group.title)));
        for (const Option& option : group.options)
            text += fmt::format(
                ".TP\n{}\n{}", tag(option),
                filled(fmt::format("{}{}.", capital(option.help), option.repeatable ? "; repeatable" : "")));
    }
    text += examples(command.examples);
    text += ".SH \"SEE ALSO\"\n.BR gonio (1)\n";
    return text;
}

} // namespace gonio::cli
