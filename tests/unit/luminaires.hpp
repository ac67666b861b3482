// GLDF and GDTF archives in tests.
#pragma once

#include <gonio/base/archive.hpp>

#include <array>
#include <string>
#include <vector>

namespace gonio::test {

// LM-63 with one plane: 100 cd in every direction below the horizon, 200 π lm.
inline std::string half_sphere(const std::string& candela = "100") {
    return "IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n" + candela + " " +
           candela + "\n";
}

// A luminaire with a fixed emitter of 500 lm at 3000 K, a changeable one with two lamps of 400 lm, and two variants.
inline std::string product() {
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<Root>
<Header><Manufacturer>Works</Manufacturer><FormatVersion major="1" minor="0" pre-release="3"/>
<CreatedWithApplication>by hand</CreatedWithApplication><GldfCreationTimeCode>2026-01-01T00:00:00Z</GldfCreationTimeCode></Header>
<GeneralDefinitions>
<Files>
<File id="f1" contentType="ldc/ies" type="localFileName">a.ies</File>
<File id="f2" contentType="ldc/ies" type="localFileName">b.ies</File>
</Files>
<Photometries>
<Photometry id="p1"><PhotometryFileReference fileId="f1"/></Photometry>
<Photometry id="p2"><PhotometryFileReference fileId="f2"/></Photometry>
<Photometry id="p3"><DescriptivePhotometry><LuminousEfficacy>100</LuminousEfficacy></DescriptivePhotometry></Photometry>
</Photometries>
<Spectrums><Spectrum id="s"><Intensity wavelength="400">0.5</Intensity><Intensity wavelength="700">1</Intensity></Spectrum></Spectrums>
<LightSources>
<FixedLightSource id="led"><RatedInputPower>5</RatedInputPower><SpectrumReference spectrumId="s"/>
<ColorInformation><ColorRenderingIndex>90</ColorRenderingIndex><CorrelatedColorTemperature>3000</CorrelatedColorTemperature></ColorInformation></FixedLightSource>
<ChangeableLightSource id="lamp"><RatedInputPower>20</RatedInputPower><RatedLuminousFlux>400</RatedLuminousFlux></ChangeableLightSource>
</LightSources>
<Equipments><Equipment id="two"><LightSourceReference changeableLightSourceId="lamp" lightSourceCount="2"/></Equipment></Equipments>
<Emitters>
<Emitter id="down"><FixedLightEmitter><Name><Locale language="de">unten</Locale><Locale language="en">below</Locale></Name>
<PhotometryReference photometryId="p1"/><LightSourceReference fixedLightSourceId="led"/><RatedLuminousFlux>500</RatedLuminousFlux></FixedLightEmitter></Emitter>
<Emitter id="up"><ChangeableLightEmitter><Rotation><X>180</X><Y>0</Y><Z>0</Z></Rotation><EquipmentReference equipmentId="two"/><PhotometryReference photometryId="p2"/></ChangeableLightEmitter>
<ChangeableLightEmitter emergencyBehaviour="EmergencyOnly"><EquipmentReference equipmentId="two"/><PhotometryReference photometryId="p2"/></ChangeableLightEmitter></Emitter>
<Emitter id="told"><FixedLightEmitter><PhotometryReference photometryId="p3"/></FixedLightEmitter></Emitter>
</Emitters>
</GeneralDefinitions>
<ProductDefinitions>
<ProductMetaData><ProductNumber><Locale language="en">W1</Locale></ProductNumber><Name><Locale language="en">Lamp</Locale></Name></ProductMetaData>
<Variants>
<Variant id="v1"><Name><Locale language="en">one</Locale></Name><Geometry><EmitterReference emitterId="down"/></Geometry></Variant>
<Variant id="v2"><Geometry><ModelGeometryReference geometryId="g"><EmitterReference emitterId="up"/></ModelGeometryReference></Geometry></Variant>
</Variants>
</ProductDefinitions>
</Root>
)";
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    return at == std::string::npos ? std::string("not found: ") + what : text.replace(at, what.size(), by);
}

inline std::string gldf_of(const std::string& xml, const std::string& first = half_sphere(),
                           const std::string& second = replaced(half_sphere("50"), "1 -1 1", "1 1000 1")) {
    return write_archive(
        std::array<ArchiveFile, 3>{{{"product.xml", xml}, {"ldc/a.ies", first}, {"ldc/b.ies", second}}});
}

inline std::string gdtf_of(const std::string& xml) {
    return write_archive(std::array<ArchiveFile, 1>{{{"description.xml", xml}}});
}

} // namespace gonio::test
