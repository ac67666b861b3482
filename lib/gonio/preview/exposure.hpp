// Exposure: from luminance in cd/m² to a picture in which 1 is the display's white.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>

namespace gonio {

// The luminance that becomes 1: 1.2 · 2^EV, saturation-based sensitivity (ISO 12232) through a lens that passes 65 %
// (Lagarde and de Rousiers 2014, §5.1).
Nits white_luminance(Ev100 ev);

// The exposure at which 99.5 % of the lit pixels lie below the display's white, so that a light that is seen
// itself or a highlight does not darken the rest. 0 for a picture without light.
Ev100 auto_exposure(const Image& rgb_nits);

// Divides every channel by white_luminance(ev).
void expose(Image& image, Ev100 ev);

} // namespace gonio
