// The XML of an archive: product.xml of GLDF, description.xml of GDTF. Internal.
#pragma once

#include <gonio/base/archive.hpp>
#include <gonio/base/codes/archive.hpp>
#include <gonio/base/text_places.hpp>

#include <pugixml.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace gonio {

// A document with the bytes that its nodes point to.
class ArchiveXml {
public:
    // Fails (malformed) if the archive has no such file, and on text that is not well-formed, has a document type or
    // another root, or is beyond a limit.
    static Result<std::unique_ptr<ArchiveXml>> read(const Archive& archive, std::string_view name,
                                                    std::string_view root);

    pugi::xml_node root() const { return document_.document_element(); }

    // Of an element: line and column of its '<', where the text is UTF-8.
    Location place(pugi::xml_node node);

    const std::string& source() const { return source_; }

private:
    std::string source_; // "lamp.gldf/product.xml"
    std::string text_;   // as it was read
    TextPlaces places_;
    std::string parsed_; // pugixml's, with zeros between names and values
    pugi::xml_document document_;
};

// The text of an element without blanks around it.
std::string_view text_in(pugi::xml_node node);

// A failure of an archive or of what is in it.
Unexpected archive_error(ArchiveCode code, Location location, std::string message, std::string hint = {});

} // namespace gonio
