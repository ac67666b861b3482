// What no reader refuses and no luminaire is: the check of a file against its own light.
//
// The rules are the codes WEB03… of gonio/base/codes/web.hpp. What is wrong with the text of a file is said by its
// reader, what is odd about its angles by resolve_web; neither is repeated here.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

// `web` is the profile's own, resolved with `options`. The diagnostics name the field that is odd, by
// profile.places. Costs a few integrations of the web; of types A and B the hemispheres are not looked at.
Diagnostics check_plausibility(const Profile& profile, const Web& web, const ResolveOptions& options = {});

} // namespace gonio
