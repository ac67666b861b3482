// Diagnostic codes of scenes of other programs: reading their lights, and what an audit finds in them.
#pragma once

#include <gonio/base/diagnostic_codes.hpp>

#include <array>

namespace gonio {

inline constexpr auto scene_codes = std::to_array<DiagnosticCode>({
    {"SCN0101", Severity::error, Strict::same, "not a scene that gonio reads",
     "The content of the file is not that of a format whose lights gonio reads. 'gonio list scene-formats' shows them; "
     "--from names one if the content does not show it."},
    {"SCN0102", Severity::error, Strict::same, "broken scene",
     "The text or the binary container breaks the rules of its format, or ends too early."},
    {"SCN0103", Severity::error, Strict::same, "reference to nothing in a scene",
     "The scene refers to a node, light, buffer, material or name that it does not have."},
    {"SCN0104", Severity::error, Strict::same, "scene that is no tree",
     "A node is among its own ancestors, or has two parents, or a file includes itself. The place of its lights is not "
     "defined."},
    {"SCN0105", Severity::error, Strict::same, "invalid value in a scene",
     "A value has the wrong type or size, or is not a finite number."},
    {"SCN0106", Severity::error, Strict::same, "extension that gonio does not know",
     "The scene requires an extension that may change what its lights mean. Extensions for materials, textures and "
     "compressed meshes do not."},
    {"SCN0107", Severity::warning, Strict::same, "file of a light that is missing",
     "The profile or the part of a scene that a light needs is missing or broken, or may not be read: only files under "
     "the folder of the scene are. The light is listed but not written to a rig."},
    {"SCN0108", Severity::error, Strict::same, "scene beyond a limit",
     "The scene has more nodes or lights than gonio allows, or is nested too deep. 'gonio list limits' shows the "
     "limits."},

    {"SCN0201", Severity::warning, Strict::same, "assumption about a light",
     "The scene does not state this, so gonio assumes what the message says. An option of 'gonio lights' changes it if "
     "there is one."},
    {"SCN0202", Severity::warning, Strict::same, "something of a light that a rig cannot hold",
     "The light is converted, but a rig has nothing for this. The message states what is lost."},
    {"SCN0203", Severity::warning, Strict::same, "light that is only listed",
     "A rig cannot hold such a light, or its values are outside what the format allows. The message states why."},
    {"SCN0204", Severity::note, Strict::same, "light that is not shown",
     "The light is in the file, but not in the scene that it shows: it has no place there, or is switched off."},

    {"SCN0301", Severity::warning, Strict::same, "watts taken as candela or lux",
     "The amount is a round number of watts times 683 lm/W (over 4π for a point). 683 lm/W holds only for green light "
     "of 555 nm: white light has about 180, a lamp's electrical watt 5 to 200."},
    {"SCN0302", Severity::warning, Strict::same, "more light than a lamp has",
     "The luminous flux, intensity or illuminance is beyond what such a light has in practice: 200,000 lm, a million "
     "candela, 130,000 lx of a sun, the luminance of the sun's disk."},
    {"SCN0303", Severity::warning, Strict::same, "amounts that differ by π or 4π",
     "Lights of one kind differ by exactly π or 4π, the factors between lumens, candela and nits: some were converted "
     "and some were not, or by another formula."},
    {"SCN0304", Severity::warning, Strict::same, "cone angle of another convention",
     "The cone of a spot is given as a half angle in radians in glTF. An angle beyond π/2 is a full angle or degrees."},
    {"SCN0305", Severity::warning, Strict::same, "centimetres taken as metres",
     "The lights are hundreds of metres apart or large, as if their lengths were in centimetres."},
    {"SCN0306", Severity::warning, Strict::same, "profile multiplied twice",
     "The multiplier of a profile is its own peak or flux: the profile has its candela already, so that the light is "
     "multiplied by them twice."},
    {"SCN0307", Severity::warning, Strict::same, "temperature and tint both applied",
     "The light has a colour temperature, and its colour is tinted too. Both multiply."},
    {"SCN0308", Severity::warning, Strict::same, "light without inverse square",
     "The light does not fall with the square of the distance, or its range is 0. Its amount is not a photometric "
     "one."},
    {"SCN0309", Severity::warning, Strict::same, "negative light",
     "The amount is below 0. No lamp takes light away, and a rig does not hold such a light."},
    {"SCN0310", Severity::warning, Strict::same, "black light",
     "The amount or the colour is 0: the light does nothing, but costs time."},
    {"SCN0311", Severity::warning, Strict::same, "amounts without units",
     "All lights have small amounts such as 1 or 5 although the scene is metres wide: they were chosen by eye, and are "
     "not candela."},
    {"SCN0312", Severity::warning, Strict::same, "colour that carries power",
     "The greatest channel of the colour is not 1, so the colour changes the amount. In glTF the amount is multiplied "
     "by the colour."},
});
static_assert(in_order(scene_codes));

using SceneCode = CodeOf<scene_codes>;

} // namespace gonio
