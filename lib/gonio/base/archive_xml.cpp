#include <gonio/base/archive_xml.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/xml_depth.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gonio {

Unexpected archive_error(ArchiveCode code, Location location, std::string message, std::string hint) {
    const bool is_valid = code->code == "ARC0105" || code->code == "ARC0106";
    Diagnostic said;
    said.code = code->code;
    said.severity = Severity::error;
    said.location = std::move(location);
    said.message = std::move(message);
    said.hint = std::move(hint);
    return Unexpected(Error(is_valid ? Failure::unsupported : Failure::malformed, {std::move(said)}));
}

Result<std::unique_ptr<ArchiveXml>> ArchiveXml::read(const Archive& archive, std::string_view name,
                                                     std::string_view root) {
    const ArchiveEntry* const entry = archive.find(name);
    if (entry == nullptr)
        return archive_error("ARC0107", {archive.source(), 0, 0}, fmt::format("the archive has no {}", name));
    auto xml = std::make_unique<ArchiveXml>();
    xml->source_ = archive.name_of(*entry);
    if (entry->size > limit("archive-xml-bytes").value)
        return archive_error("ARC0203", {xml->source_, 0, 0},
                             fmt::format("larger than {}", to_text(limit("archive-xml-bytes"))),
                             std::string(limits_hint));
    Result<std::string> text = archive.read(*entry);
    if (!text) return pass_on(text);
    xml->text_ = std::move(*text);
    xml->places_ = TextPlaces(xml->text_, xml->source_);
    xml->parsed_ = xml->text_;
    constexpr unsigned how = pugi::parse_default | pugi::parse_doctype;
    const pugi::xml_parse_result parsed =
        xml->document_.load_buffer_inplace(xml->parsed_.data(), xml->parsed_.size(), how, pugi::encoding_auto);
    // A broken document has the nodes up to the fault, its document type among them.
    for (const pugi::xml_node node : xml->document_.children())
        if (node.type() == pugi::node_doctype)
            return archive_error("ARC0202", {xml->source_, 0, 0}, "the XML declares a document type (<!DOCTYPE>)",
                                 "remove the declaration if you trust the file");
    if (!parsed)
        return archive_error("ARC0201",
                             xml->places_.at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0))),
                             fmt::format("this is not well-formed XML: {}", parsed.description()));
    if (std::string_view(xml->root().name()) != root)
        return archive_error("ARC0201", xml->place(xml->root()), fmt::format("the root element is not '{}'", root));
    if (const pugi::xml_node deep = first_too_deep(xml->document_))
        return archive_error("ARC0203", xml->place(deep),
                             fmt::format("elements nested deeper than {}", to_text(limit("xml-depth"))),
                             std::string(limits_hint));
    return xml;
}

Location ArchiveXml::place(pugi::xml_node node) {
    const std::ptrdiff_t offset = node.offset_debug();
    if (offset < 1) return {source_, 0, 0};
    return places_.at(static_cast<std::size_t>(offset) - 1);
}

std::string_view text_in(pugi::xml_node node) {
    return trimmed(node.child_value());
}

} // namespace gonio
