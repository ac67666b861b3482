// Of which sources this is a build.
#pragma once

namespace gonio::cli {

// "b23e719f3a50"; "b23e719f3a50+changes" where files differed from it; "unknown" of sources without a repository.
extern const char* const commit;

} // namespace gonio::cli
