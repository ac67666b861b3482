// The interactive page in a report: gonio's page for browsers, which the reader opens by a button. The report holds its
// bytes and those of the profiles, and hands them over when the page says that it is ready.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gonio::cli {

struct InteractivePage {
    std::string file;
    std::string bytes;
};

// That of --page, else gonio.html beside the tool or in share/gonio of its installation; none with --no-page, or if it
// is not installed. Fails (io) if --page cannot be read and (usage) if it is another page.
Result<std::optional<InteractivePage>> interactive_page(const Arguments& arguments);

struct EmbeddedFile {
    std::string_view name;
    std::string_view bytes;
};

// The section with the button, the data and the script. `rig` is nullptr for none.
std::string interactive_section(const InteractivePage& page, std::span<const EmbeddedFile> profiles,
                                const std::string* rig);

// The Content-Security-Policy of a report, which the frame of a page inherits: without a page nothing runs. With one
// its inline scripts and that of the section run, by their hashes, and WebAssembly and workers that they start;
// functions made out of text only if the page's own policy allows them.
std::string content_policy(const InteractivePage* page);

} // namespace gonio::cli
