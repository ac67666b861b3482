// The source revision of this build.
#pragma once

namespace gonio::cli {

// "b23e719f3a50"; "b23e719f3a50+changes" if files differ from that commit; "unknown" for sources without a repository.
extern const char* const commit;

} // namespace gonio::cli
