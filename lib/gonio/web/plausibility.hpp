// The plausibility check: whether a file that readers accept is consistent with its own web.
//
// The rules are the codes WEB03… of gonio/base/codes/web.hpp. The reader of a file reports errors of its text, and
// resolve_web reports unusual angles; neither is repeated here.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/profile/profile.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

// `web` must be the profile's web, resolved with `options`. The diagnostics name the questionable field, by
// profile.places. Costs a few integrations of the web; for types A and B the hemispheres are not checked.
Diagnostics check_plausibility(const Profile& profile, const Web& web, const ResolveOptions& options = {});

} // namespace gonio
