// Profiles of radiant intensity. LM-63 has tables of candela only, but some makers of ultraviolet and infrared lamps
// write mW/sr into them, and say so in a keyword. Every photometric figure of such a file is meaningless.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <string>

namespace gonio {

// The unit of the intensities if the file states one other than candela: "mW/sr" of [_INTENSITYUNITS]. "W/sr" in an
// unknown multiple is "radiometric units" ([_RADIATIONTYPE] alone). Empty for photometric files.
std::string radiometric_unit(const Profile& profile);

// Fails (unsupported, UNS0104) if there is such a unit; `hint` says how to take the numbers as candela.
Result<void> require_candela(const Profile& profile, std::string hint);

// Whether a keyword states the unit: what a table of candela must not keep.
bool states_radiometric_unit(const IesKeyword& keyword);

} // namespace gonio
