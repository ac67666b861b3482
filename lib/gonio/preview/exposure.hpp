// Exposure: from luminance in cd/m² to a picture in which 1 is the display's white.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/quantity.hpp>

#include <cstdint>
#include <span>

#pragma GCC visibility push(default)
namespace gonio {

// The luminance that becomes 1: 1.2 · 2^EV, saturation-based sensitivity (ISO 12232) through a lens that transmits 65 %
// (Lagarde and de Rousiers 2014, §5.1).
Nits white_luminance(Ev100 ev);

// The exposure at which the lit pixels are middle grey in the geometric mean, 0.18 of the display's white (E. Reinhard
// et al., "Photographic Tone Reproduction for Digital Images", 2002), as far as no more than one in 40 of them becomes
// white and at least one in 200 does: neither a pool of light below a spot nor dark surroundings decide alone. Pixels
// for which `subject` is not 0 have at least half of the weight in all of this, as the middle of the picture has in
// centre-weighted cameras: a hot spot on a ceiling does not darken what is shown below it. Pixels for which `left_out`
// is not 0 do not count, unless no other pixel is lit; they are lights that are visible themselves. Both are empty or
// have one value for each pixel. 0 for a picture without light. `threads` as in parallel_for(); the result does not
// depend on it.
Ev100 auto_exposure(const Image& rgb_nits, std::span<const std::uint8_t> left_out = {},
                    std::span<const std::uint8_t> subject = {}, unsigned threads = 1);

// The exposure at which a matte 18 % card with this illuminance is middle grey, 0.18 of the display's white; a white
// card, of luminance E/π, is then white. An incident-light meter gives another value: by ISO 2720, EV = log2(E/2.5) (C
// = 250), at which the card appears at 0.12, log2(1.2 π/2.5) = 0.59 stops darker. Needs E > 0.
Ev100 exposure_of_card(Lux on_card);

// The illuminance of the card for an exposure: the inverse of exposure_of_card.
Lux card_illuminance(Ev100 ev);

// Whether a channel of any pixel is as high as this. False for what is not a number.
bool reaches(const Image& rgb_nits, Nits nits);

// Divides every channel by white_luminance(ev).
void expose(Image& image, Ev100 ev);

} // namespace gonio
#pragma GCC visibility pop
