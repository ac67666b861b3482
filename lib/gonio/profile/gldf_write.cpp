#include <gonio/base/archive.hpp>
#include <gonio/base/inflate.hpp>
#include <gonio/base/markup.hpp>
#include <gonio/base/path.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/base/version.hpp>
#include <gonio/profile/gldf.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace gonio {

namespace {

// Content types of photometric files, by their ending.
std::string_view content_type_of(std::string_view file) {
    const std::string ending = to_lower(extension_of(file));
    return ending == "ldt" ? "ldc/eulumdat" : ending == "ies" ? "ldc/ies" : "ldc/iesxml";
}

// An identifier of the form of a UUID, which the content decides.
std::string identifier_of(std::string_view profile, std::string_view texts) {
    std::array<std::uint32_t, 4> words{};
    for (std::size_t i = 0; i < words.size(); ++i)
        words[i] = crc32(fmt::format("{}{}{}", i, texts, i % 2 == 0 ? profile : profile.substr(0, profile.size() / 2)));
    return fmt::format("{:08x}-{:04x}-8{:03x}-8{:03x}-{:04x}{:08x}", words[0], words[1] >> 16U, words[1] & 0xfffU,
                       words[2] >> 20U, words[2] & 0xffffU, words[3]);
}

// Without characters that XML does not have.
std::string escaped(std::string_view text) {
    std::string made;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20) continue;
        const std::string_view entity = markup_entity(c);
        entity.empty() ? made += c : made += entity;
    }
    return made;
}

// A name that archives and every system take.
std::string plain_name(const std::string& file) {
    std::string plain = file_name(file);
    for (char& c : plain) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                              c == '-' || c == '_';
        if (!is_plain) c = '_';
    }
    return plain;
}

std::string text_or_dash(std::string_view text) {
    return text.empty() ? std::string("-") : escaped(text);
}

std::string located(std::string_view text) {
    return fmt::format("<Locale language=\"en\">{}</Locale>", text_or_dash(text));
}

} // namespace

std::string write_gldf(std::string_view profile, const GldfProduct& product) {
    const std::string file = plain_name(product.file);
    std::string source;
    std::string reference;
    if (product.cct_k || product.cri || product.input_w) {
        std::string color;
        if (product.cri)
            color += fmt::format("          <ColorRenderingIndex>{:.0f}</ColorRenderingIndex>\n", *product.cri);
        if (product.cct_k)
            color += fmt::format("          <CorrelatedColorTemperature>{:.0f}</CorrelatedColorTemperature>\n",
                                 *product.cct_k);
        source = fmt::format(
            "    <LightSources>\n      <FixedLightSource id=\"source\">\n        <Name>{}</Name>\n{}{}"
            "      </FixedLightSource>\n    </LightSources>\n",
            located(product.name),
            product.input_w ? fmt::format("        <RatedInputPower>{}</RatedInputPower>\n", shortest(*product.input_w))
                            : std::string(),
            color.empty() ? std::string() : "        <ColorInformation>\n" + color + "        </ColorInformation>\n");
        reference = "          <LightSourceReference fixedLightSourceId=\"source\"/>\n";
    }
    const std::string xml = fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8"?>
<Root xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="https://gldf.io/xsd/gldf/1.0.0-rc.3/gldf.xsd">
  <Header>
    <Manufacturer>{}</Manufacturer>
    <FormatVersion major="1" minor="0" pre-release="3"/>
    <CreatedWithApplication>gonio {}</CreatedWithApplication>
    <GldfCreationTimeCode>{}T00:00:00Z</GldfCreationTimeCode>
    <UniqueGldfId>{}</UniqueGldfId>
  </Header>
  <GeneralDefinitions>
    <Files>
      <File id="photometry-file" contentType="{}" type="localFileName">{}</File>
    </Files>
    <Photometries>
      <Photometry id="photometry">
        <PhotometryFileReference fileId="photometry-file"/>
      </Photometry>
    </Photometries>
{}    <Emitters>
      <Emitter id="emitter">
        <FixedLightEmitter>
          <PhotometryReference photometryId="photometry"/>
{}          <RatedLuminousFlux>{:.0f}</RatedLuminousFlux>
        </FixedLightEmitter>
      </Emitter>
    </Emitters>
  </GeneralDefinitions>
  <ProductDefinitions>
    <ProductMetaData>
      <UniqueProductId>{}</UniqueProductId>
      <ProductNumber>{}</ProductNumber>
      <Name>{}</Name>
    </ProductMetaData>
    <Variants>
      <Variant id="variant">
        <Name>{}</Name>
        <Geometry>
          <EmitterReference emitterId="emitter"/>
        </Geometry>
      </Variant>
    </Variants>
  </ProductDefinitions>
</Root>
)",
        text_or_dash(product.manufacturer), GONIO_VERSION_STRING, GONIO_VERSION_DATE,
        identifier_of(profile, product.manufacturer + "\n" + product.name + "\n" + product.number + "\n" + file),
        content_type_of(file), file, source, reference, std::round(product.flux_lm),
        identifier_of({}, product.manufacturer + "\n" + product.name + "\n" + product.number), located(product.number),
        located(product.name), located(product.name));
    const std::array<ArchiveFile, 2> files{{{"product.xml", xml}, {"ldc/" + file, std::string(profile)}}};
    return write_archive(files);
}

} // namespace gonio
