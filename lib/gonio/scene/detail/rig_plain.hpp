// Lights of a rig that are written plainly, read from the text without a tree of values and on several threads.
//
// A light is plain if it is one object of the keys of a single light, each given once, its texts ASCII without escapes,
// everything in range, and if it needs no file that is not read yet. All other elements of "lights" are left, as text,
// to the reader of values, and so is every mistake: nothing here reports one.
//
// The text is divided at bytes, not at lights: each piece begins at the first place in it that looks like the start of
// an element, and counts only if the piece before it ends exactly there. So the result does not depend on the pieces.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/detail/rig_expand.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::detail {

// What earlier lights have made of texts; it does not change while pieces are read.
struct KnownTexts {
    std::map<std::string, glm::dvec3, std::less<>> colors;
    std::map<std::string, Shape, std::less<>> shapes;                // profiles and masks loaded
    std::map<std::string, LightDescription, std::less<>> luminaires; // as lights that add nothing to them
    const Luminaires* written_luminaires = nullptr;
};

struct PlainLight {
    LightDescription light; // complete but for a name that is not given; without the rig's maintenance factor
    bool is_named = false;
    const Luminaire* luminaire = nullptr;
};

// A part of the array.
struct PlainPiece {
    std::size_t begin = 0;  // of its first element
    std::size_t end = 0;    // of the element after its last one, or of the closing bracket
    bool is_closed = false; // `end` is the bracket
    bool is_broken = false; // not a list of objects
    // An element that is not plain: its text, and how many of `lights` it is behind.
    struct Values {
        std::size_t behind;
        std::string_view text;
    };
    std::vector<PlainLight> lights;
    std::vector<Values> others;                    // a few bytes of text may be one, so these are small
    std::map<std::string_view, glm::dvec3> colors; // texts that were not known, in the rig's text
    std::map<std::string_view, Shape> shapes;
};

// The first element in an array of objects, from its opening bracket on; nothing if it is not one, or empty.
std::optional<std::size_t> first_element(std::string_view rig, std::size_t bracket);

// A place from `from` on, before `end`, that looks like the start of an element with nothing but blanks and a comma
// between it and the one before; `end` if none.
std::size_t likely_element(std::string_view rig, std::size_t from, std::size_t end);

// The elements that begin at `begin`, where one does, or after it, and before `end`.
PlainPiece read_plain(std::string_view rig, std::size_t begin, std::size_t end, const KnownTexts& known);

} // namespace gonio::detail
