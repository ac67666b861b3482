// The luminous opening as each format encodes it: the inverse of gonio/profile/luminous_opening.hpp.
#pragma once

#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/profile.hpp>

namespace gonio {

// Writes the opening into the three dimensions of an LM-63 header, in metres, by the sign codes of the file's edition
// (those of 1995 for older files too).
// Returns the opening that a reader will see: the same shape, or the nearest one that the edition has a code for.
LuminousOpening set_opening(IesFile& file, const LuminousOpening& opening);

// Writes the opening into EULUMDAT's fields, which can express rectangles, boxes, disks and upright cylinders.
LuminousOpening set_opening(LdtFile& file, const LuminousOpening& opening);

// The size of a luminaire's housing in metres; 0, 0, 0 where it is not known.
struct HousingSize {
    double length_m = 0.0;
    double width_m = 0.0;
    double height_m = 0.0;
};

// Writes both into a TM-33 document, in which `emitter` will be the only emitter: a flat opening as an area of the
// bottom face, a box as the luminaire's own size.
LuminousOpening set_opening(Tm33File& file, Tm33Emitter& emitter, const LuminousOpening& opening,
                            const HousingSize& housing);

} // namespace gonio
