// The luminaire that a room or a road is planned with.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <optional>
#include <string>

namespace gonio::cli {

inline constexpr Option luminaire_option{"--luminaire", "FILE", "the luminaire: an IES, EULUMDAT or TM-33 profile"};
inline constexpr Option flux_option{"--flux", "LUMENS", "luminous flux of each luminaire (as measured)"};

struct LuminaireInput {
    std::string file;
    std::string name;               // as the profile states it; may be empty
    LightDescription light;         // without a place
    std::string flux;               // as given; empty: as measured
    std::optional<double> input_w;  // of each luminaire
    std::optional<double> ra;       // colour rendering, as the profile states it
    double street_side_c_deg = 0.0; // in the C of the profile
};

// Reads --luminaire and --flux; it emits from where `size` says. Fails as load_profile() does, and (usage) on values of
// a wrong form and without a luminaire.
Result<LuminaireInput> luminaire_input(const Arguments& arguments, ProfileSize size, Diagnostics& diagnostics);

// The luminaire's file as a rig that is written to the file `rig` names it: below the rig's folder. Fails (usage) on
// one that is elsewhere.
Result<std::string> name_beside(const std::string& file, const std::string& rig);

} // namespace gonio::cli
