// Classes of outdoor luminaires: backlight, uplight and glare (IES TM-15), cut-off (IES), the classes of luminous
// intensity and of glare for roads (EN 13201-2).
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/figures/figure.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/web.hpp>
#include <gonio/web/zones.hpp>

#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace gonio {

// The BUG rating of IES TM-15-11: each from 0, and 5 beyond the last limit.
struct BugRating {
    int backlight = 0;
    int uplight = 0;
    int glare = 0;        // of the distributions I to IV, which light a street beside them
    int glare_type_v = 0; // of type V, which light all around: more is allowed to the back
};

// "B3 U0 G2"; of type V with its own glare rating.
std::string to_text(const BugRating& rating, bool type_v = false);

// That of the lumens in the secondary solid angles.
BugRating bug_rating(const LuminaireClassification& classes);

// The greatest intensities at high angles [cd]. Exact for type C, in steps of 1° of γ and 2° of C for types A and B.
struct HighAngles {
    double from_70_cd = 0.0; // γ ≥ 70°
    double from_80_cd = 0.0;
    double from_90_cd = 0.0;
    double above_90_cd = 0.0; // γ > 90°: a table that ends there in light is dark beyond
    double above_95_cd = 0.0;
};

// Those of a web.
HighAngles high_angles(const Web& web);

// IES cut-off classification (RP-8-00, since replaced by BUG).
enum class CutOff { full_cutoff, cutoff, semi_cutoff, non_cutoff };

const char* to_text(CutOff cut_off); // "full cutoff"

// By the intensities from 90° and from 80° up, per 1000 lm of the lamps: 0 and 100, 25 and 100, 50 and 200.
CutOff cut_off(const HighAngles& high, Lumens lamps);

// EN 13201-2, annex A: 0 for none, else 1 to 6, the strictest that holds. By the intensities per 1000 lm of `lumens`:
// of the luminaire in the edition of 2015, of the lamps in that of 2003. Classes 4 and 5 shine nowhere above 95°, class
// 6 nowhere above 90°; up to 1 cd/klm is taken for nothing.
int luminous_intensity_class(const HighAngles& high, Lumens lumens);

// EN 13201-2, annex A: the greatest over C of I/√A at γ = 85°, with the projected area A.
struct GlareIndex {
    double cd_per_m = 0.0;
    int glare_index_class = 0; // 0 for none, else D1 to D6, the strictest that holds
};

// That of a web, whose frame the opening is in. There is none without an opening, or if it has no area at 85° where the
// luminaire shines.
Figure<GlareIndex> glare_index(const Web& web, const Opening& opening);

// DIN 5040: A direct, from 0.9 of the light downward, B from 0.6, C from 0.4, D from 0.1, E indirect.
char distribution_class(double downward_share);

} // namespace gonio
#pragma GCC visibility pop
