#include "interactive_page.hpp"

#include <gonio/asset/content_hash.hpp>
#include <gonio/base/base64.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/text_encoding.hpp>

#include "html.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

constexpr std::string_view ready_message = "gonio-ready"; // what the page says, and the report waits for

// The reader's browser keeps the frame apart from the report: it has an origin of its own.
constexpr std::string_view script = R"js(
'use strict';
const bytesOf = (element) => Uint8Array.from(atob(element.textContent), (letter) => letter.charCodeAt(0));
const textOf = (element) => new TextDecoder().decode(bytesOf(element));
const button = document.getElementById('open-page');
button.parentElement.hidden = false;
button.addEventListener('click', () => {
  const frame = document.createElement('iframe');
  frame.title = 'Interactive stage';
  frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
  addEventListener('message', ({ source, data }) => {
    if (source !== frame.contentWindow || data?.type !== 'gonio-ready') return;
    const files = [...document.querySelectorAll('script[data-name]')].map((element) =>
      ({ name: element.dataset.name, bytes: bytesOf(element).buffer }));
    const rig = document.getElementById('rig-text');
    source.postMessage({ type: 'gonio-open', files, rig: rig && textOf(rig) }, '*');
  });
  frame.srcdoc = textOf(document.getElementById('page-bytes'));
  button.parentElement.replaceWith(frame);
  frame.focus();
});
)js";

std::string with_plain_line_ends(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r')
            plain += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            plain += '\n';
    }
    return plain;
}

// 'sha256-…', of the text as a browser has it.
std::string hash_source(std::string_view text) {
    const std::string digits = sha256(with_plain_line_ends(text));
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        unsigned value = 0;
        std::from_chars(digits.data() + i, digits.data() + i + 2, value, 16);
        bytes += static_cast<char>(value);
    }
    return fmt::format("'sha256-{}'", base64(bytes));
}

std::size_t find_any_case(std::string_view text, std::string_view lower, std::size_t from) {
    for (std::size_t at = text.find('<', from); at != std::string_view::npos; at = text.find('<', at + 1))
        if (equals_any_case(text.substr(at, lower.size()), lower)) return at;
    return std::string_view::npos;
}

// Behind the '>' that ends the tag; one in quotes does not.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
    char quote = '\0';
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (quote != '\0')
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            return at + 1;
    }
    return std::string_view::npos;
}

// The texts of the elements <script>.
std::vector<std::string_view> scripts_in(std::string_view text) {
    std::vector<std::string_view> scripts;
    std::size_t at = 0;
    while ((at = find_any_case(text, "<script", at)) != std::string_view::npos) {
        const std::size_t begin = end_of_tag(text, at);
        if (begin == std::string_view::npos) break;
        const std::size_t end = find_any_case(text, "</script", begin);
        if (end == std::string_view::npos) break;
        scripts.push_back(text.substr(begin, end - begin));
        at = end;
    }
    return scripts;
}

// Whether the page's own policy lets it make functions out of text, as some builds of WebAssembly's glue do.
bool makes_functions(std::string_view text) {
    constexpr std::string_view policy = R"(http-equiv="Content-Security-Policy" content=")";
    const std::size_t begin = text.find(policy);
    if (begin == std::string_view::npos) return false;
    const std::string_view rest = text.substr(begin + policy.size());
    return rest.substr(0, rest.find('"')).find("'unsafe-eval'") != std::string_view::npos;
}

std::string data_block(std::string_view attribute, std::string_view value, std::string_view bytes) {
    return fmt::format("<script type=\"text/plain\" {}=\"{}\">{}</script>\n", attribute, html(value), base64(bytes));
}

Result<InteractivePage> read_page(const std::string& file) {
    Result<std::string> bytes = read_file(file, limit("file-bytes"));
    if (!bytes) return pass_on(bytes);
    if (!is_utf8(*bytes) || bytes->find(ready_message) == std::string::npos)
        return fail("USE0105", "not gonio's page for browsers", "--page takes a file gonio.html", file);
    return InteractivePage{file, std::move(*bytes)};
}

} // namespace

Result<std::optional<InteractivePage>> interactive_page(const Arguments& arguments) {
    const auto named = arguments.value("--page");
    if (named && arguments.has("--no-page"))
        return fail("USE0107", "--page and --no-page are both given", "leave one of them out");
    if (arguments.has("--no-page")) return std::nullopt;
    if (named) {
        Result<InteractivePage> page = read_page(*named);
        if (!page) return pass_on(page);
        return std::move(*page);
    }
    const std::string folder = executable_folder();
    if (folder.empty()) return std::nullopt;
    for (const std::string& file : {folder + "/gonio.html", folder + "/../share/gonio/gonio.html"}) {
        if (!file_exists(file)) continue;
        Result<InteractivePage> page = read_page(file);
        if (!page) return pass_on(page);
        return std::move(*page);
    }
    return std::nullopt;
}

std::string interactive_section(const InteractivePage& page, std::span<const EmbeddedFile> profiles,
                                const std::string* rig) {
    std::string section = "<section class=\"interactive\" aria-label=\"Interactive stage\">\n"
                          "<p hidden><button id=\"open-page\" type=\"button\">Open in the interactive stage</button> "
                          "Everything is in this "
                          "file: no network is used.</p>\n";
    section += data_block("id", "page-bytes", page.bytes);
    for (const EmbeddedFile& profile : profiles)
        section += data_block("data-name", profile.name, profile.bytes);
    if (rig != nullptr) section += data_block("id", "rig-text", *rig);
    return section + fmt::format("<script>{}</script>\n</section>\n", script);
}

std::string content_policy(const InteractivePage* page) {
    if (page == nullptr) return "default-src 'none'; style-src 'unsafe-inline'; img-src data:";
    std::string sources = hash_source(script);
    for (const std::string_view text : scripts_in(page->bytes))
        sources += " " + hash_source(text);
    if (makes_functions(page->bytes)) sources += " 'unsafe-eval'";
    return fmt::format("default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; script-src {} "
                       "'wasm-unsafe-eval' blob:; worker-src blob:; base-uri 'none'; form-action 'none'",
                       sources);
}

} // namespace gonio::cli
